"""Assignment of a variant to a student: the first draw that is free, has a key, and hides no mistake."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from itertools import islice, product

from corollary.answers.choice.option_text import alike
from corollary.answers.evaluation import balls
from corollary.answers.expected import Values
from corollary.answers.questions import question_in
from corollary.answers.registry import answer_type
from corollary.answers.spellings import spelled_alike
from corollary.answers.tolerance import within
from corollary.derive.solution import Rule, Solution, once
from corollary.derive.statements import Mistake
from corollary.formula.ball import RationalPi, Undefined, holds
from corollary.grading.key import Key, make_key, named
from corollary.grading.replay import WhatIf, ancestors, exchanged, letters_of, replay
from corollary.grading.rounding import MOST_TOLERANCE
from corollary.problem.part import Part
from corollary.problem.sampling import draws, sample
from corollary.problem.variant import Variant, chapter, first_broken
from corollary.units.unit import show

APART = 0.005  # of the length: as much again as the least tolerance, so that a mistake rounded is not right either
SAME = 1e-9  # relative: doubles of one value by two ways
TRIED = (
    40  # draws besides the printed numbers: a mistake that shows on a tenth of them is missed once in seventy
)
CORNERS = 64  # of the grid, tried besides
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
        same = next(options_alike(variant), None)
    except Undefined as error:
        return None, f"an answer does not exist: {error}"
    for part, truth in key.truths.items():
        if truth.noise > max(MOST_TOLERANCE, variant.problem.part(part).tolerance):
            return (
                None,
                f"part {part}: honest rounding to three figures already moves the answer by {truth.noise:.1%}",
            )
        if truth.scale == 0 and not truth.counted:
            return None, f"part {part}: the answer is zero, and nothing says compared with what"
    if same is not None:
        part, one, other = same
        return None, f"part {part}: options {one} and {other} print alike"
    for part, number in not_whole(key):
        return None, f"part {part}: {number} is no whole number, and a count is asked for"
    for part, number in implausible(key):
        return None, f"part {part}: {number} is not plausible"
    for part, text in collisions(key):
        return None, f"part {part}: the mistake {text!r} cannot be told from the truth"
    return key, ""


def options_alike(variant: Variant, parts: Iterable[Part] | None = None) -> Iterator[tuple[str, str, str]]:
    """The parts with two options that print alike with these numbers, and the marks of these options. Raises Undefined where an
    option has no value."""
    for part in variant.problem.parts if parts is None else parts:
        if not part.options:
            continue
        question = question_in(variant, part)
        texts = dict(zip(question.options, question.option_texts, strict=True))
        if found := alike(texts) if answer_type(part.answer_type).shows_letters else spelled_alike(texts):
            one, other = found
            yield part.id, one.upper(), other.upper()


def not_whole(key: Key) -> Iterable[tuple[str, str]]:
    """Answers to parts that ask for a count, and come to none."""
    for part in key.variant.problem.parts:
        if part.answer_type == "count" and part.id in key.truths:
            (value,) = key.truths[part.id].values
            if not math.isclose(value, round(value), rel_tol=SAME):
                yield part.id, f"{value:.6g}"


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


def hidden_mistakes(solution: Solution) -> Iterator[tuple[int, Mistake[Rule], list[str]]]:
    """Mistakes that change no part, each with the place of its step and the parts where it would show first: no number is kept
    from being dealt for them."""
    visible = {(each.place, each.mistake.line, each.mistake.text) for each in visible_mistakes(solution)}
    for place, find in enumerate(solution.unknowns):
        for mistake in find.mistakes:
            if (place, mistake.line, mistake.text) not in visible:
                yield place, mistake, _first_asked(solution, place)


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
    """Whether exchanging a rule changes a find for some numbers: the printed ones, where it may coincide, or those of other draws."""
    return place == at or any(
        _differs_for(solution, givens, place, rule, at) for givens in numbers_tried(solution)
    )


def numbers_tried(solution: Solution) -> Iterator[Mapping[str, RationalPi]]:
    """The printed numbers first, which mostly decide; of a case, only numbers for which it holds."""
    own = chapter(solution.problem).exact
    if _in_case(solution, own):
        yield own
    yield from _other_numbers(solution)


@once
def _other_numbers(solution: Solution) -> list[dict[str, RationalPi]]:
    """Draws, then corners of the grid, where a mistake of a small effect shows most."""
    problem = solution.problem
    found = sample(problem, TRIED * (5 if solution.conditions else 1), salt="mistakes")
    fitting = [each.exact for each in found if _in_case(solution, each.exact)][:TRIED]
    ends = [(0, given.grid.count - 1) if given.grid.count > 1 else (0,) for given in problem.givens]
    for places in islice(product(*ends), CORNERS):
        values = {given.symbol: given.grid[at] for given, at in zip(problem.givens, places, strict=True)}
        variant = Variant(problem, values, None)
        if first_broken(variant) is None and _in_case(solution, variant.exact):
            fitting.append(variant.exact)
    return fitting


def _in_case(solution: Solution, givens: Mapping[str, RationalPi]) -> bool:
    try:
        return all(holds(each, givens) for each in solution.conditions)
    except Undefined:
        return False


def _differs_for(
    solution: Solution, givens: Mapping[str, RationalPi], place: int, rule: Rule, at: int
) -> bool:
    try:
        truth = replay(solution, givens, until=at)[at]
        other = replay(solution, givens, WhatIf(rules={place: rule}), at)[at]
    except Undefined:
        return False
    if not solution.problem.part(solution.unknowns[at].part).rows:
        return not _alike(other, truth)
    return not all(_alike((mine,), (theirs,)) for mine, theirs in zip(other, truth, strict=True))


def _alike(values: Values, truth: Values) -> bool:
    return within(values, truth, SAME, max(map(abs, truth), default=0.0) or 1.0)


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
