"""How far an honest answer may lie from the truth: the derivation replayed with every step rounded to three figures."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from math import floor, isfinite, log10
from random import Random

from corollary.answers.evaluation import BITS, balls
from corollary.answers.expected import Values
from corollary.derive.solution import ClosedForms, Solution, Unknown
from corollary.formula.ball import Ball, RationalPi, Undefined, precision_of
from corollary.formula.compiled import steps_in
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
    """How far honest rounding moves a find: the distance, and each component on its own (absolute, SI)."""

    distance: float
    components: list[float]


def noise_of(solution: Solution, givens: Mapping[str, RationalPi], values: Sequence[Values]) -> list[Noise]:
    """The largest over the replays, plus what 9.8 for 9.81 does."""
    noise = _no_noise(values)
    for found in _rounded_replays(solution, balls(givens)):
        _widen(noise, found, values)
    if (other := GRAVITY.get(givens["g"].ratio) if "g" in givens else None) is not None:
        shifts = _no_noise(values)
        with suppress(Undefined):
            _widen(shifts, replay(solution, {**givens, "g": RationalPi(other)}), values)
        for each, shift in zip(noise, shifts, strict=True):
            each.distance += shift.distance
            each.components = [a + b for a, b in zip(each.components, shift.components, strict=True)]
    return noise


def _rounded_replays(solution: Solution, givens: Mapping[str, Ball]) -> Iterator[list[Values]]:
    """What every step gives when each before it was rounded; a replay in which something has no value is left out.

    As `replay` does it, written out: a key replays its derivation some thirty times, and is made for every student.
    """
    letters = ["pi", *givens, *(name for find in solution.unknowns for name in find.names)]
    places = {name: place for place, name in enumerate(letters)}
    steps = [
        (
            find,
            steps_in(find.local.trees, places) if isinstance(find.local, ClosedForms) else None,
            [places[name] for name in find.names],
            _zero_of_scale(solution, find),
        )
        for find in solution.unknowns
    ]
    random = Random(1).random  # the same roundings for every variant: fair, and the same in ten years
    with precision_of(BITS):
        start = [Ball.pi(), *givens.values(), *(Ball(0) for _ in letters[1 + len(givens) :])]
        for _ in range(REPLAYS):
            known, found = list(start), list[Values]()
            with suppress(Undefined):
                for find, forms, at, zero in steps:
                    if forms is None:
                        answer = compute(find.local, dict(zip(letters, known, strict=True)))
                    else:
                        exact = [float(form(known)) for form in forms]
                        if not all(map(isfinite, exact)):
                            break
                        answer = tuple([x + _half_unit(x - zero) * (-1 + 2 * random()) for x in exact])
                    if not all(map(isfinite, answer)):
                        break
                    for place, value in zip(at, answer, strict=True):
                        known[place] = Ball(value)
                    found.append(answer)
                else:
                    yield found


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
