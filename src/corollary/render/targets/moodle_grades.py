"""Marks as Moodle's gradebook imports them (Grades, Import, CSV file)."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from corollary.problem.roster import Student
from corollary.problem.roster_columns import EMAILS
from corollary.records.marks_table import MarksTable
from corollary.render.exports import Target
from corollary.render.spreadsheet import table_text

ID_NUMBER, EMAIL = "ID number", "Email address"
# Ours, that of one assignment only, and those of a roster without headings.
NO_ID = re.compile(r"(id|identifier|column \d+)$", re.IGNORECASE)


def write_marks(table: MarksTable) -> str:
    """One row a student: the names, whatever Moodle can know a student by, and the marks.

    An id stands in a column only if every student has one there: for one row whose id is blank Moodle takes nothing of the
    file, and older versions gave that row's marks to the student of the row above (`gradeimport_csv_load_data`).
    """
    ids = dict(_ids(table.students))
    headings = ["First name", "Last name", *ids, *(column.title for column in table.columns)]
    rows = (
        [each.first_name, each.last_name]
        + [values[at] for values in ids.values()]
        + [table.cell(each, column) for column in table.columns]
        for at, each in enumerate(table.students)
    )
    return table_text([headings, *rows])


def _ids(students: Sequence[Student]) -> Iterator[tuple[str, list[str]]]:
    """Columns of ids that everybody has: as the roster calls them, or the id of the course as the ID number."""
    theirs = [dict(each.ids) for each in students]
    headings = dict.fromkeys(heading for ids in theirs for heading in ids if not NO_ID.match(heading))
    found = {
        heading: [ids[heading] for ids in theirs]
        for heading in headings
        if heading.lower() not in EMAILS and all(heading in ids for ids in theirs)
    }
    if not found and not all(each.id == each.email for each in students):
        found = {ID_NUMBER: [each.id for each in students]}
    yield from found.items()
    if all(each.email for each in students):
        yield EMAIL, [each.email for each in students]


TARGET = Target(ending="csv", marks=write_marks)
