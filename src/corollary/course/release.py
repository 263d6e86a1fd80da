"""Each student's own sheet on its way out: folders, archives, a mailing, or what Moodle and Canvas hand out by themselves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from corollary.course.lms_places import packed, places
from corollary.problem.csv_table import table_text
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.files import Course, students
from corollary.records.lms_names import file_words
from corollary.records.notebook_archive import read_sheet
from corollary.render.targets.feedback_zip import write_archive

UNKNOWN = {
    "moodle": "the number in Moodle is unknown; give a grading worksheet with --ids",
    "canvas": "no uploaded file in Canvas is known, and Canvas gives a file back only for an uploaded one (typed text is not a file)",
}


class NoSheets(LookupError):
    """Nobody has a sheet of this set yet; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Release:
    """The files by their names, who gets one, and who gets none, with the reason."""

    files: Mapping[str, bytes]
    students: tuple[str, ...]
    without: Mapping[str, str]


def sheets_of(course: Course, problem_set: ProblemSet) -> dict[str, bytes]:
    """The notebooks that `corollary generate` wrote, by student. Raises NoSheets."""
    found: dict[str, bytes] = {}
    for student in students(course):
        content = read_sheet(course, problem_set.name, student.id)
        if content is not None:
            found[student.id] = content
    if not found:
        raise NoSheets(
            f"nobody has a sheet of {problem_set.name} in {course.folder}; run corollary generate {problem_set.name} first"
        )
    return found


def release(course: Course, problem_set: ProblemSet, to: str, ids: Path | None = None) -> Release:
    """The files of one target, but for the exchange, which is nbgrader's. `ids` is a file in which Moodle or Canvas says by what
    numbers it knows the students. Raises NoSheets, NoPlaces, Malformed."""
    sheets, roster, name = sheets_of(course, problem_set), students(course), problem_set.name
    having = [each for each in roster if each.id in sheets]
    without = {
        each.id: f"no sheet yet; run corollary generate {name} again"
        for each in roster
        if each.id not in sheets
    }
    files: dict[str, bytes] = {}
    match to:
        case "folder":
            files = {f"{each.id}/{name}.ipynb": sheets[each.id] for each in having}
        case "zip":
            files = {
                f"{for_people(each)} - {name}.zip": write_archive({f"{name}.ipynb": sheets[each.id]})
                for each in having
            }
        case "mail":
            without |= {each.id: "the roster has no email" for each in having if not each.email}
            having = [each for each in having if each.email]
            files = mailing(problem_set, having, sheets)
        case _:
            found = places(course, name, roster, to, ids)
            without |= {each.id: UNKNOWN[to] for each in having if each.id not in found}
            having = [each for each in having if each.id in found]
            contents = {each.id: (f"{name}.ipynb", sheets[each.id]) for each in having}
            files = {f"{name}-{to}.zip": write_archive(packed(to, found, contents, having))}
    return Release(files, tuple(each.id for each in having), without)


def mailing(
    problem_set: ProblemSet, having: Sequence[Student], sheets: Mapping[str, bytes]
) -> dict[str, bytes]:
    """A notebook for each, and the table that mail programs merge from: to whom, with which file, under what subject."""
    rows = [("email", "first_name", "last_name", "id", "file", "subject")]
    files: dict[str, bytes] = {}
    for each in having:
        file = f"{for_people(each)}/{problem_set.name}.ipynb"
        files[file] = sheets[each.id]
        rows.append((each.email, each.first_name, each.last_name, each.id, file, problem_set.title))
    table = table_text(rows).replace("\n", "\r\n")
    return files | {"mail-merge.csv": table.encode("utf-8-sig")}  # the mark, for Excel


def for_people(student: Student) -> str:
    """A name of a file by which a person finds a student, in the order of last names; it begins with no sign of a formula, so
    that a table of files names it as it is."""
    names = " ".join(filter(None, (student.last_name, student.first_name))).lstrip("=@+- \t\r")
    return f"{file_words(names)} ({student.id})" if names else student.id
