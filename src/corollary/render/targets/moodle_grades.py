"""Marks as Moodle's gradebook imports them (Grades, Import, CSV file)."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from corollary.messages import few
from corollary.problem.csv_table import table_text
from corollary.problem.roster import EMAILS, ID_NUMBERS, USERNAMES, Student, folder_name
from corollary.records.lms_names import canvas_ids
from corollary.records.marks_table import MarksTable
from corollary.render.exports import MarksText, Target

EMAIL, OURS = "Email address", "id"
MOST = 100  # `gradepointmax`, which counts where `unlimitedgrades` is on only
MARK = re.compile(r"\d+(\.\d+)?$")
NO_HEADING = "column "  # of rosters without headings
# The number of a participant is that of one assignment.
OF_NO_USER = re.compile(rf"({OURS}|identifier|{NO_HEADING}\d+)$")


@dataclass(frozen=True, slots=True)
class IdColumn:
    """What Moodle may know students by; `values` by student, of those who have one of their own."""

    heading: str
    values: Mapping[str, str]


def write_marks(table: MarksTable) -> MarksText:
    """One row a student: the names, whatever Moodle can know a student by, and the marks.

    Moodle finds all rows by one column. One whose id is blank (or 0) makes it refuse the file, and older versions gave that row's
    marks to the student of the row above (`gradeimport_csv_load_data`). So a column of ids is written only if everybody has one
    there; where there is no such column, the one that most have, and nobody else's marks.
    """
    columns = _id_columns(table.students)
    full = [each for each in columns if len(each.values) == len(table.students)]
    in_file, absent = table.students, tuple[Student, ...]()
    if not full:
        best = max(columns, key=lambda each: len(each.values))
        in_file = tuple(each for each in table.students if each.id in best.values)
        absent = tuple(each for each in table.students if each.id not in best.values)
        full = [each for each in columns if all(student.id in each.values for student in in_file)]
    ids = [each for each in full if each.heading != OURS] or full
    if all(each.heading == EMAIL for each in ids):  # the id of the course stands beside an address
        ids = [*(each for each in full if each.heading == OURS), *ids]
    headings = [
        "First name",
        "Last name",
        *(each.heading for each in ids),
        *(each.title for each in table.columns),
    ]
    rows = (
        [each.first_name, each.last_name]
        + [column.values[each.id] for column in ids]
        + [table.cell(each, column) for column in table.columns]
        for each in in_file
    )
    text = table_text([headings, *rows])
    notes = (*_notes(table.students, columns, ids, absent), *_on_size(table))
    return MarksText(text, tuple(each.id for each in absent), notes)


def _on_size(table: MarksTable) -> Iterator[str]:
    written = (table.cell(each, column) for each in table.students for column in table.columns)
    if any(MARK.match(text) and float(text) > MOST for text in written):
        out_of = table.notation.out_of
        why = (
            f"--out-of {MOST} scales them"
            if out_of is None or out_of > MOST
            else f"some are more than all of {out_of:g}, for extra credit"
        )
        yield f"Moodle takes no file with a mark above {MOST}, unless its administrator allows more; {why}"
    elif any(mark.points > mark.out_of + 1e-9 for column in table.columns for mark in column.marks.values()):
        yield (
            "some marks are more than all, for extra credit; where an assignment is out of less than a mark, "
            "Moodle 4.5 takes no file, and older versions cut the mark off"
        )


def _notes(
    students: Sequence[Student],
    columns: Sequence[IdColumn],
    used: Sequence[IdColumn],
    absent: Sequence[Student],
) -> Iterator[str]:
    """By what Moodle is to find the students, and whom it could not."""
    named = " or ".join(each.heading for each in used)
    yield f'each row has {named}; choose {"it" if len(used) == 1 else "one of them"} under "Map from" in Moodle'
    if absent:
        yield f"no id column covers every student; without {used[0].heading} on the roster: {few([each.id for each in absent])}"
        return
    for each in columns:
        if each not in used and each.values and each.heading != OURS:
            without = [student.id for student in students if student.id not in each.values]
            if without:
                yield f"{each.heading} is left out, since these students have none or share one: {few(without)}"


def _id_columns(students: Sequence[Student]) -> list[IdColumn]:
    """Those of the roster, by what its headings mean, then the addresses, then the ids of the course as the roster had them."""
    found: dict[str, dict[str, str]] = {}
    headings: dict[str, str] = {}
    ours = {each.id: given for each in students if (given := _as_given(each))}
    for each in students:
        for heading, value in each.ids:
            lower = heading.lower()
            if lower not in EMAILS and not OF_NO_USER.match(lower):
                kind = next((kind for kind in (ID_NUMBERS, USERNAMES) if lower in kind), (lower,))[0]
                found.setdefault(kind, {})[each.id] = value
                headings.setdefault(kind, heading)
    columns = [IdColumn(headings[kind], _distinct(values)) for kind, values in found.items()]
    emails = {each.id: each.email for each in students if each.email}
    own = {student: given for student, given in ours.items() if given != emails.get(student)}
    return [*columns, IdColumn(EMAIL, _distinct(emails)), IdColumn(OURS, _distinct(own))]


def _as_given(student: Student) -> str:
    """The id that the roster had for a student of the course, before it became a folder's name; Canvas's own is not Moodle's."""
    if not student.ids:
        return student.id
    own = canvas_ids(student)
    unnamed = [
        value
        for heading, value in student.ids
        if (heading.lower() == OURS or heading.startswith(NO_HEADING)) and heading not in own
    ]
    return next((value for value in unnamed if folder_name(value) == student.id), "".join(unnamed[:1]))


def _distinct(values: Mapping[str, str]) -> dict[str, str]:
    """Those by which one student alone can be found; PHP takes 0 for a blank."""
    often = Counter(value.casefold() for value in values.values())
    return {
        who: value for who, value in values.items() if value not in ("", "0") and often[value.casefold()] == 1
    }


TARGET = Target(ending="csv", marks=write_marks)
