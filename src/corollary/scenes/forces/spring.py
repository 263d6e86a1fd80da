"""A spring between two bodies, pulling and pushing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Spring:
    """k in N/m, `length` the one at rest (m); `ends` are two places in the list of bodies; `damping` in kg/s acts along it."""

    ends: tuple[int, int]
    k: float
    length: float = 0.0
    damping: float = 0.0


def pull(spring: Spring, apart: Sequence[float], relative: Sequence[float]) -> list[float]:
    """The force (N) on the first end; `apart` and `relative` are place and velocity of the second seen from it."""
    long = math.hypot(*apart)
    if long == 0.0:
        return [0.0] * len(apart)
    growing = sum(x * v for x, v in zip(apart, relative, strict=True)) / long
    force = spring.k * (long - spring.length) + spring.damping * growing
    return [force * x / long for x in apart]


def stored(spring: Spring, apart: Sequence[float]) -> float:
    """The energy in the spring (J)."""
    return 0.5 * spring.k * (math.hypot(*apart) - spring.length) ** 2
