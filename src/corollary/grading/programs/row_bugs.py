"""The usual wrong programs for a row of balls, and what is said to who wrote one."""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

import numpy as np

Scheme = Literal["euler", "one-sided"]

USUAL: dict[Scheme, str] = {
    "euler": "this is forward Euler: the position is stepped with the old velocity, and energy grows. Step the velocity first, then the position with the new velocity.",
    "one-sided": "each ball feels only one of its neighbours. What a ball does to its neighbour, the neighbour does to it: half of the pair forces is missing.",
}


@lru_cache(maxsize=256)
def wrong_cradle(
    scheme: Scheme, balls: int, m: float, k: float, q: float, v0: float, dt: float
) -> tuple[float, ...] | None:
    """The velocities that a wrong program ends with, or None when it never ends."""
    v, x = np.zeros(balls), np.zeros(balls)
    v[0] = v0
    touched = False
    for _ in range(20_000):
        overlap = np.clip(x[:-1] - x[1:], 0, None)
        if touched and not overlap.any():
            return tuple(v)
        touched = touched or bool(overlap.any())
        force = k * overlap**q
        a = np.zeros(balls)
        if scheme != "one-sided":
            a[:-1] -= force / m
        a[1:] += force / m
        x, v = (x + v * dt, v + a * dt) if scheme == "euler" else (x + (v + a * dt) * dt, v + a * dt)
        if not np.isfinite(x).all() or np.abs(v).max() > 1e6 * v0:
            return None
    return None
