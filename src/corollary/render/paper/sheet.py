"""A student's sheet on paper: what is asked, room to answer, and the code by which the sheet is known again."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Final
from urllib.parse import quote

from corollary.answers.answer_type import AnswerType
from corollary.answers.table.entry import numbered, units_of
from corollary.figure.svg import VIEW, alone
from corollary.formula.latex import letter
from corollary.messages import catalogue
from corollary.notebook.worksheet import Exercise, Prompt, SheetPlan, Worksheet
from corollary.problem.dates import in_words
from corollary.problem.roster import Student
from corollary.render.page import drawing
from corollary.render.paper.typst import (
    literal,
    typesetter,
    typst_formula,
    typst_line,
    typst_text,
    without_font,
    words_of,
)
from corollary.render.wording import points_earned
from corollary.units.unit import show

_ = catalogue(__name__)


def sheet_address(set_name: str, owner: Student, form: str) -> str:
    """What the code says: `corollary:momentum_1?student=ada`, or `?form=A`; the set alone for a sheet that is nobody's."""
    if form:
        return f"corollary:{quote(set_name)}?form={quote(form)}"
    return f"corollary:{quote(set_name)}" + (f"?student={quote(owner.id, safe='@')}" if owner.id else "")


@lru_cache(maxsize=1)  # the sheet's and its marking scheme's
def code_svg(address: str) -> str:
    """The QR code as an SVG drawing, with a quiet border. Raises CannotTypeset without the extra `pdf`."""
    out = io.BytesIO()
    typesetter("segno").make(address, error="m", micro=False).save(
        out, kind="svg", xmldecl=False, border=2, omitsize=True
    )
    return out.getvalue().decode()


WORKING: Final = 5
"""Room for working above an answer, in the size of the letters; a point more gives half as much again, up to three times."""
NUMBER, COMPONENT, FORMULA = "9em", "6em", "22em"
LINES, LINES_A_POINT, MOST_LINES, PROGRAM_LINES = 4, 2, 20, 20
FIGURE_HEIGHT = "9cm"


def answer_space(prompt: Prompt) -> str:
    """The room for the answer to one part, in Typst's markup."""
    if prompt.options:
        each = (f"([{words_of(option.mark)}], [{typst_line(option.text)}])" for option in prompt.options)
        return f"#options({', '.join(each)},)"
    return "\n\n".join(_room(prompt, each) for each in prompt.answer_types)


def _room(prompt: Prompt, each: AnswerType) -> str:
    if each.found_in == "function":
        note = _("Write the program by hand: a function {signature}.", signature=f"`{prompt.part.signature}`")
        return f"#note[{typst_line(note)}]\n\n#ruled({PROGRAM_LINES})"
    if each.found_in == "figure":
        note = _("Sketch the figure by hand; name both axes, each with its unit.")
        return f"#note[{typst_line(note)}]\n\n#squared({FIGURE_HEIGHT})"
    if each.found_in == "cell" or each.in_lines:
        return f"#ruled({min(MOST_LINES, LINES + round(LINES_A_POINT * prompt.out_of))})"
    fields = f"#answers({_working(prompt)}, {', '.join(_fields(prompt, each))})"
    if each.shows_letters:
        return fields
    return f"#note[{typst_line(each.heading(prompt.question))}]\n\n{fields}"  # the words to choose from


def _working(prompt: Prompt) -> str:
    return f"{WORKING * min(3.0, 0.5 + 0.5 * max(1.0, prompt.out_of)):g}em"


def _fields(prompt: Prompt, each: AnswerType) -> Iterator[str]:
    unit = literal(show(prompt.part.unit))
    if prompt.part.rows:
        yield _entries(prompt)
        return
    # An interval, or a list in any order, is written as one.
    if not prompt.part.components or not each.lists_components:
        width = FORMULA if each.in_symbols or prompt.part.components else NUMBER
        label = words_of(_("Answer:"))
        yield f"field([{label}], {literal('') if each.in_symbols else unit}, {width})"
        return
    for name in prompt.part.components:
        symbol = f"{typst_formula(letter(name))}{words_of(' =')}"
        yield f"field([{symbol}], {unit}, {COMPONENT})"


def _entries(prompt: Prompt) -> str:
    """An empty table, each column with its unit; without labels where rows and columns have but numbers."""
    part, question = prompt.part, prompt.question
    if numbered(question):
        note = words_of(show(part.unit))
        cells = ["entry"] * len(part.components)
        return f"stack(dir: ltr, spacing: 0.5em, entries({len(part.columns)}, {', '.join(cells)}), [{note}])"
    heads = [
        f"[{typst_line(name)}" + (f" [{words_of(show(unit))}]]" if show(unit) else "]")
        for name, unit in zip(part.columns, units_of(question), strict=True)
    ]
    cells = ["[]", *heads]
    for row in part.rows:
        cells += [f"[{typst_line(row)}]", *["entry"] * len(part.columns)]
    return f"entries({len(part.columns) + 1}, {', '.join(cells)})"


PAGE, PAGES = "\ue000", "\ue001"  # where the numbers stand in "3 of 7"; letters that no language has
LETTERING = 14.0  # units of a drawing that are as high as the letters around it


@dataclass(frozen=True)
class PaperSheet:
    """A worksheet to be printed. `form` is the letter of one that is for anybody, "" for a student's own."""

    plan: SheetPlan
    form: str = ""
    label: str = ""  # in the place of a name that no font here has

    @cached_property
    def worksheet(self) -> Worksheet:
        """Made where it is printed: of a class that is on several cores. Raises Malformed."""
        return self.plan.worksheet()

    @property
    def mark(self) -> str:
        """What names it in file names and labels: the form, or the student's id; "" when it is nobody's."""
        return self.form or self.plan.student.id

    @property
    def owner(self) -> str:
        """Whose it is, in words."""
        if self.form:
            return _("Form {form}", form=self.form)
        return self.label or self.plan.student.name_with_id

    @property
    def title(self) -> str:
        return " – ".join(filter(None, (self.plan.problem_set.title, self.owner)))


def with_printable_names(sheets: Sequence[PaperSheet]) -> tuple[list[PaperSheet], list[Student]]:
    """The sheets, with the id in the place of each name that no font here can print, and whose names these are.

    Raises CannotTypeset without the extra `pdf`."""
    printable, students = list[PaperSheet](), list[Student]()
    missing = without_font(text for each in sheets for text in (each.owner, each.plan.student.id))
    for sheet in sheets:
        if sheet.owner in missing:
            student = sheet.plan.student
            students.append(student)
            sheet = replace(sheet, label=quote(student.id) if student.id in missing else student.id)
        printable.append(sheet)
    return printable, students


def typst_sheet(paper: PaperSheet, formulas: str = "") -> str:
    """The sheet in Typst's markup; `formulas` is the formula sheet to end it with. Raises CannotTypeset."""
    about = paper.worksheet.problem_set
    pieces = [typst_opening(paper, about.title), typst_text(about.introduction)]
    pieces += map(_exercise, paper.worksheet.exercises)
    return typst_pages(paper, "sheet", "\n\n".join(filter(None, (*pieces, formulas))))


def typst_pages(paper: PaperSheet, kind: str, body: str) -> str:
    """The pages of one sheet, or of its marking scheme."""
    return numbered_pages(f"{kind}-{paper.mark}", paper.title, body)


def numbered_pages(mark: str, title: str, body: str) -> str:
    """Pages that are counted by themselves, "3 of 7"; the title stands above all but the first. No two of a file share a mark."""
    before, between, after = re.split(f"[{PAGE}{PAGES}]", _("{page} of {pages}", page=PAGE, pages=PAGES))
    of = f"({literal(before)}, {literal(between)}, {literal(after)})"
    return f"#sheet({literal(mark)}, [{words_of(title)}], {of})[\n{body}\n]"


def typst_opening(paper: PaperSheet, title: str, *, key: bool = False) -> str:
    """What stands above the first exercise; on a sheet for anybody lines for name and number, on a key none."""
    sheet = paper.worksheet
    total = points_earned(sum(prompt.out_of for prompt in sheet.prompts))
    due = [_("due {date}", date=in_words(sheet.problem_set.due))] if sheet.problem_set.due and not key else []
    rule = [sheet.problem_set.late_rule] if sheet.problem_set.late_rule and not key else []
    if sheet.student.id and not paper.form:
        names = f"#strong[{words_of(paper.owner)}]"
    else:
        name, number = words_of(_("Name:")), words_of(_("Student number:"))
        names = "" if key else f"#lines-for([{name}], [{number}])"
    address = sheet_address(sheet.problem_set.name, sheet.student, paper.form)
    form = f"[{words_of(paper.form)}]" if paper.form else "none"
    alt = _("QR code: {text}", text=address)
    return (
        f"#opening([{words_of(title)}], [{words_of(' · '.join([*due, total, *rule]))}], [{names}], {form}, "
        f"{literal(code_svg(address))}, {literal(alt)})"
    )


def typst_figure(exercise: Exercise) -> str:
    """The exercise's figure in the size in which its letters are as large as the text's; narrower where the page is. Nothing
    where there is none."""
    if not exercise.figure:
        return ""
    svg = alone(str(drawing(exercise)))
    view = VIEW.search(svg)
    width = f"{float(view[3]) / LETTERING:.4g}em" if view else "30em"
    return f"#figure-of({literal(svg)}, {literal(exercise.figure_alt)}, {width})"


def typst_exercise(exercise: Exercise, *, room: bool = True, level: int = 3) -> str:
    """The statement, the figure, and the parts under headings of this level, with room to answer unless the answers stand there."""
    parts = (_part(prompt, room, level) for prompt in exercise.prompts)
    return "\n\n".join(filter(None, (typst_text(exercise.statement), typst_figure(exercise), *parts)))


def _exercise(exercise: Exercise) -> str:
    problem = exercise.problem
    total = points_earned(sum(prompt.out_of for prompt in exercise.prompts))
    title = words_of(f"{problem.code} {problem.title}")
    return f"#exercise([{title}], [{words_of(total)}])\n\n{typst_exercise(exercise)}"


def _part(prompt: Prompt, room: bool, level: int) -> str:
    title = words_of(f"({prompt.part.heading_letter}) ") + typst_line(prompt.part.title)
    heading = f"#part([{title}], [{words_of(points_earned(prompt.out_of))}], level: {level})"
    space = answer_space(prompt) if room or prompt.options else ""
    asked = "\n\n".join(filter(None, (heading, typst_text(prompt.text))))
    return f"#asked[{asked}]\n\n{space}" if "#ruled" in space else f"#together[{asked}\n\n{space}]"
