"""Rounding of an honest answer: the derivation replayed with steps and operations rounded to three figures."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from math import isfinite
from operator import add
from typing import TYPE_CHECKING

from corollary.answers.expected import Values
from corollary.derive.solution import Solution
from corollary.formula.ball import RationalPi, Undefined
from corollary.grading.replay import replay

if TYPE_CHECKING:
    import numpy as np

GRAVITY = {Fraction("9.8"): Fraction("9.81"), Fraction("9.81"): Fraction("9.8")}
# Three figures may be half a per cent off (1.005 for 1.00); beyond 2 % mistakes look right.
LEAST_TOLERANCE, MOST_TOLERANCE = 0.005, 0.02


def tolerance_of(own: float, off: float, error: float) -> float:
    """How far an answer may be from the key, as a share of its scale: what honest rounding does (`off`) and the key's own error,
    within bounds; at least what its part states (`own`)."""
    return max(own, min(MOST_TOLERANCE, max(LEAST_TOLERANCE, off + error)))


@dataclass(slots=True)
class Noise:
    """How far honest rounding moves a find: the distance, and each component on its own (absolute, SI).

    `by_steps` and `components_by_steps` are the same where only the answers of whole steps are rounded.
    """

    distance: float
    components: list[float]
    by_steps: float = 0.0
    components_by_steps: list[float] = field(default_factory=list[float])


def noise_of(solution: Solution, givens: Mapping[str, RationalPi], values: Sequence[Values]) -> list[Noise]:
    """The largest over the replays, plus what 9.8 for 9.81 does."""
    # Only here: a key that nobody is marked with is shown without numpy.
    from corollary.grading.rounded_replays import rounded_replays

    if not values:
        return []
    flat = [[x] for numbers in values for x in numbers]
    apart = abs(rounded_replays(solution, givens, values) - flat)
    (by_steps, by_operations), noise, place = apart.max(axis=2, initial=0.0).tolist(), list[Noise](), 0
    for numbers in values:
        own = slice(place, place + len(numbers))
        reach = _reach(by_steps, apart[0], own), _reach(by_operations, apart[1], own)
        components = list(map(max, by_steps[own], by_operations[own]))
        noise.append(Noise(max(reach), components, reach[0], by_steps[own]))
        place += len(numbers)
    if (other := GRAVITY.get(givens["g"].ratio) if "g" in givens else None) is not None:
        with suppress(Undefined):
            shifted = replay(solution, {**givens, "g": RationalPi(other)})
            for each, numbers, truth in zip(noise, shifted, values, strict=True):
                if len(numbers) != len(truth):
                    continue  # a list that has another length
                off = math.dist(numbers, truth)
                if isfinite(off):
                    each.distance += off
                    each.by_steps += off
                    own = [abs(x - y) for x, y in zip(numbers, truth, strict=True)]
                    each.components = list(map(add, each.components, own))
                    each.components_by_steps = list(map(add, each.components_by_steps, own))
    return noise


def _reach(most: list[float], apart: np.ndarray, own: slice) -> float:
    """The distance to which any replay moves an unknown: `most` of each component, which lie `apart` so far in each replay."""
    if len(most[own]) == 1:
        return most[own][0]
    return max((math.hypot(*each) for each in apart[own].T.tolist()), default=0.0)
