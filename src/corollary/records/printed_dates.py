"""The deadline that each student's own sheet prints: what was handed out holds, wherever the set's date is moved to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from datetime import datetime

from corollary.problem.dates import written
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course
from corollary.records.numbers import Assigned, PrintedDate, read_numbers


def printed_date(due: datetime | None) -> PrintedDate | None:
    """What is recorded of a sheet made today."""
    return None if due is None else PrintedDate(due, getattr(due.tzinfo, "key", None) or "")


def printed_dates(course: Course, problem_set: ProblemSet) -> dict[str, datetime]:
    """What the sheets print, by student; nobody whose sheet prints none, or of whom it is not known. Raises NotACourse."""
    record = read_numbers(course, problem_set.name) or Assigned([], {})
    return {student: date.when for student, date in record.dates.items() if date is not None}


def as_printed(problem_set: ProblemSet, record: Assigned, student: str) -> ProblemSet:
    """The set with the date that a student's sheet prints; with that of today where it is not known."""
    if student not in record.dates:
        return problem_set
    date = record.dates[student]
    return replace(problem_set, due=None if date is None else date.when)


def otherwise_dated(problem_set: ProblemSet, record: Assigned) -> set[str]:
    """Whose sheet prints another moment than that of today, or none."""
    return {student for student in record.students if _is_other(problem_set.due, record, student)}


def date_corrections(problem_set: ProblemSet, record: Assigned) -> Iterator[tuple[str, tuple[str, ...]]]:
    """A sentence on every date that sheets print and the set no longer has, with whose sheets these are."""
    due, whose = problem_set.due, dict[str, list[str]]()
    today = "has no date now" if due is None else f"is due {written(due)} now"
    for student in sorted(otherwise_dated(problem_set, record)):
        date = record.dates[student]
        if date is None:
            sentence = f"{today}, and their sheet prints no date: the new one holds"
        elif due is None:
            sentence = f"{today}, and their sheet prints {written(date.when)}: nobody is late any more"
        elif due.timestamp() < date.when.timestamp():
            sentence = (
                f"{today}, and their sheet prints {written(date.when)}: they have until then, "
                "as long as they are not given a new sheet (--renew)"
            )
        else:
            sentence = f"{today}, and their sheet prints {written(date.when)}: they have the longer time"
        whose.setdefault(sentence, []).append(student)
    for sentence, students in whose.items():
        yield sentence, tuple(students)


def _is_other(due: datetime | None, record: Assigned, student: str) -> bool:
    if student not in record.dates:
        return False
    date = record.dates[student]
    if due is None or date is None:
        return (due is None) != (date is None)
    return date.when.timestamp() != due.timestamp()
