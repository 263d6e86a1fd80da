"""A molecule's pull on an atom: a harmonic well cut off on both sides (project 12.15)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Well:
    """U = k (r - b)^2 / 2 for b - d < r < b + d, k d^2 / 2 farther out, a hard core at b - d; r is the distance from the origin.

    Source: equations (12.138) and (12.140).
    """

    k: float
    b: float
    d: float

    @property
    def edge(self) -> float:
        return self.b + self.d

    @property
    def wall(self) -> float:
        return self.b - self.d


def pull(well: Well, place: Sequence[float]) -> list[float]:
    """The force (N) on an atom at a place inside the edge; there is none beyond."""
    r = math.hypot(*place)
    return [-well.k * (r - well.b) * x / r for x in place]


def stored(well: Well, place: Sequence[float]) -> float:
    """Potential energy (J), zero at the bottom of the well."""
    return 0.5 * well.k * min(math.hypot(*place) - well.b, well.d) ** 2
