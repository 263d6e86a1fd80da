"""Corrections of a set after it was handed out, in sentences for its instructor."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.variant import first_broken
from corollary.records.assignments import Assigned, AssignedSheet, date_corrections, words_of
from corollary.records.editions import Edition, derivation_of, fingerprint
from corollary.records.files import Course
from corollary.units.unit import canonical, show, unit


@dataclass(frozen=True, slots=True)
class Correction:
    """`sentence` is about the problem with this code when it was handed out, or the set of this name; `students` are those who
    have it so."""

    code: str
    sentence: str
    students: tuple[str, ...]


def corrections(
    course: Course, problem_set: ProblemSet, record: Assigned, sheets: dict[str, AssignedSheet]
) -> list[Correction]:
    """Everything that is not as it was handed out to somebody: the date, and then in the order of the set."""
    found = [Correction(problem_set.name, *each) for each in date_corrections(problem_set, record)]
    for place, edition in enumerate(record.editions):
        students = tuple(
            student
            for student, row in record.students.items()
            if any(numbers.edition == place for numbers in row.values())
        )
        if not students:
            continue
        today = next((each for each in problem_set.problems if each.code == edition.code_now), None)
        if today is None:
            sentence = (
                "is no longer in the set: marks given for it stay, and unmarked answers are not counted"
            )
            found.append(Correction(edition.code, sentence, students))
            continue
        found += [Correction(edition.code, each, students) for each in _sentences(course, edition, today)]
        if edition.statement != fingerprint(today):
            found += _broken(edition, today, students, sheets)
    return found


def _sentences(course: Course, edition: Edition, today: Problem) -> Iterator[str]:
    if edition.renamed.code and edition.code_now != edition.code:
        yield f"is called {edition.code_now} now: these sheets keep the old code"
    if edition.statement != fingerprint(today):
        old = words_of(course, edition)
        yield from _givens(edition, today, old)
        yield from _parts(edition, today, old)
        if old is not None and (old.statement, old.figure) != (today.statement, today.figure):
            yield "has a changed text or figure: these students keep the text and figure they were given"
    if edition.derivation != derivation_of(today):
        yield "has a corrected solution: marks follow the correction"


def _givens(edition: Edition, today: Problem, old: Problem | None) -> Iterator[str]:
    have = {given.symbol: given for given in today.givens}
    before = {edition.given_now(symbol): symbol for symbol in edition.units}
    grids = {given.symbol: given.grid for given in old.givens} if old is not None else {}
    for now, symbol in before.items():
        given = have.get(now)
        if given is None:
            yield f"the given {symbol} was removed: it stays recorded, and is not used"
            continue
        if now != symbol:
            yield f"the given {symbol} is called {now} now: it keeps the numbers of {symbol}"
        if canonical(given.unit) != edition.units[symbol]:
            same = unit(edition.units[symbol]).dimension == given.unit.dimension
            holds = "as they are" if same else "but are read in the new unit, which has another dimension"
            yield f"the given {symbol} is in {show(given.unit) or 'no unit'} now, and was in {edition.units[symbol]}: the numbers handed out stay {holds}"
        elif symbol in grids and grids[symbol] != given.grid:
            yield f"the given {symbol} is drawn from other values now: the numbers handed out stay valid"
    for symbol in have:
        if symbol not in before:
            yield f"the given {symbol} is new: these students have its printed value"


def _parts(edition: Edition, today: Problem, old: Problem | None) -> Iterator[str]:
    have = {part.id: part for part in today.parts}
    before = {edition.part_now(part.id): part for part in edition.parts}
    options = {part.id: part.options for part in old.parts} if old is not None else {}
    for now, asked in before.items():
        part = have.get(now)
        if part is None:
            yield f"part {asked.id} was removed: marks given for it stay, and unmarked answers are not counted"
            continue
        if now != asked.id:
            yield f"part {asked.id} is called {now} now: these sheets call it {asked.id}"
        if part.points != asked.points:
            yield f"part {asked.id} is worth {part.points:g} now, and was worth {asked.points:g}: marks follow the change"
        if part.answer_types != asked.types:
            yield f"part {asked.id} asks for {' and '.join(part.answer_types)} now, and asked for {' and '.join(asked.types)}: marks follow the change"
        if part.units_text != asked.unit:
            units = ", ".join(map(show, part.column_units)) or show(part.unit) or "no unit"
            yield f"part {asked.id} is asked in {units} now: a number without a unit is read in {asked.unit}"
        if options.get(asked.id, part.options) != part.options:
            yield f"part {asked.id} has other options now: a letter means the option on the student's own sheet"
    for part in today.parts:
        if part.id not in before:
            yield f"part {part.id} is new: it does not count for these students, who were not asked it"


def _broken(
    edition: Edition, today: Problem, students: tuple[str, ...], sheets: dict[str, AssignedSheet]
) -> Iterator[Correction]:
    """Numbers that could not be handed out any more."""
    broken: dict[str, list[str]] = {}
    for student in students:
        variant = sheets[student].variant(today)
        condition = first_broken(variant) if variant is not None else None
        if condition is not None:
            broken.setdefault(condition.text, []).append(student)
    for text, whose in broken.items():
        sentence = f"has numbers that violate {text}: they were handed out, so they stay valid"
        yield Correction(edition.code, sentence, tuple(whose))
