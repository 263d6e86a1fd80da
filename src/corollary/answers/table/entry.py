"""One entry of a table: what it is called, and the question that it answers on its own."""

from __future__ import annotations

from dataclasses import replace

from corollary.answers.question import Question
from corollary.messages import catalogue
from corollary.units.unit import Unit, show

_ = catalogue(__name__)


def units_of(question: Question) -> tuple[Unit, ...]:
    """The unit of each column."""
    return question.column_units or (question.unit,) * len(question.columns)


def heads(question: Question) -> tuple[str, ...]:
    """The labels of the columns, each with its unit."""
    return tuple(
        _("{name} in {unit}", name=name, unit=show(unit)) if show(unit) else name
        for name, unit in zip(question.columns, units_of(question), strict=True)
    )


def numbered(question: Question) -> bool:
    """Whether it is a matrix: rows and columns have numbers in place of names."""
    return all(label.isdecimal() for label in (*question.rows, *question.columns))


def entry_question(question: Question, place: int) -> Question:
    """The question for one number, at a place counted from 0, row by row."""
    asked = units_of(question)[place % len(question.columns)]
    return replace(question, unit=asked, components=(), rows=(), columns=(), column_units=())


def entry_name(question: Question, place: int) -> str:
    """`row 1, column 2` of a matrix, else the two labels."""
    row, column = divmod(place, len(question.columns))
    if numbered(question):
        return _("row {row}, column {column}", row=row + 1, column=column + 1)
    return f"{question.rows[row]}, {question.columns[column]}"
