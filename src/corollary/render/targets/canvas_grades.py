"""Marks as Canvas's gradebook imports them."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from corollary.messages import few
from corollary.problem.csv_table import table_text
from corollary.problem.roster import Student
from corollary.records.lms_names import CANVAS_IDS, LEFT_OUT, canvas_ids, is_left_out
from corollary.records.marks_table import MarksTable
from corollary.render.exports import MarksText, Target

NUMBER_OF_ANOTHER = re.compile(r"\s\(\d+\)\Z")


def write_marks(table: MarksTable) -> MarksText:
    """What the marks are out of in the second row, then one row a student.

    Canvas (`GradebookImporter`) refuses another order of the first columns. It finds a student by ID, else by the two others, else
    by the name, of which it takes the first that has it: so of namesakes without an id nobody is in the file. An assignment is
    found by its title; Canvas offers to make a new one for a title that it does not know.
    """
    headings = ["Student", *CANVAS_IDS, "Section", *(column.title for column in table.columns)]
    points = ["    Points Possible", "", "", "", "", *map(table.out_of, table.columns)]
    often = Counter(_sortable(each).casefold() for each in table.students)
    absent = [
        each for each in table.students if not canvas_ids(each) and often[_sortable(each).casefold()] > 1
    ]
    rows = (
        [_sortable(each), *(canvas_ids(each).get(heading, "") for heading in CANVAS_IDS), ""]
        + [table.cell(each, column) for column in table.columns]
        for each in table.students
        if each not in absent
    )
    by_name = [each.name for each in table.students if not canvas_ids(each) and each not in absent]
    overlooked = [column.title for column in table.columns if is_left_out(column.title)]
    numbered = [column.title for column in table.columns if NUMBER_OF_ANOTHER.search(column.title)]
    excused = {student for column in table.columns for student in column.excused}
    freed = [each.name for each in table.students if each.id in excused and each not in absent]
    text = table_text([headings, points, *rows])
    notes = tuple(_notes(by_name, bool(absent), overlooked, numbered, freed))
    return MarksText(text, tuple(each.id for each in absent), notes)


def _notes(
    by_name: list[str], namesakes: bool, overlooked: list[str], numbered: list[str], excused: list[str]
) -> Iterator[str]:
    if overlooked:
        yield f"{LEFT_OUT}: {few(overlooked)}; give the set another title"
    if numbered:
        yield (
            "Canvas takes a number in brackets at the end of a title for that of an assignment, which then gets the marks: "
            f"{few(numbered)}; give the set another title, or --template"
        )
    if excused:
        yield (
            f"excused, so blank; the import then deletes the marks that Canvas has of them, also EX: {few(excused)}; "
            "--template with the gradebook that Canvas exports leaves EX as it is"
        )
    if by_name:
        yield (
            f"no id of Canvas's is on the roster, so students are matched by name alone: {few(by_name)}; "
            "safer: --template with the gradebook that Canvas exports"
        )
    if namesakes:
        yield "Canvas cannot tell students of the same name apart without an id: give the gradebook that it exports with --template"


def _sortable(student: Student) -> str:
    return ", ".join(part for part in (student.last_name, student.first_name) if part) or student.id


TARGET = Target(ending="csv", marks=write_marks)
