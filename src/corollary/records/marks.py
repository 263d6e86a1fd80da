"""The marks of a course: the newest record of each student, merged with what persons gave, and a history that only grows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import msgspec

from corollary.atomic import write_each_whole, write_whole
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import BESIDE, Course
from corollary.records.journal import append, entries, last_lines
from corollary.records.manual import ManualMarks, journal_place, read_manual
from corollary.records.record import Record, with_manual


class NothingGraded(LookupError):
    """There are no marks yet; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class NewMarks:
    """What is written of one student's marks: the record, the feedback page, and the facts that it is made again from."""

    student: str
    record: Record
    facts: bytes
    page: str


def write_marks(course: Course, problem_set: ProblemSet, several: Sequence[NewMarks]) -> None:
    """The feedback pages and the facts on them, the history's lines and the records, in this order: a record says that
    everything before it is done.

    Cut short anywhere, `settle` and a second run leave one page, one line and one record of each.
    """
    name = problem_set.name
    facts = {page_facts_place(course, name, one.student): one.facts for one in several}
    pages = {feedback_place(course, name, one.student): one.page for one in several}
    write_each_whole({**facts, **pages})
    about = {"at": datetime.now(UTC).isoformat(timespec="seconds"), "together": len(several)}
    lines = [{"student": one.student, **about, **msgspec.to_builtins(one.record)} for one in several]
    append(_history(course, name), lines)
    write_each_whole({_place(course, name, one.student): msgspec.json.encode(one.record) for one in several})


def read_record(course: Course, problem_set: ProblemSet, student: str) -> Record | None:
    """The newest record of a student's marks; None when there is none, or it is damaged (then it is marked again)."""
    return stored_record(course, problem_set.name, student)


def stored_record(course: Course, set_name: str, student: str) -> Record | None:
    """The same, for a set of which only the name is known."""
    try:
        return msgspec.json.decode(_place(course, set_name, student).read_bytes(), type=Record)
    except (OSError, msgspec.DecodeError):
        return None


def graded_sets(course: Course) -> list[str]:
    """The names of the sets of which somebody's marks are recorded."""
    places = course.record("graded", "any").parent.glob("*/")
    return sorted(place.name for place in places)


def check_graded(course: Course, set_name: str) -> None:
    """Raises NothingGraded unless the set was graded, though nobody may have handed in: the report says that."""
    if not report_place(course, set_name).exists() and set_name not in graded_sets(course):
        raise NothingGraded(
            f"nothing of {set_name} is graded in {course.folder}; "
            f"run corollary grade {set_name} --course {course.folder} first"
        )


def read_records(course: Course, problem_set: ProblemSet, students: Iterable[str]) -> dict[str, Record]:
    """The records of those students who have one: the program's own marks."""
    found = {student: read_record(course, problem_set, student) for student in students}
    return {student: record for student, record in found.items() if record is not None}


def read_marks(
    course: Course, problem_set: ProblemSet, students: Iterable[str], manual: ManualMarks | None = None
) -> dict[str, Record]:
    """The marks as they stand, of those students who have any: the program's, merged with what persons gave.

    `manual` is what they gave; what the journal holds when left out.
    """
    given = (read_manual(course) if manual is None else manual).by_student(problem_set.name)
    found = read_records(course, problem_set, students)
    return {student: with_manual(record, given.get(student, {})) for student, record in found.items()}


def history(course: Course, set_name: str) -> Iterator[dict[str, Any]]:
    """Every mark ever given in a set, oldest first: a record as plain data, with its `student` and the moment `at`."""
    return entries(_history(course, set_name))


def settle(course: Course, problem_set: ProblemSet) -> None:
    """Completes what a run that was cut short left undone: its last lines are in the history, and their records not yet written.

    Everything else of those marks was written before their lines, so that they need not be given again.
    """
    path, newest = _history(course, problem_set.name), dict[str, Record]()
    for line in last_lines(path, _together(path)):
        try:
            newest[str(msgspec.json.decode(line)["student"])] = msgspec.json.decode(line, type=Record)
        except (msgspec.DecodeError, KeyError, TypeError):  # cut short: that mark will be given again
            continue
    for student, record in newest.items():
        if read_record(course, problem_set, student) != record:
            _write_record(course, problem_set.name, student, record)


def _together(history: Path) -> int:
    """How many marks were written together with the last one: its line says so, or the one before where it was cut short."""
    lines = last_lines(history, 2)
    for cut_short, line in enumerate(reversed(lines)):
        try:
            return int(msgspec.json.decode(line).get("together", 1)) + cut_short
        except (msgspec.DecodeError, AttributeError, TypeError, ValueError):
            continue
    return len(lines)


def feedback_place(course: Course, set_name: str, student: str) -> Path:
    """A student's feedback page: where nbgrader has it too, so that there is one."""
    return course.place("feedback", student, set_name) / f"{set_name}.html"


def last_change(course: Course, set_name: str) -> float:
    """When a mark was last given, by whomever, in seconds since 1970; 0 for never."""
    places = [_history(course, set_name), journal_place(course)]
    return max((place.stat().st_mtime for place in places if place.exists()), default=0.0)


def report_place(course: Course, set_name: str) -> Path:
    """The report's page."""
    return course.folder / "reports" / f"{set_name}.html"


def page_facts_place(course: Course, set_name: str, student: str) -> Path:
    """What a feedback page says besides the marks, from which it is made again when a person gives some."""
    return course.record("pages", f"{set_name}/{student}.json")


def write_page(course: Course, set_name: str, student: str, page: str) -> None:
    """The feedback page, and beside it what nbgrader's exchanges go by."""
    place = feedback_place(course, set_name, student)
    write_whole(place, page)
    for name in sorted(BESIDE):
        marked = course.place("autograded", student, set_name) / name
        if marked.is_file() and not (place.parent / name).exists():
            write_whole(place.parent / name, marked.read_bytes())


def _write_record(course: Course, set_name: str, student: str, record: Record) -> None:
    write_whole(_place(course, set_name, student), msgspec.json.encode(record))


def _place(course: Course, set_name: str, student: str) -> Path:
    return course.record("graded", f"{set_name}/{student}.json")


def _history(course: Course, set_name: str) -> Path:
    return course.record("history", f"{set_name}.jsonl")
