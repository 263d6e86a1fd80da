"""How far an honest answer may lie from the truth: the derivation replayed with every step rounded to three figures."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from fractions import Fraction

from corollary.derive.solution import Solution
from corollary.mark.replay import Deviation, Numbers, replay
from corollary.quantity.ball import Exactly, Undefined

REPLAYS = 32
FIGURES = 3
GRAVITY = {Fraction("9.8"): Fraction("9.81"), Fraction("9.81"): Fraction("9.8")}
LEAST, MOST = 0.005, 0.02


def tolerance_of(solution: Solution, givens: Mapping[str, Exactly], values: Sequence[Numbers]) -> list[float]:
    """The largest distance of each find from its value, over the replays, plus what 9.8 for 9.81 does (absolute, SI)."""
    noise = [0.0] * len(values)
    dice = random.Random(1)  # the same roundings for every variant: fair, and the same in ten years
    for _ in range(REPLAYS):
        _widen(noise, solution, givens, values, Deviation(rounding=lambda x: x + _half_unit(x) * dice.uniform(-1, 1)))
    if (other := GRAVITY.get(givens["g"].ratio) if "g" in givens else None) is not None:
        shifts = [0.0] * len(values)
        _widen(shifts, solution, {**givens, "g": Exactly(other)}, values, Deviation())
        noise = [a + b for a, b in zip(noise, shifts, strict=True)]
    return noise


def _widen(noise: list[float], solution: Solution, givens: Mapping[str, Exactly], values: Sequence[Numbers], deviation: Deviation) -> None:
    try:
        found = replay(solution, givens, deviation)
    except Undefined:
        return
    for place, (numbers, truth) in enumerate(zip(found, values, strict=True)):
        off = math.dist(numbers, truth)
        if math.isfinite(off):
            noise[place] = max(noise[place], off)


def _half_unit(x: float) -> float:
    """Half a unit in the last of the figures kept."""
    return 0.0 if x == 0 else 0.5 * 10.0 ** (math.floor(math.log10(abs(x))) - FIGURES + 1)
