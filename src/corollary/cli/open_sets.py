"""Sets of a bank and of the course around it, by name; those still being worked on, whose problems nobody practises on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from pathlib import Path

from corollary.cli.ending import say
from corollary.practice.practice import Practice
from corollary.problem.bank import Bank, UnknownCode, chapter_bank
from corollary.problem.dates import in_words
from corollary.problem.diagnostic import Malformed
from corollary.problem.problem_set import ProblemSet, file_of_set, find_set, set_names
from corollary.records.assignments import read_numbers, sets_with_numbers
from corollary.records.deadlines import read_deadlines
from corollary.records.files import Course, NotACourse, open_course
from corollary.records.origin import set_of


def course_in(folder: Path | None) -> Course | None:
    """The course of a folder; None where there is none, or nothing generated yet."""
    return None if folder is None or not (folder / ".corollary" / "key").exists() else open_course(folder)


def with_sets(bank: Bank, wanted: Sequence[str], course: Course | None = None) -> list[str]:
    """What is named, with the codes of its problems in place of each set of the bank or of the course."""
    sets, words = {*set_names(bank), *(sets_with_numbers(course) if course else ())}, list[str]()
    for each in wanted:
        words += [problem.code for problem in _set(bank, each, course).problems] if each in sets else [each]
    return words


def not_to_be_practised(bank: Bank, names: Sequence[str], course: Course | None = None) -> set[str]:
    """The problems of the sets named, and of those that are not due yet: who practises on these has the answers.

    Of a set that the course has generated the course's dates hold, extensions with them. The sets of the chapter's own bank are
    samples: until a course has generated one, nobody works on it.
    """
    now = datetime.now(UTC)
    of_course = {} if course is None else _open_in(course, now)
    of_bank = {
        each.name: (each.due, _codes(each))
        for each in (find_set(bank, name) for name in set_names(bank) if not _is_a_sample(bank, name))
        if each.due and each.due > now
    }
    waiting: Mapping[str, tuple[datetime | None, set[str]]] = {**of_bank, **of_course}
    if listed := [f"{name} ({_when(due)})" for name, (due, _) in waiting.items() if name not in names]:
        say(f"left out, since not due yet: the problems of {', '.join(listed)}")
    named = [_codes(_set(bank, name, course)) for name in names]
    return set[str]().union(*named, *(codes for _, codes in waiting.values()))


def say_broken(found: Practice) -> None:
    """Say which problems of the bank nobody can practise on, and why."""
    for each in found.broken:
        say(f"left out, since it has an error: {each}")


def _is_a_sample(bank: Bank, name: str) -> bool:
    file = file_of_set(bank, name)
    return file is not None and chapter_bank().sets.resolve() in file.resolve().parents


def _set(bank: Bank, name: str, course: Course | None) -> ProblemSet:
    """The course's of this name, else the bank's. Raises UnknownCode."""
    if course is not None and name in sets_with_numbers(course):
        return set_of(course, name)[1]
    return find_set(bank, name)


def _open_in(course: Course, now: datetime) -> dict[str, tuple[datetime | None, set[str]]]:
    """Those of the course on which somebody may still work: until when the last may, and their problems. A set whose file is
    lost has no date, and is left out by its record."""
    found: dict[str, tuple[datetime | None, set[str]]] = {}
    for name in sets_with_numbers(course):
        try:
            problem_set = set_of(course, name)[1]
        except (UnknownCode, NotACourse, Malformed):
            record = read_numbers(course, name)
            found[name] = None, {edition.code_now for edition in record.editions} if record else set()
            continue
        last = read_deadlines(course, problem_set).last
        if last is not None and last > now:
            found[name] = last, _codes(problem_set)
    return found


def _when(due: datetime | None) -> str:
    return f"due {in_words(due)}" if due else "its file is lost, so its date is unknown"


def _codes(problem_set: ProblemSet) -> set[str]:
    return {problem.code for problem in problem_set.problems}
