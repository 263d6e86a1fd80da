"""The verdict on numbers: right, right from what came before, a known mistake, a slip, or wrong."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from corollary.answers.answer import Numbers
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Verdict, Wrong
from corollary.formula.ball import Undefined
from corollary.grading.closeness import coarse, same_signs, within
from corollary.grading.common_errors import slipped
from corollary.grading.follow_through import Carried, carried, size
from corollary.grading.key import Key, Truth
from corollary.grading.replay import Values, WhatIf, ancestors, replay
from corollary.problem.part import Part
from corollary.units.unit import called, show

COARSE = "Rounded too far to tell: give three significant figures."
CLOSE = "Close, but outside what rounding explains: carry four figures and round at the end."
NEAR = 0.1  # of the tolerance: a component so close is not rounded too far
UNITLESS = "The number is right, but its unit is missing; a quantity is a number *and* a unit."


def judge_numbers(key: Key, part: Part, answer: Numbers, earlier: Mapping[str, Values]) -> Verdict:
    """What a good marker says of these numbers, given the student's earlier values (SI, by part)."""
    truth = key.truths[part.id]
    if answer.in_words:
        return _in_words(key, part, replace(answer, in_words=False), earlier)
    if answer.missing:
        verdict = judge_numbers(key, part, replace(answer, missing=""), earlier)
        return Slip(UNITLESS) if isinstance(verdict, (Right, Follows)) else verdict
    if answer.misfit:
        return _misfit(answer.misfit, judge_numbers(key, part, replace(answer, misfit=""), earlier))
    if _met(answer, truth, truth.values):
        return Right()
    bases = list(carried(key, truth, earlier))
    for base in bases:
        if _met(answer, truth, base.values):
            return Follows(base.parts) if base.parts else Right()
    if few := _coarse(part, answer, truth, truth.values):
        told = few > 1 and not _also_a_mistake(key, part, truth, bases, answer)
        return Right(f"Right, but coarse: {few} figures are few; give three.") if told else Slip(COARSE)
    for base in bases:
        for wrong, said in mistakes(key, truth, base):
            if _met(answer, truth, wrong):
                return Mistaken(said, base.parts)
    for base in bases:
        if base.parts and _coarse(part, answer, truth, base.values) > 1:
            return Follows(base.parts)
    for base in _distinct(bases):
        for off, said in slipped(key, truth, base, part.unit):
            if _met(answer, truth, off):
                return Slip(said)
    return Wrong(_hint(part, answer, truth))


def mistakes(key: Key, truth: Truth, base: Carried) -> Iterator[tuple[Values, str]]:
    """What each known mistake makes of the part: at its own step, and at those before it whose values are not carried."""
    solution = key.solution
    places = sorted(ancestors(solution, truth.place) | {truth.place}, reverse=True)
    for place in places:
        if place in base.deviation.held:
            continue
        for wrong in solution.finds[place].mistakes:
            deviation = WhatIf(base.deviation.held, {**base.deviation.rules, place: wrong.rule})
            try:
                yield replay(solution, key.variant.exact, deviation, truth.place)[truth.place], wrong.text
            except Undefined:
                continue


def _in_words(key: Key, part: Part, answer: Numbers, earlier: Mapping[str, Values]) -> Verdict:
    """A sign that was given as a direction in words: where the other sign would be right, a person looks at the words."""
    verdict = judge_numbers(key, part, answer, earlier)
    if isinstance(verdict, (Right, Follows)):
        return verdict
    other = judge_numbers(
        key, part, replace(answer, values=tuple(-value for value in answer.values)), earlier
    )
    return (
        Unmarked(f"The size is right; a person will read your words on the direction: {answer.shown}.")
        if isinstance(other, (Right, Follows))
        else verdict
    )


def _misfit(why: str, verdict: Verdict) -> Verdict:
    """A wrong unit is a slip on a right number, is told by a known mistake, and settles everything else."""
    match verdict:
        case Right() | Follows():
            return Slip(f"The number is right, but not its unit: {why}.")
        case Mistaken():
            return verdict
        case _:
            return Wrong(f"{why[0].upper()}{why[1:]}.")


def _met(answer: Numbers, truth: Truth, target: Values) -> bool:
    """Within the tolerance of the target's length, every component pointing the right way."""
    return within(answer.values, target, truth.tolerance, size(target, truth)) and same_signs(
        answer.values, target, truth.doubt
    )


def _coarse(part: Part, answer: Numbers, truth: Truth, target: Values) -> int:
    own = (float(part.unit.factor) * math.pi**part.unit.pi,) * len(target)
    near = NEAR * truth.tolerance
    if answer.polar is not None:
        return _coarse_polar(answer.values, answer.polar, target, answer.sizes or own, near)
    if not all(answer.figures):
        return 0
    enough = near * size(target, truth) if len(target) > 1 else 0.0
    return coarse(answer.values, answer.figures, target, answer.sizes or own, (enough,) * len(target))


def _coarse_polar(
    values: Values, polar: tuple[Numbers, Numbers], target: Values, sizes: Sequence[float], near: float
) -> int:
    """A length's figures bound the length, and an angle's own the direction: `4.8 N at 12.45°` is coarse in its length only."""
    (x, y), (u, v) = values, target
    length, angle = polar
    turned = math.atan2(x * v - y * u, x * u + y * v)  # from the answer to the target
    wanted = math.hypot(u, v), angle.values[0] + turned
    return coarse(
        (math.hypot(x, y), angle.values[0]),
        (*length.figures, *angle.figures),
        wanted,
        (sizes[0], *angle.sizes),
        (near * wanted[0], near),
    )


def _also_a_mistake(key: Key, part: Part, truth: Truth, bases: list[Carried], answer: Numbers) -> bool:
    """Whether so few figures fit a known mistake as well."""
    return (
        any(_coarse(part, answer, truth, wrong) for wrong, _ in mistakes(key, truth, bases[0]))
        if bases
        else False
    )


def _distinct(bases: list[Carried]) -> list[Carried]:
    seen: dict[Values, Carried] = {}
    for base in bases:
        seen.setdefault(base.values, base)
    return list(seen.values())


def _hint(part: Part, answer: Numbers, truth: Truth) -> str:
    """What may be said without giving the value away."""
    kind = called(part.unit.dimension)
    if len(answer.values) == 1 and truth.values[0] and answer.values[0]:
        ratio = abs(answer.values[0] / truth.values[0])
        if ratio > 100 or ratio < 0.01:
            return f"The size cannot be right for {kind} here: look at powers of ten and units."
        if answer.values[0] * truth.values[0] < 0:
            return "Neither the sign nor the size fits."
        if abs(ratio - 1) < 0.05:
            return CLOSE
    if len(answer.values) > 1:
        right = [
            name
            for name, x, wanted in zip(part.components, answer.values, truth.values, strict=True)
            if abs(x - wanted) <= truth.tolerance * truth.scale
        ]
        if len(right) == len(answer.values):
            return CLOSE
        if right:
            one, others = len(right) == 1, "others" if len(answer.values) - len(right) > 1 else "other"
            fit = (
                f"Component {right[0]} fits"
                if one
                else f"Components {', '.join(right[:-1])} and {right[-1]} fit"
            )
            return f"{fit}; look at the {others} again."
    return f"Read as {kind}{f' in {show(part.unit)}' if show(part.unit) else ''}; it does not follow from the numbers given."
