"""`corollary extend`: a deadline of one's own, or an excuse."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from corollary.cli.ending import HOLDS, answer, refuse, say
from corollary.cli.told_dates import now
from corollary.nbgrader.written_marks import with_solutions
from corollary.problem.dates import HOW_TO_WRITE, moment, written
from corollary.problem.problem_set import ProblemSet
from corollary.records.deadlines import (
    Extension,
    all_extensions,
    read_deadlines,
    remove_extension,
    write_extension,
)
from corollary.records.files import Course, find_student, open_course
from corollary.records.marks import read_record
from corollary.records.origin import set_of
from corollary.records.settings import read_settings

Row = tuple[str, str, Extension]  # student, set, and what they have there


def run(
    student: str | None,
    name: str | None,
    date: list[str],
    course: Path,
    excuse: bool,
    remove: bool,
    listing: bool,
    as_json: bool,
    bank: Path | None = None,
) -> int:
    opened, when = open_course(course), " ".join(date)
    if sum((bool(when), excuse, remove, listing)) != 1:
        refuse(
            "give one of: a date (corollary extend ada week1 2026-12-11), --excuse, --remove, or --list to see who has what"
        )
    if listing:
        return _list(opened, student or "", name or "", as_json, bank)
    if student is None or name is None:
        refuse("name the student and the problem set, as in: corollary extend ada week1 2026-12-11")
    _, problem_set = set_of(opened, name, bank)
    who = find_student(opened, student).id
    if remove:
        found = remove_extension(opened, problem_set.name, who)
        extension = Extension()
        sentence = f"{who} has {'no longer' if found else 'neither'} an extension {'or' if found else 'nor'} an excuse in {problem_set.name}"
    else:
        extension = Extension(excused=True) if excuse else _until(opened, problem_set, when)
        _warn_of_what_is_out(opened, problem_set, who, extension)
        write_extension(opened, problem_set.name, who, extension)
        sentence = _sentence((who, problem_set.name, extension))
    if as_json:
        answer(_record((who, problem_set.name, extension)))
    else:
        print(sentence)
    if read_record(opened, problem_set, who) is not None:
        say(
            f"{who} has marks in {problem_set.name} already; corollary grade {problem_set.name} brings them up to date"
        )
    return HOLDS


def _warn_of_what_is_out(course: Course, problem_set: ProblemSet, who: str, extension: Extension) -> None:
    """Before more time is given: worked solutions that stand in feedback pages already."""
    until, name = extension.until, problem_set.name
    if until is None or until <= now():
        return
    if out := with_solutions(course, name):
        pages = "1 feedback page" if len(out) == 1 else f"{len(out)} feedback pages"
        say(
            f"warning: worked solutions of {name} stand in {pages} already, with other numbers and the same formulas: "
            f"{who} may have seen them"
            + (
                f". The next corollary grade {name} takes them out until {written(until)}, but not what was read or kept"
                if problem_set.reveal == "after extensions"
                else ""
            )
        )


def _until(course: Course, problem_set: ProblemSet, text: str) -> Extension:
    due, found = problem_set.due, moment(text, read_settings(course.folder).usual.zone)
    if found is None:
        refuse(f"{text} is not a date or time; {HOW_TO_WRITE}")
    if due is None:
        refuse(f"{problem_set.name} has no date to extend; give it one, due: 2026-12-04, in the set's file")
    if found < due:
        refuse(f"{written(found)} is before {problem_set.name} is due anyway, {written(due)}")
    return Extension(found)


def _list(course: Course, student: str, name: str, as_json: bool, bank: Path | None) -> int:
    """Who has what. One word alone may be a student or a set."""
    zone = read_settings(course.folder).usual.zone
    rows = [
        (who, set_name, Extension(extension.until and extension.until.astimezone(zone), extension.excused))
        for set_name, own in all_extensions(course).items()
        for who, extension in own.items()
        if {student, name} - {""} <= {who, set_name}
    ]
    if as_json:
        answer([_record(row) for row in rows])
        return HOLDS
    for row in rows:
        print(_sentence(row))
    if not rows:
        print("nobody has an extension or an excuse")
    for set_name in dict.fromkeys(set_name for _, set_name, _ in rows):
        due = read_deadlines(course, set_of(course, set_name, bank)[1]).due
        if due is not None:
            print(f"everybody else has until {written(due)} for {set_name}")
    return HOLDS


def _sentence(row: Row) -> str:
    who, set_name, extension = row
    if extension.excused:
        return f"{who} is excused from {set_name}"
    assert extension.until is not None
    return f"{who} has until {written(extension.until)} for {set_name}"


def _record(row: Row) -> dict[str, Any]:
    who, set_name, extension = row
    until = None if extension.until is None else extension.until.isoformat()
    return {"student": who, "set": set_name, "until": until, "excused": extension.excused}
