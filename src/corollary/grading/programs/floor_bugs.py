"""The usual wrong programs for a ball on the floor, and what is said to who wrote one."""

from __future__ import annotations

from functools import lru_cache
from typing import Literal

Scheme = Literal["euler", "weightless", "linear", "floor"]

USUAL: dict[Scheme, str] = {
    "euler": "This is forward Euler: the position is stepped with the old velocity, and energy grows. "
             "Step the velocity first, then the position with the new velocity.",
    "weightless": "Gravity is missing: the net force is N - m g, also while the ball is above the floor.",
    "linear": "The floor pushes here like a spring, in proportion to R - y. Its force goes with the power 3/2.",
    "floor": "Velocity and time are right, but the force is that of the floor; the net force is smaller by the weight.",
}  # fmt: skip


@lru_cache(maxsize=256)
def wrong_bounce(
    scheme: Scheme, m: float, k: float, R: float, y0: float, v0: float, g: float, dt: float
) -> tuple[float, float, float] | None:
    """Velocity, largest force and time of contact of a wrong program, or None when it never ends."""
    y, v, largest, below = y0, v0, 0.0, 0
    pull = 0.0 if scheme == "weightless" else m * g
    for _ in range(200_000):
        overlap = R - y
        if overlap > 0:
            below += 1
        elif below:
            return v, largest, below * dt
        push = k * overlap ** (1.0 if scheme == "linear" else 1.5) if overlap > 0 else 0.0
        largest = max(largest, push - (0.0 if scheme == "floor" else pull))
        a = (push - pull) / m
        y, v = y + (v if scheme == "euler" else v + a * dt) * dt, v + a * dt
    return None
