"""Kinetic friction on a level table, against the velocity until the body stops."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Friction:
    """mu m g against the velocity of one body (by its place in the scene)."""

    body: int
    mu: float
    g: float = 9.8


def drag(friction: Friction, mass: float, velocity: Sequence[float]) -> list[float]:
    """The force (N); none on a body at rest."""
    speed = math.hypot(*velocity)
    return [-friction.mu * mass * friction.g * v / speed if speed else 0.0 for v in velocity]
