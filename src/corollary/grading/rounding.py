"""How far an honest answer may lie from the truth: the derivation replayed with every step rounded to three figures."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from corollary.answers.evaluation import Letters, balls
from corollary.answers.expected import Values
from corollary.derive.solution import Solution
from corollary.formula.ball import RationalPi, Undefined
from corollary.grading.replay import WhatIf, replay

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
    ready = balls(givens)
    dice = random.Random(1)  # the same roundings for every variant: fair, and the same in ten years
    for _ in range(REPLAYS):
        _widen(
            noise,
            solution,
            ready,
            values,
            WhatIf(rounding=lambda x: x + _half_unit(x) * dice.uniform(-1, 1)),
        )
    if (other := GRAVITY.get(givens["g"].ratio) if "g" in givens else None) is not None:
        shifts = _no_noise(values)
        _widen(shifts, solution, {**givens, "g": RationalPi(other)}, values, WhatIf())
        for each, shift in zip(noise, shifts, strict=True):
            each.distance += shift.distance
            each.components = [a + b for a, b in zip(each.components, shift.components, strict=True)]
    return noise


def _no_noise(values: Sequence[Values]) -> list[Noise]:
    return [Noise(0.0, [0.0] * len(numbers)) for numbers in values]


def _widen(
    noise: list[Noise],
    solution: Solution,
    givens: Letters,
    values: Sequence[Values],
    what_if: WhatIf,
) -> None:
    try:
        found = replay(solution, givens, what_if)
    except Undefined:
        return
    for each, numbers, truth in zip(noise, found, values, strict=True):
        off = math.dist(numbers, truth)
        if math.isfinite(off):
            each.distance = max(each.distance, off)
            each.components = [
                max(a, abs(x - y)) for a, x, y in zip(each.components, numbers, truth, strict=True)
            ]


def _half_unit(x: float) -> float:
    """Half a unit in the last of the figures written down."""
    return 0.0 if x == 0 else 0.5 * 10.0 ** (math.floor(math.log10(abs(x))) - FIGURES + 1)
