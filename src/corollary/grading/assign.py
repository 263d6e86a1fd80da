"""Which variant a student gets: the first draw that is free, has a key, and on which no mistake looks like the truth."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from corollary.answers.evaluation import balls
from corollary.answers.tolerance import within
from corollary.derive.solution import Rule, Solution, once
from corollary.derive.statements import Mistake
from corollary.formula.ball import Undefined
from corollary.grading.key import Key, make_key, named
from corollary.grading.replay import WhatIf, ancestors, exchanged, letters_of, replay
from corollary.grading.rounding import MOST
from corollary.problem.sampling import draws
from corollary.problem.variant import Variant, chapter
from corollary.units.unit import show

APART = 0.005  # of the length: as much again as the least tolerance, so that a mistake rounded is not right either
ENOUGH = 300  # draws, when one was found that another student has: a grid so nearly used up is shared


class NoVariant(LookupError):
    """No draw of a problem will do; one sentence says why the last ones did not."""


@dataclass(frozen=True, slots=True)
class AssignedVariant:
    """A student's variant of one problem, and how many draws were refused before it."""

    key: Key
    redrawn: int

    @property
    def variant(self) -> Variant:
        return self.key.variant


def assign_variant(
    solution: Solution, secret: bytes, student: str, in_use: Iterable[int] = ()
) -> AssignedVariant:
    """The student's own variant; `in_use` are the indices of other students' variants. Raises NoVariant."""
    problem, occupied, reasons = solution.problem, set(in_use), list[str]()
    if all(given.grid.count == 1 for given in problem.givens):
        return AssignedVariant(make_key(solution, chapter(problem)), 0)
    fallback: AssignedVariant | None = None
    for redrawn, variant in enumerate(draws(problem, secret, student)):
        key, reason = admitted(solution, variant)
        if key is None:
            reasons.append(reason)
        elif variant.index in occupied:
            fallback = fallback or AssignedVariant(
                key, redrawn
            )  # every variant may be in use: then students share
        else:
            return AssignedVariant(key, redrawn)
        if redrawn >= ENOUGH and fallback is not None:
            return fallback
    if fallback is not None:
        return fallback
    raise NoVariant(
        f"{problem.code}: none of the draws for {student} will do; {reasons[-1] if reasons else 'its conditions leave none'}"
    )


def admitted(solution: Solution, variant: Variant) -> tuple[Key | None, str]:
    """The key of a variant that may be assigned, or None and why it may not."""
    try:
        key = make_key(solution, variant)
    except Undefined as error:
        return None, f"an answer does not exist: {error}"
    for part, truth in key.truths.items():
        if truth.noise > MOST:
            return (
                None,
                f"part {part}: honest rounding to three figures already moves the answer by {truth.noise:.1%}",
            )
        if truth.scale == 0:
            return None, f"part {part}: the answer is zero, and nothing says compared with what"
    for part, number in implausible(key):
        return None, f"part {part}: {number} is not plausible"
    for part, text in collisions(key):
        return None, f"part {part}: the mistake {text!r} cannot be told from the truth"
    return key, ""


def implausible(key: Key) -> Iterable[tuple[str, str]]:
    """Answers outside of what the part says is plausible, each as a number with its unit."""
    for part in key.variant.problem.parts:
        if part.plausible and part.id in key.truths:
            low, high = part.plausible
            for value in map(part.unit.from_si, key.truths[part.id].values):
                if not low <= value <= high:
                    yield part.id, f"{value:.4g} {show(part.unit)}".rstrip()


def collisions(key: Key) -> Iterable[tuple[str, str]]:
    """Parts on which a known mistake falls within the tolerance (and half a per cent more) of the truth.

    A mistake counts for the part of its own step, or, at a step nobody is asked about, for the parts reached from it
    through such steps only. One that never changes a part is no mistake for it.
    """
    solution = key.solution
    known = balls(key.variant.exact | named(solution, key.values))
    for each in visible_mistakes(solution):
        if each.part not in key.truths:
            continue
        truth = key.truths[each.part]
        try:
            values = exchanged(solution, known, each.place, each.mistake.rule, each.at)
        except Undefined:
            continue
        if truth.is_met_by(values, APART):
            yield each.part, each.mistake.text


@dataclass(frozen=True, slots=True)
class VisibleMistake:
    """A mistake at the step `place` that changes a part where it shows first, the part of the step `at`."""

    place: int
    mistake: Mistake[Rule]
    part: str
    at: int


@once
def visible_mistakes(solution: Solution) -> list[VisibleMistake]:
    """In the order of the steps, and of their mistakes."""
    places = {find.part: place for place, find in enumerate(solution.unknowns) if find.part}
    return [
        VisibleMistake(place, mistake, part, places[part])
        for place, find in enumerate(solution.unknowns)
        for mistake in find.mistakes
        for part in _first_asked(solution, place)
        if _differs(solution, place, mistake.rule, places[part])
    ]


def _first_asked(solution: Solution, place: int) -> list[str]:
    """The parts where a mistake at a step shows first."""
    find = solution.unknowns[place]
    if find.part:
        return [find.part]
    parts: list[str] = []
    for later, other in enumerate(solution.unknowns[place + 1 :], place + 1):
        if other.part and place in ancestors(solution, later) and _unasked_way(solution, place, later):
            parts.append(other.part)
    return parts


def _differs(solution: Solution, place: int, rule: Rule, at: int) -> bool:
    """Whether exchanging a rule changes a find at all, on the chapter's own numbers."""
    if place == at:
        return True
    try:
        givens = chapter(solution.problem).exact
        truth = replay(solution, givens, until=at)[at]
        other = replay(solution, givens, WhatIf(rules={place: rule}), at)[at]
    except Undefined:
        return False
    return not within(other, truth, 1e-9, max(map(abs, truth), default=0.0) or 1.0)


def _unasked_way(solution: Solution, start: int, end: int) -> bool:
    """Whether a way of rules leads from one find to another over finds nobody is asked about."""
    names_of: Mapping[str, int] = {
        name: place for place, find in enumerate(solution.unknowns) for name in find.names
    }
    todo, seen = [end], set[int]()
    while todo:
        place = todo.pop()
        for name in letters_of(solution.unknowns[place].local):
            above = names_of.get(name)
            if above == start:
                return True
            if above is not None and above not in seen and not solution.unknowns[above].part:
                seen.add(above)
                todo.append(above)
    return False
