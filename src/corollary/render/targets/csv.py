"""Marks as a table with nbgrader's columns of who a student is."""

from __future__ import annotations

from corollary.problem.csv_table import table_text
from corollary.problem.roster import COLUMNS
from corollary.records.marks_table import MarksTable
from corollary.render.exports import Target


def write_marks(table: MarksTable) -> str:
    """One row a student. Blank where there is no mark: nothing handed in, a part that was not asked or waits for a person, or
    an excuse; none of these is a zero."""
    headings = [*COLUMNS, *(column.title for column in table.columns)]
    rows = (
        [each.id, each.first_name, each.last_name, each.email]
        + [table.cell(each, column) for column in table.columns]
        for each in table.students
    )
    return table_text([headings, *rows])


TARGET = Target(ending="csv", marks=write_marks, every_column=True)
