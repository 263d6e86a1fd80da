"""How far an honest answer may lie from the truth: the derivation replayed with steps and operations rounded to three figures."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from math import floor, isfinite, log10
from random import Random

from corollary.answers.evaluation import BITS, balls
from corollary.answers.expected import Values
from corollary.derive.solution import ClosedForms, Solution, Unknown
from corollary.formula.ball import Ball, RationalPi, Undefined, precision_of
from corollary.formula.compiled import Step, steps_in
from corollary.formula.rounded import ByHand, by_operations
from corollary.grading.replay import compute, replay

REPLAYS = 32  # with random roundings; what so few of them miss, the key's margin of a quarter is for
FIGURES = 3  # what the book asks for
GRAVITY = {Fraction("9.8"): Fraction("9.81"), Fraction("9.81"): Fraction("9.8")}
LEAST, MOST = (
    0.005,
    0.02,
)  # three figures may be half a per cent off (1.005 for 1.00); beyond 2 % mistakes look right


@dataclass(slots=True)
class Noise:
    """How far honest rounding moves a find: the distance, and each component on its own (absolute, SI).

    `by_steps` is the distance where only the answers of whole steps are rounded.
    """

    distance: float
    components: list[float]
    by_steps: float = 0.0


def noise_of(solution: Solution, givens: Mapping[str, RationalPi], values: Sequence[Values]) -> list[Noise]:
    """The largest over the replays, plus what 9.8 for 9.81 does."""
    noise, steps = _no_noise(values), _no_noise(values)
    for each_step, each_operation in _rounded_replays(solution, balls(givens)):
        _widen(steps, each_step, values)
        _widen(noise, each_step, values)
        _widen(noise, each_operation, values)
    for each, step in zip(noise, steps, strict=True):
        each.by_steps = step.distance
    if (other := GRAVITY.get(givens["g"].ratio) if "g" in givens else None) is not None:
        shifts = _no_noise(values)
        with suppress(Undefined):
            _widen(shifts, replay(solution, {**givens, "g": RationalPi(other)}), values)
        for each, shift in zip(noise, shifts, strict=True):
            each.distance += shift.distance
            each.by_steps += shift.distance
            each.components = [a + b for a, b in zip(each.components, shift.components, strict=True)]
    return noise


@dataclass(frozen=True, slots=True)
class _Step:
    """An unknown ready to be replayed: its formulas in balls and, by operations, in doubles; none where a scene gives it."""

    find: Unknown
    exact: list[Step]
    by_operations: list[ByHand]
    at: list[int]
    zero: float


def _rounded_replays(
    solution: Solution, givens: Mapping[str, Ball]
) -> Iterator[tuple[list[Values], list[Values]]]:
    """What every step gives when each before it was rounded, and what it gives when every operation was, as a pair.

    A replay in which something has no value is left out. As `replay` does it, written out: a key replays its derivation some
    thirty times, and is made for every student. What a scene gives nobody works out by hand: both have it from the steps.
    """
    letters = ["pi", *givens, *(name for find in solution.unknowns for name in find.names)]
    random = Random(1).random  # the same roundings for every variant: fair, and the same in ten years
    cached = id(solution), tuple(givens)
    if cached not in _READY:
        dice = Random()
        _READY[cached] = solution, _steps(solution, letters, lambda x: _off(dice.random, x)), dice
    _, steps, by_operation = _READY[cached]
    other = by_operation.random
    with precision_of(BITS):
        by_operation.seed(2)
        start = [Ball.pi(), *givens.values(), *(Ball(0) for _ in letters[1 + len(givens) :])]
        doubles = [float(ball) for ball in start]
        for _ in range(REPLAYS):
            known, found, written, worked = list(start), list[Values](), list(doubles), list[Values]()
            with suppress(Undefined, ValueError, ZeroDivisionError, OverflowError):
                for step in steps:
                    if step.exact:
                        exact = [float(form(known)) for form in step.exact]
                        if not all(map(isfinite, exact)):
                            break
                        answer = tuple([_off(random, x, step.zero) for x in exact])
                        by_hand = tuple(
                            [_off(other, form(written), step.zero) for form in step.by_operations]
                        )
                    else:
                        answer = by_hand = compute(step.find.local, dict(zip(letters, known, strict=True)))
                    if not all(map(isfinite, (*answer, *by_hand))):
                        break
                    for place, value, double in zip(step.at, answer, by_hand, strict=True):
                        known[place], written[place] = Ball(value), double
                    found.append(answer)
                    worked.append(by_hand)
                else:
                    yield found, worked


# By identity and the givens, of which an older sheet may have others; the solution is held, so its id stays its own. What rounds
# operations draws from one source, which every key begins anew.
_READY: dict[tuple[int, tuple[str, ...]], tuple[Solution, list[_Step], Random]] = {}


def _off(dice: Callable[[], float], x: float, zero: float = 0.0) -> float:
    return x + _half_unit(x - zero) * (-1 + 2 * dice())


def _steps(solution: Solution, letters: Sequence[str], rounded: Callable[[float], float]) -> list[_Step]:
    places = {name: place for place, name in enumerate(letters)}
    return [
        _Step(
            find,
            steps_in(trees, places),
            # Who works in °C does not write down products of kelvins: where the scale has a zero of its own, only the answer.
            [by_operations(tree, places, _as_it_is if zero else rounded) for tree in trees],
            [places[name] for name in find.names],
            zero,
        )
        for find in solution.unknowns
        for trees in [find.local.trees if isinstance(find.local, ClosedForms) else ()]
        for zero in [_zero_of_scale(solution, find)]
    ]


def _as_it_is(x: float) -> float:
    return x


def _zero_of_scale(solution: Solution, find: Unknown) -> float:
    """The zero of the unit an answer is written in: 20.4 °C are rounded as such, not as 293.55 K."""
    part = next((part for part in solution.problem.parts if part.id == find.part), None)
    return float(part.unit.offset) if part else 0.0


def _no_noise(values: Sequence[Values]) -> list[Noise]:
    return [Noise(0.0, [0.0] * len(numbers)) for numbers in values]


def _widen(noise: list[Noise], found: Sequence[Values], values: Sequence[Values]) -> None:
    for each, numbers, truth in zip(noise, found, values, strict=True):
        if len(truth) == 1:
            off = abs(numbers[0] - truth[0])
            if off > each.distance and isfinite(off):
                each.distance, each.components = off, [off]
            continue
        off = math.dist(numbers, truth)
        if isfinite(off):
            each.distance = max(each.distance, off)
            each.components = [
                max(a, abs(x - y)) for a, x, y in zip(each.components, numbers, truth, strict=True)
            ]


def _half_unit(x: float) -> float:
    """Half a unit in the last of the figures written down."""
    return 0.5 * 10.0 ** (floor(log10(abs(x))) - FIGURES + 1) if x else 0.0
