"""Changes of a set that is out: of the sheets that students would get today, and of the roster."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path

from corollary.grading.assign import admitted
from corollary.grading.solutions import Solutions
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import TWINS, Student
from corollary.problem.variant import Variant, first_broken, index_of
from corollary.records.assignments import (
    Assigned,
    AssignedSheet,
    Row,
    held_codes,
    numbers_of,
    otherwise_dated,
)
from corollary.records.editions import fingerprint
from corollary.records.files import Course, open_course, students
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
        others = held_codes(record, but={student})
        return tuple(problem.code for problem in problem_set.deal(course.key, [student], others)[student])
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


class OneFolder(ValueError):
    """Two ids that many disks take for one; a sentence says which."""


@dataclass(frozen=True, slots=True)
class RosterChange:
    """The course's roster and a new file held together. `missing` are those of the course whom the file does not have, each
    with the id that somebody of the same email or name has there (or ""); `roster` is what it becomes, without them."""

    roster: tuple[Student, ...]
    new: tuple[Student, ...]
    missing: tuple[tuple[Student, str], ...]


def students_before(folder: Path) -> tuple[Student, ...]:
    """Who is on the course's roster already; nobody when there is no course yet. Raises NotACourse."""
    if not (folder / ".corollary" / "roster.csv").exists():
        return ()
    return students(open_course(folder))


def roster_change(before: Sequence[Student], file: Sequence[Student]) -> RosterChange:
    """What a file changes. One in which nobody of the course stands is a list of newcomers, and takes nobody away.

    Raises OneFolder.
    """
    old, found = {each.id: each for each in before}, {each.id: each for each in file}
    new = tuple(each for each in file if each.id not in old)
    lower = {each.lower(): each for each in old}
    for each in new:
        if twin := lower.get(each.id.lower()):
            raise OneFolder(f"id {each.id} and {twin}, who is in the course, {TWINS}")
    if not old.keys() & found.keys():
        return RosterChange((*before, *new), new, ())
    stay = [_renewed(each, found[each.id]) for each in before if each.id in found]
    missing = tuple((each, _same_person(each, new)) for each in before if each.id not in found)
    return RosterChange((*stay, *new), new, missing)


def check_folders(roster: Iterable[Student], set_name: str) -> None:
    """Raises OneFolder where a student's folder would be the set's: nbgrader has the chapter's sheet in release/SET, and
    gives all that lies there to everybody."""
    for each in roster:
        if each.id.lower() == set_name.lower():
            raise OneFolder(
                f"id {each.id} is the name of the set too, and release/{each.id}/ would hold the sheets of both; "
                "give the set's file another name, or take other ids with --id-column"
            )


def _renewed(old: Student, now: Student) -> Student:
    """What the file says, and where it says nothing what was known."""
    return replace(
        now,
        first_name=now.first_name or old.first_name,
        last_name=now.last_name or old.last_name,
        email=now.email or old.email,
        ids=tuple((dict(old.ids) | dict(now.ids)).items()),
    )


def _same_person(student: Student, new: Sequence[Student]) -> str:
    """The id of a newcomer with this student's email or name: most likely it is the id that changed."""
    for each in new:
        if (student.email and each.email.lower() == student.email.lower()) or (
            student.last_name and each.name.lower() == student.name.lower()
        ):
            return each.id
    return ""
