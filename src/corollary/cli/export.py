"""`corollary export`: a set or its marks in another form."""

from __future__ import annotations

from pathlib import Path

from corollary.cli.ending import HOLDS, answer, refuse, say
from corollary.course.export import (
    chapters_sheet,
    owners,
    sheet_files,
    sheets_for,
    sheets_of_course,
    write_files,
)
from corollary.course.up_to_date import up_to_date
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import Worksheet
from corollary.problem.bank import open_bank
from corollary.problem.problem_set import ProblemSet, find_set
from corollary.problem.roster import read_roster
from corollary.records.files import Course, open_course, students
from corollary.records.origin import set_of
from corollary.render.exports import Target, target


def run(
    name: str,
    to: str,
    course: Path | None,
    roster: Path | None,
    bank: Path | None,
    variants: int | None,
    solution: bool,
    output: Path,
    as_json: bool,
) -> int:
    chosen = target(to)
    if sum(each is not None for each in (course, roster, variants)) > 1:
        refuse("--course, --roster and --variants each choose the numbers; give one of them")
    opened = None if course is None else open_course(course)
    place, problem_set = (
        set_of(opened, name, bank) if opened else (found := open_bank(bank), find_set(found, name))
    )
    if chosen.marks is not None:
        files = {f"{problem_set.name}.{chosen.ending}": _marks(chosen, to, opened, problem_set).encode()}
    elif chosen.worksheet is None and chosen.problem_set is None:
        refuse(f"{to} is for single exercises; write it with: corollary show CODE --format {to}")
    else:
        solutions = Solutions(place)
        sheets = _sheets(opened, roster, variants, problem_set, solutions)
        files = sheet_files(chosen, problem_set, sheets, solutions if solution else None)
    written = write_files(output, files)
    if as_json:
        answer({"set": problem_set.name, "to": to, "files": [str(path) for path in written]})
    else:
        count = len(written)
        print(f"{problem_set.title}: {count} file{'s' * (count != 1)} in {output}/")
    return HOLDS


def _marks(chosen: Target, to: str, course: Course | None, problem_set: ProblemSet) -> str:
    assert chosen.marks is not None
    if course is None:
        refuse(f"{to} holds marks; say of which course with --course")
    report = up_to_date(course, problem_set)
    if not report.handed_in:
        refuse(
            f"nothing of {problem_set.name} is graded in {course.folder}; "
            f"run corollary grade {problem_set.name} --course {course.folder} first"
        )
    return chosen.marks(problem_set, report, students(course))


def _sheets(
    course: Course | None,
    roster: Path | None,
    variants: int | None,
    problem_set: ProblemSet,
    solutions: Solutions,
) -> list[Worksheet]:
    """The course's own sheets, else new ones for a roster or for so many variants, else one with the chapter's numbers."""
    if course is not None:
        sheets = sheets_of_course(course, problem_set)
        if not sheets:
            refuse(
                f"{problem_set.name} was never generated in {course.folder}; run corollary generate {problem_set.name} first"
            )
        if without := len(students(course)) - len(sheets):
            say(
                f"{without} of the roster have no numbers yet and get no file; generate {problem_set.name} again"
            )
        return sheets
    if roster is not None:
        return sheets_for(problem_set, solutions, read_roster(roster).students)
    if variants is not None:
        return sheets_for(problem_set, solutions, tuple(owners(variants)))
    return [chapters_sheet(problem_set)]
