"""Where a student writes on paper: boxes to tick, fields with their units, ruled lines, squared paper, each by what is asked."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

from corollary.answers.answer_type import AnswerType
from corollary.answers.table.entry import numbered, units_of
from corollary.formula.latex import letter
from corollary.messages import catalogue
from corollary.notebook.worksheet import Prompt
from corollary.render.paper.typst_formula import literal, typst_formula
from corollary.render.paper.typst_text import typst_line, words_of
from corollary.units.unit import show

_ = catalogue(__name__)

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
