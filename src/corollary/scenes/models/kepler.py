"""A body under a force that falls with the square of the distance from a fixed centre: its orbit in closed form."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Orbit:
    """Distances (m) nearest to the centre and farthest from it, and the period (s); both infinite when the body escapes."""

    nearest: float
    farthest: float
    period: float


def orbit(pull: float, r: float, along: float, across: float) -> Orbit | None:
    """The orbit of a body at distance r with these velocities along the radius and across it; none when it meets the centre.

    `pull` is the attraction in m^3/s^2 (strength over mass), negative for a repulsion. Energy and angular momentum make 1/r at the
    turning points the roots of a quadratic; its discriminant is written as a sum of squares, so that a circle loses no digits.
    """
    spin = r * across
    root = math.hypot(spin * along, spin * spin / r - pull)
    double_energy = along * along + across * across - 2.0 * pull / r
    if spin == 0.0 and pull > 0.0:
        return None
    # Of the two ways to write the root, the one that adds.
    nearest = spin * spin / (pull + root) if pull > 0.0 else (root - pull) / double_energy
    if double_energy >= 0.0:
        return Orbit(nearest, math.inf, math.inf)
    axis = -pull / double_energy
    return Orbit(nearest, -(pull + root) / double_energy, 2.0 * math.pi * axis * math.sqrt(axis / pull))
