"""Motion about a fixed centre: orbits under an inverse-square force in closed form, in a truncated harmonic well by quadrature."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from corollary.scenes.forces.well import Well
from corollary.scenes.models.gauss import integral


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


@dataclass(frozen=True, slots=True)
class Radial:
    """Motion of the distance r at given energy and spin (angular momentum per mass) as if the well had no edge.

    `frequency` w is the angular one of a swing along a line. square_of_speed(r) = 2 E/m - w^2 (r-b)^2 - spin^2/r^2 is concave, so
    r stays between two roots `low` and `high`. Between them r^2 times that square is w^2 (r - low)(high - r)(r^2 + p r + s).
    """

    well: Well
    frequency: float
    spin: float
    double_energy: float
    low: float
    high: float

    def square_of_speed(self, r: float) -> float:
        """The square of dr/dt; negative where the atom cannot be."""
        return self.double_energy - (self.frequency * (r - self.well.b)) ** 2 - (self.spin / r) ** 2

    def place(self, phase: float) -> float:
        """r at a phase from 0 (at `low`) to pi (at `high`)."""
        return self.low + (self.high - self.low) * math.sin(0.5 * phase) ** 2

    def phase(self, r: float) -> float:
        share = (r - self.low) / (self.high - self.low) if self.high > self.low else 0.0
        return 2.0 * math.asin(math.sqrt(min(max(share, 0.0), 1.0)))

    def pace(self, phase: float) -> float:
        """dt / d(phase), smooth at both turning points."""
        w, r = self.frequency, self.place(phase)
        p = self.low + self.high - 2.0 * self.well.b
        s = self.spin**2 / (w * w * self.low * self.high)
        return r / (w * math.sqrt(r * r + p * r + s))

    def turn(self, phase: float) -> float:
        """d(angle) / d(phase)."""
        return self.spin / self.place(phase) ** 2 * self.pace(phase)


def radial(well: Well, m: float, r: float, along: float, across: float) -> Radial:
    """The radial motion of an atom of mass m at distance r with these velocities along the radius and across it."""
    w = math.sqrt(well.k / m)
    spin = r * across
    double = along**2 + across**2 + (w * (r - well.b)) ** 2
    if spin == 0.0:
        reach = math.sqrt(double) / w
        return Radial(well, w, 0.0, double, well.b - reach, well.b + reach)
    square = Radial(well, w, spin, double, r, r).square_of_speed
    top, near, far = (
        _circle(well.b, abs(spin) / w),
        abs(spin) / math.sqrt(double),
        well.b + math.sqrt(double) / w,
    )
    if along == 0.0:
        # The start is one turning point; taken out of the square, what is left falls through zero once, at the other.
        def left(x: float) -> float:
            return (spin / (x * r)) ** 2 * (x + r) - w * w * (x + r - 2.0 * well.b)

        other = _root(left, far, top) if r <= top else _root(lambda x: -left(x), min(near, top), top)
        return Radial(well, w, spin, double, min(r, other), max(r, other))
    return Radial(
        well, w, spin, double, _root(square, min(near, top), top), _root(square, max(far, top), top)
    )


def _circle(b: float, area: float) -> float:
    """The radius of the circle with this spin/w: r^3 (r - b) = area^2; beyond b the left side grows and is convex."""
    target = area * area
    r = b + min(target / b**3, target**0.25)
    for _ in range(100):
        step = (r**3 * (r - b) - target) / (r * r * (4.0 * r - 3.0 * b))
        r -= step
        if abs(step) <= 1e-16 * r:
            break
    return r


def _root(square: Callable[[float], float], outside: float, inside: float) -> float:
    """Where the square of the speed is zero, between a place it is not above zero and one where it is not below; by halving."""
    if square(inside) <= 0.0:
        return inside
    for _ in range(200):
        middle = 0.5 * (outside + inside)
        if middle in (outside, inside):
            break
        outside, inside = (outside, middle) if square(middle) > 0.0 else (middle, inside)
    return inside


def swept(motion: Radial, start: float, end: float) -> tuple[float, float, float, int]:
    """Time and angle between two phases, the error_estimate about them, and the evaluations spent."""
    if start == end:
        return 0.0, 0.0, 0.0, 0
    time, error_estimate, spent = integral(motion.pace, start, end)
    if motion.spin == 0.0:
        return time, 0.0, error_estimate, spent
    angle, error_of_angle, spent_too = integral(motion.turn, start, end)
    return time, angle, max(error_estimate, error_of_angle), spent + spent_too
