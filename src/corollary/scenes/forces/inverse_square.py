"""Attraction or repulsion that falls with the square of the distance (section 12.6, two ions)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class InverseSquare:
    """Two bodies (places in the scene) attract each other with strength/r^2, in N m^2; they repel when it is negative."""

    ends: tuple[int, int]
    strength: float


def pull(force: InverseSquare, apart: Sequence[float]) -> list[float]:
    """The force (N) on the first; `apart` is the place of the second seen from it."""
    r = math.hypot(*apart)
    return [force.strength * x / r**3 for x in apart]


def stored(force: InverseSquare, apart: Sequence[float]) -> float:
    """Potential energy (J), zero far apart."""
    return -force.strength / math.hypot(*apart)
