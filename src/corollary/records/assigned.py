"""Whose sheet has which numbers: as they were handed out, whatever has become of the problems since."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass

from msgspec import to_builtins

from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.variant import Variant
from corollary.records.edition import (
    Edition,
    Renamed,
    as_handed_out,
    edition_of,
    fingerprint,
    parts_gone,
    values_now,
)
from corollary.records.files import Course
from corollary.records.numbers import (
    Assigned,
    StudentNumbers,
    read_numbers,
    sets_with_numbers,
    words_of,
    write_numbers,
)
from corollary.records.renames import NotSettled, Rename, proposed, settled


@dataclass(frozen=True, slots=True)
class AssignedSheet:
    """What one student was given, as far as the set still has it: a variant of each problem, in the order of the set, or in
    that in which they were dealt where the set is shuffled.

    `removed` are the problems of which something is gone, with the parts that are. `identity` is a text that is another one
    when the numbers are, or what was asked, or what it is called; `numbers` and `names` tell the last from the others.
    """

    variants: tuple[Variant, ...]
    identity: str
    removed: tuple[Variant, ...] = ()
    numbers: str = ""
    names: str = ""

    def variant(self, problem: Problem) -> Variant | None:
        """Of a problem as the set has it today; None when it was never asked."""
        code = problem.as_written.code
        return next((each for each in self.variants if each.problem.as_written.code == code), None)


def is_assigned(course: Course, set_name: str) -> bool:
    """Whether the set was ever generated for this course."""
    return course.record("assigned", f"{set_name}.json").exists()


def read_assigned(course: Course, problem_set: ProblemSet) -> dict[str, AssignedSheet]:
    """Everybody's sheet; empty when the set was never generated. Raises NotACourse when the record is damaged, and NotSettled
    when a name may have changed since."""
    return sheets(course, problem_set, open_record(course, problem_set))


def open_record(course: Course, problem_set: ProblemSet) -> Assigned:
    """The record; an empty one where there is none. Raises NotACourse."""
    return read_numbers(course, problem_set.name) or Assigned([], {})


def save_record(course: Course, problem_set: ProblemSet, record: Assigned) -> None:
    """Writes it, with the words of the problems as they are today. Raises OSError."""
    todays = {edition_of(each, problem_set.weight(each)).statement: each for each in problem_set.problems}
    write_numbers(course, problem_set.name, record, todays)


def pending(course: Course, problem_set: ProblemSet, record: Assigned) -> list[list[Rename]]:
    """The names that look changed and that nobody has been asked about, together those of one edition."""
    known = {edition.code_now for edition in record.editions}
    todays = {each.code: fingerprint(each) for each in problem_set.problems}
    found = [
        proposed(edition, problem_set.problems, known, words_of(course, edition))
        for edition in record.in_use
        if todays.get(edition.code_now) != edition.statement
    ]
    return [renames for renames in found if renames]


def settle(record: Assigned, renames: Sequence[Rename], *, agreed: bool) -> None:
    """Takes the names of today for those of an edition, or records that they are others."""
    edition = renames[0].edition
    record.editions[record.editions.index(edition)] = settled(edition, renames, agreed=agreed)


def sheets(course: Course, problem_set: ProblemSet, record: Assigned) -> dict[str, AssignedSheet]:
    """Everybody's sheet, from the record. Raises NotSettled."""
    for renames in pending(course, problem_set, record):
        raise NotSettled(
            f"{renames[0].sentence}; corollary generate {problem_set.name} asks whether it is, and nobody is marked before"
        )
    problems = [_problem(course, problem_set, edition) for edition in record.editions]
    removed = [
        _removed(course, edition, problem) for edition, problem in zip(record.editions, problems, strict=True)
    ]
    order = {problem.code: place for place, problem in enumerate(problem_set.problems)}
    found: dict[str, AssignedSheet] = {}
    for student, row in record.students.items():
        variants = [
            _variant(problem, record.edition(numbers), numbers)
            for numbers in row.values()
            if (problem := problems[numbers.edition]) is not None
        ]
        if not problem_set.shuffled:
            variants.sort(key=lambda variant: order[variant.problem.as_written.code])
        gone = tuple(
            Variant(
                problem,
                {given.symbol: numbers.exact[given.symbol] for given in problem.givens},
                numbers.index,
            )
            for numbers in row.values()
            if (problem := removed[numbers.edition]) is not None
        )
        found[student] = AssignedSheet(
            tuple(variants),
            _identity(record, student),
            gone,
            _identity(record, student, renamed=False),
            _names(record, student),
        )
    return found


def variant_anywhere(course: Course, problem: Problem, student: str) -> Variant | None:
    """A student's numbers in a problem, whatever set they came in; None when they have none. Raises NotACourse and NotSettled."""
    found: Variant | None = None
    for name in sets_with_numbers(course):
        record = read_numbers(course, name) or Assigned([], {})
        for numbers in record.students.get(student, {}).values():
            edition = record.edition(numbers)
            if edition.code_now == problem.code:
                for rename in proposed(edition, [problem], (), words_of(course, edition)):
                    raise NotSettled(f"{rename.sentence}; corollary generate {name} asks whether it is")
                found = _variant(as_handed_out(problem, edition, words_of(course, edition)), edition, numbers)
    return found


def _problem(course: Course, problem_set: ProblemSet, edition: Edition) -> Problem | None:
    """The problem as it was handed out; None when the set no longer has it."""
    today = next((each for each in problem_set.problems if each.code == edition.code_now), None)
    if today is None:
        return None
    same = as_handed_out(today, edition, None)
    return same if same is today else as_handed_out(today, edition, words_of(course, edition))


def _removed(course: Course, edition: Edition, problem: Problem | None) -> Problem | None:
    """The problem with those parts that it was handed out with and has no longer; None when it has them all."""
    have = {part.label for part in problem.parts} if problem is not None else set[str]()
    if all(part.id in have for part in edition.parts):
        return None
    return parts_gone(edition, have, words_of(course, edition))


def _variant(problem: Problem, edition: Edition, numbers: StudentNumbers) -> Variant:
    return Variant(problem, values_now(problem, edition, numbers.exact), numbers.index)


def _identity(record: Assigned, student: str, *, renamed: bool = True) -> str:
    """The numbers, parts and units of a sheet as text; names changed since only when `renamed`."""
    row = record.students[student]
    editions = [record.edition(numbers) for numbers in row.values()]
    return json.dumps(
        [
            [
                edition.code,
                numbers.values,
                edition.units,
                [part.id for part in edition.parts],
                to_builtins(edition.renamed if renamed else Renamed()),
            ]
            for edition, numbers in zip(editions, row.values(), strict=True)
        ],
        sort_keys=True,
    )


def _names(record: Assigned, student: str) -> str:
    """What is called otherwise than on the student's sheet; empty when nothing is."""
    editions = [record.edition(numbers) for numbers in record.students[student].values()]
    found = {
        edition.code: to_builtins(edition.renamed) for edition in editions if edition.renamed != Renamed()
    }
    return json.dumps(found, sort_keys=True) if found else ""
