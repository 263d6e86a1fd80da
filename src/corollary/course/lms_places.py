"""Places where an LMS puts returned files: by whose number, from a file of the LMS or from the collected ones."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from corollary.problem.csv_table import read_table
from corollary.problem.roster import HEADINGS, Student
from corollary.records.files import Course
from corollary.records.lms_file import row_owners
from corollary.records.lms_names import Directory, LmsName, canvas_file, lms_name, moodle_folder
from corollary.records.submissions import read_arrivals

IDENTIFIER = "identifier"
PARTICIPANT = re.compile(r"\D+?(\d+)$")
MOODLES = "Moodle's grading worksheet or its archive of all submissions"
CANVAS = "Canvas's archive of all submissions"


class NoPlaces(ValueError):
    """Nothing says by what numbers the LMS knows the students; one sentence says which file does."""


def places(
    course: Course, set_name: str, roster: Sequence[Student], lms: str, file: Path | None
) -> dict[str, LmsName]:
    """By student, what `lms` ("moodle" or "canvas") knows the submission by: from a file that the LMS gave, else from what was
    collected; nobody of whom it has several numbers. Raises NoPlaces and Malformed."""
    directory = Directory(roster)
    if file is None:
        found = [
            (each.student, name)
            for each in read_arrivals(course, set_name)
            if each.student and (name := lms_name(each.file.split("/"))) is not None
        ]
    elif file.suffix.lower() == ".csv":
        found = list(_of_worksheet(file, directory))
    else:
        found = [(student, name) for name in _names(file) if (student := directory.of_lms(name)) is not None]
    by_student: dict[str, LmsName] = {}
    numbers: dict[str, set[str]] = {}
    for student, name in found:
        if name.lms == lms and (lms == "moodle" or name.attachment):
            by_student[student] = name
            numbers.setdefault(student, set()).add(name.number)
    # Two people of the LMS for one of ours, such as two of the same name: whose feedback it is must not be guessed.
    by_student = {student: name for student, name in by_student.items() if len(numbers[student]) == 1}
    if not by_student:
        wanted = MOODLES if lms == "moodle" else CANVAS
        hint = (
            ""
            if lms == "moodle"
            else " (Canvas gives a file back for a file only, and what is typed into its text box is none; --to mail or zip reaches all)"
        )
        where = f"{file} has none" if file else "no collected file has any"
        raise NoPlaces(
            f"{where} of the numbers {lms.capitalize()} has for the students; give {wanted} with --ids{hint}"
        )
    return by_student


def worksheet_numbers(file: Path, roster: Sequence[Student], *, by_name: bool = True) -> dict[str, str]:
    """The numbers of Moodle's grading worksheet, as "moodle 17", with the id of each student; without `by_name` only of rows that
    an id or an address names. Raises Malformed."""
    found = _of_worksheet(file, Directory(roster), by_name=by_name)
    return {f"moodle {name.number}": student for student, name in found}


def packed(
    lms: str, found: Mapping[str, LmsName], files: Mapping[str, tuple[str, bytes]], roster: Iterable[Student]
) -> dict[str, bytes]:
    """The files of an archive that the LMS gives back, by their names in it; `files` has a name and a content by student."""
    members: dict[str, bytes] = {}
    for student in roster:
        if student.id in files and student.id in found:
            name, content = files[student.id]
            theirs = found[student.id]
            path = (
                f"{moodle_folder(student, theirs.number)}/{name}"
                if lms == "moodle"
                else canvas_file(student, theirs.number, theirs.attachment, name)
            )
            members[path] = content
    return members


def _of_worksheet(file: Path, directory: Directory, *, by_name: bool = True) -> Iterable[tuple[str, LmsName]]:
    """Moodle's numbers: in the column Identifier, or in another language the first one, as a word and a number."""
    table = read_table(file, HEADINGS)
    lower = [cell.lower() for cell in table.first]
    at = lower.index(IDENTIFIER) if IDENTIFIER in lower else 0
    rows = list(enumerate(row for _, row in table.rows[1:]))
    owners = row_owners(directory, table.first, rows)
    for number, student in owners.students.items():
        if number in owners.by_name and not by_name:
            continue
        if found := PARTICIPANT.match(rows[number][1][at]):
            yield student, LmsName("moodle", "", found[1], "")


def _names(file: Path) -> Iterable[LmsName]:
    """The names in an archive, or of what lies in a folder; nothing is unpacked."""
    if file.is_dir():
        names = [str(path.relative_to(file)) for path in sorted(file.rglob("*"))]
    else:
        try:
            with zipfile.ZipFile(file) as archive:
                names = archive.namelist()
        except (zipfile.BadZipFile, OSError, ValueError) as error:
            raise NoPlaces(f"{file} cannot be opened as a zip archive ({error})") from None
    for name in names:
        parts = [part for part in name.split("/") if part]
        if parts and (found := lms_name(parts)) is not None:
            yield found
