"""A student's sheet on paper: what is asked, with the student's own numbers, and room to answer."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property

from corollary.figure.paper import VIEW
from corollary.figure.svg import alone
from corollary.messages import catalogue
from corollary.notebook.worksheet import Exercise, Prompt, SheetPlan, Worksheet
from corollary.problem.dates import in_words
from corollary.render.page import drawing
from corollary.render.paper.answer_space import answer_space
from corollary.render.paper.sheet_code import code_svg, sheet_address
from corollary.render.paper.typst_formula import literal
from corollary.render.paper.typst_text import typst_line, typst_text, words_of
from corollary.render.wording import points_earned

_ = catalogue(__name__)

PAGE, PAGES = "\ue000", "\ue001"  # where the numbers stand in "3 of 7"; letters that no language has
LETTERING = 14.0  # units of a drawing that are as high as the letters around it


@dataclass(frozen=True)
class PaperSheet:
    """A worksheet to be printed. `form` is the letter of one that is for anybody, "" for a student's own."""

    plan: SheetPlan
    form: str = ""

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
        student = self.plan.student
        return student.name if student.name == student.id else f"{student.name} ({student.id})"

    @property
    def title(self) -> str:
        return " – ".join(filter(None, (self.plan.problem_set.title, self.owner)))


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
    if sheet.student.id and not paper.form:
        names = f"#strong[{words_of(paper.owner)}]"
    else:
        name, number = words_of(_("Name:")), words_of(_("Student number:"))
        names = "" if key else f"#lines-for([{name}], [{number}])"
    address = sheet_address(sheet.problem_set.name, sheet.student, paper.form)
    form = f"[{words_of(paper.form)}]" if paper.form else "none"
    alt = _("QR code: {text}", text=address)
    return (
        f"#opening([{words_of(title)}], [{words_of(' · '.join([*due, total]))}], [{names}], {form}, "
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
