"""Changes if everybody were given today's sheet: for whom, and whose numbers could not stay."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass
from fractions import Fraction

from corollary.grading.assign import admitted
from corollary.grading.solutions import Solutions
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.variant import Variant, first_broken, index_of
from corollary.records.assignments import Assigned, AssignedSheet, Row, numbers_of, otherwise_dated
from corollary.records.editions import fingerprint
from corollary.records.files import Course
from corollary.records.submissions import submissions


@dataclass(frozen=True, slots=True)
class Renewal:
    """One student's new sheet; `other` are the codes of the problems with other numbers than before, or that are new."""

    student: str
    row: Row
    other: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Renewals:
    """`handed_in` are those whose sheet is not that of today either, and who have answered it: they keep it."""

    sheets: tuple[Renewal, ...]
    handed_in: tuple[str, ...]


def renewals(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    record: Assigned,
    sheets: dict[str, AssignedSheet],
    roster: Collection[str],
) -> Renewals:
    """For the students of these ids. Numbers stay wherever they could be drawn today. Raises NoVariant and NotDerivable."""
    prints = {each.code: _print(each) for each in problem_set.problems}
    codes = {student: _codes(course, problem_set, record, student) for student in record.students}
    dated = otherwise_dated(problem_set, record)
    outdated = [
        student
        for student, row in record.students.items()
        if student in roster
        and (
            student in dated
            or {
                (each.code, each.statement, tuple(part.id for part in each.parts))
                for each in map(record.edition, row.values())
            }
            != {(code, *prints[code]) for code in codes[student]}
        )
    ]
    answered = submissions(course, problem_set.name)
    places = {each.code: record.place(each, problem_set.weight(each)) for each in problem_set.problems}
    rows: dict[str, Row] = {student: {} for student in outdated if student not in answered}
    other: dict[str, list[str]] = {student: [] for student in rows}
    for problem in problem_set.problems:
        whose = {student: row for student, row in rows.items() if problem.code in codes[student]}
        stay = {student: _stays(solutions, problem, sheets[student]) for student in whose}
        used = {
            place
            for student, sheet in sheets.items()
            if student not in rows
            and (variant := sheet.variant(problem)) is not None
            and (place := index_of(problem, _in_units_of(problem, variant))) is not None
        } | {variant.index for variant in stay.values() if variant is not None and variant.index is not None}
        for student, row in whose.items():
            variant = stay[student]
            if variant is None:
                variant = solutions.assign_variant(problem, course.key, student, used).variant
                used |= set() if variant.index is None else {variant.index}
                other[student].append(problem.code)
            row[problem.code] = numbers_of(variant, places[problem.code])
    in_order = {student: {code: row[code] for code in codes[student]} for student, row in rows.items()}
    return Renewals(
        tuple(Renewal(student, row, tuple(other[student])) for student, row in in_order.items()),
        tuple(student for student in outdated if student in answered),
    )


def _print(problem: Problem) -> tuple[str, tuple[str, ...]]:
    """What is another when a sheet of it would be: the file, and the parts that the set asks for."""
    return fingerprint(problem), tuple(part.id for part in problem.parts)


def _codes(course: Course, problem_set: ProblemSet, record: Assigned, student: str) -> tuple[str, ...]:
    """The problems that a student has today: those they were dealt, as long as the set deals so many of each pool."""
    dealt = [record.edition(numbers).code_now for numbers in record.students[student].values()]
    if not problem_set.is_dealt(dealt):
        return tuple(problem.code for problem in problem_set.problems_of(course.key, student))
    return tuple(dealt if problem_set.shuffled else sorted(dealt, key=_order(problem_set)))


def _order(problem_set: ProblemSet) -> Callable[[str], int]:
    return [problem.code for problem in problem_set.problems].index


def _stays(solutions: Solutions, problem: Problem, sheet: AssignedSheet) -> Variant | None:
    """The student's numbers on today's grid; None when they could not be drawn any more."""
    before = sheet.variant(problem)
    if before is None or before.problem.written is None:  # never asked, or not changed since
        return before
    values = _in_units_of(problem, before)
    place = index_of(problem, values)
    variant = Variant(problem, values, place)
    if place is None or first_broken(variant) is not None:
        return None
    return variant if admitted(solutions.of(problem), variant)[0] is not None else None


def _in_units_of(problem: Problem, variant: Variant) -> dict[str, Fraction]:
    """The numbers in the units of today's givens, where that takes no pi."""
    return {
        given.symbol: (
            variant.problem.given(given.symbol).unit.to_si(variant.values[given.symbol])[0]
            - given.unit.offset
        )
        / given.unit.factor
        for given in problem.givens
    }
