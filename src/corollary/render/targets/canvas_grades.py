"""Marks as Canvas's gradebook imports them."""

from __future__ import annotations

from corollary.problem.roster import Student
from corollary.records.marks_table import MarksTable
from corollary.render.exports import Target
from corollary.render.spreadsheet import table_text

# In this order, or Canvas refuses the file (`GradebookImporter`): it finds a student by ID, else by the two others.
IDS = ("ID", "SIS User ID", "SIS Login ID")


def write_marks(table: MarksTable) -> str:
    """What the marks are out of in the second row, then one row a student.

    An assignment is found by its title; Canvas offers to make a new one for a title that it does not know.
    """
    headings = ["Student", *IDS, "Section", *(column.title for column in table.columns)]
    points = ["    Points Possible", "", "", "", "", *map(table.out_of, table.columns)]
    rows = (
        [_sortable(each), *_ids(each), "", *(table.cell(each, column) for column in table.columns)]
        for each in table.students
    )
    return table_text([headings, points, *rows])


def _ids(student: Student) -> list[str]:
    """As Canvas's own export has them, if the roster was one; the id of the course is what a student logs in with otherwise."""
    theirs = {heading.lower(): value for heading, value in student.ids}
    from_canvas = IDS[2].lower() in theirs
    numbers = [theirs.get(heading.lower(), "") if from_canvas else "" for heading in IDS[:2]]
    return [*numbers, theirs.get(IDS[2].lower(), student.id)]


def _sortable(student: Student) -> str:
    return ", ".join(part for part in (student.last_name, student.first_name) if part) or student.id


TARGET = Target(ending="csv", marks=write_marks)
