"""Bodies in a row, each touching only its neighbours; a wall or a floor is a body of infinite mass."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import accumulate

from corollary.scenes.forces.contact import Contact, stored
from corollary.scenes.run import GuardFailed, Outcome


@dataclass(frozen=True, slots=True)
class RowOfBodies:
    """n bodies from left to right (or bottom to top), and the n - 1 contacts between neighbours.

    `gaps` are the distances between neighbouring surfaces (0: just touching, negative: squeezed). `weight` is the acceleration
    of gravity toward the left; it acts on every body of finite mass.
    """

    masses: tuple[float, ...]
    velocities: tuple[float, ...]
    gaps: tuple[float, ...]
    contacts: tuple[Contact, ...]
    weight: float = 0.0


@dataclass(frozen=True, slots=True)
class RowResult:
    """What a collision on a line led to.

    `overlaps` and `forces` are the largest of each contact, `left` are the gaps in the end, where a model tells. `duration` runs from the
    first touch to the last opening; it is infinite for bodies that stick. `strain` says how many times larger (in natural units) an error
    of a speed or an overlap comes out in the moment of a slow touch or opening, where a model looked.
    """

    velocities: tuple[float, ...]
    duration: float
    overlaps: tuple[float, ...]
    forces: tuple[float, ...]
    outcome: Outcome
    evaluations: int
    openings: int = 0
    strain: float = 0.0
    left: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Units:
    """The natural mass, speed and overlap of a line; all other units follow."""

    mass: float
    speed: float
    overlap: float

    @property
    def time(self) -> float:
        return self.overlap / self.speed

    @property
    def force(self) -> float:
        return self.mass * self.speed**2 / self.overlap


def reduced_mass(a: float, b: float) -> float:
    """The mass with which two bodies resist being pushed apart; the finite one's beside a wall."""
    return 1.0 / (1.0 / a + 1.0 / b)


def natural_units(line: RowOfBodies) -> Units | None:
    """Units in which the collision is of order one; none when nothing ever moves toward anything.

    The unit of overlap is the largest there can be, not the one of the contact force alone: weight counts too.
    """
    mass = max(map(reduced_mass, line.masses, line.masses[1:]))
    largest = squeezed = resting = 0.0
    for i, (c, gap) in enumerate(zip(line.contacts, line.gaps, strict=True)):
        closing = line.velocities[i] - line.velocities[i + 1]
        largest = max(largest, closing * closing)
        if gap < 0.0:
            squeezed = max(squeezed, 2.0 * stored(c, -gap) / mass)
        if line.weight and line.masses[i] == math.inf and line.masses[i + 1] < math.inf:
            largest = max(largest, closing * closing + 2.0 * line.weight * max(gap, 0.0))
            resting = max(resting, (mass * line.weight / c.k) ** (1.0 / c.q))
    speed = math.sqrt(max(largest, squeezed))
    overlap = max(resting, *(_squeeze(c, mass, speed) for c in line.contacts))
    if resting > 0.0 and speed == 0.0:
        speed = math.sqrt(line.weight * resting)
    return Units(mass, speed, overlap) if speed > 0.0 else None


def _squeeze(contact: Contact, mass: float, speed: float) -> float:
    """About how far a contact gives: spring or dashpot, whichever stops the bodies first."""
    elastic = (mass * speed**2 / contact.k) ** (1.0 / (contact.q + 1.0))
    return min(elastic, mass * speed / contact.eta) if contact.eta > 0.0 else elastic


def in_units(line: RowOfBodies, units: Units) -> RowOfBodies:
    """The same line in its natural units. Raises OverflowError when one of these leaves the range of a computer."""
    if not all(map(math.isfinite, (units.mass, units.speed, units.overlap, units.time, units.force))):
        raise OverflowError("a number of the collision is too large or too small")
    speed, overlap, force = units.speed, units.overlap, units.force
    scaled = {c: Contact(c.k * overlap**c.q / force, c.q, c.eta * speed / force) for c in set(line.contacts)}
    return RowOfBodies(
        masses=tuple([m / units.mass for m in line.masses]),
        velocities=tuple([v / speed for v in line.velocities]),
        gaps=tuple([gap / overlap for gap in line.gaps]),
        contacts=tuple([scaled[c] for c in line.contacts]),
        weight=line.weight * units.time / units.speed,
    )


def in_si(result: RowResult, units: Units) -> RowResult:
    """What was found in natural units, back in those of the line."""
    speed, overlap, force = units.speed, units.overlap, units.force
    return replace(
        result,
        velocities=tuple([v * speed for v in result.velocities]),
        duration=result.duration * units.time,
        overlaps=tuple([d * overlap for d in result.overlaps]),
        forces=tuple([f * force for f in result.forces]),
        left=tuple([gap * overlap for gap in result.left]),
    )


Conserved = tuple[float, float, float]
"""Energy (kinetic, stored and, beside a wall on the left, potential), momentum, and how much momentum there is whatever its direction."""


def conserved(line: RowOfBodies, overlaps: Sequence[float], velocities: Sequence[float]) -> Conserved:
    """What no collision without damping changes, for bodies with these overlaps and velocities; walls left out."""
    loose = [(m, v) for m, v in zip(line.masses, velocities, strict=True) if m < math.inf]
    energy = math.fsum(0.5 * m * v * v for m, v in loose)
    energy += math.fsum(stored(c, d) for c, d in zip(line.contacts, overlaps, strict=True))
    if line.weight:
        heights = zip(line.masses[1:], accumulate(overlaps), strict=True)
        energy -= math.fsum(m * line.weight * depth for m, depth in heights if m < math.inf)
    return energy, math.fsum(m * v for m, v in loose), math.fsum(abs(m * v) for m, v in loose)


# What rounding may do to the momentum of a row, of itself: in a short run, and for each look at the forces of a long one.
LOST, LOST_EACH = 1e-12, 1e-17


def guard(line: RowOfBodies, before: Conserved, after: Conserved, tolerance: float, evaluations: int) -> None:
    """Refuse a motion that lost momentum, or gained energy, or (without damping) lost some, in so many evaluations of its forces.

    Raises GuardFailed. The line is in natural units, so `tolerance` is a relative one.
    """
    gained = (after[0] - before[0]) / max(1.0, abs(before[0]))
    if abs(gained) > tolerance and (gained > 0.0 or all(c.eta == 0.0 for c in line.contacts)):
        raise GuardFailed(
            f"The run changed the energy by {gained:.1e} of itself; {tolerance:.1e} is allowed. Ask for less."
        )
    lost, size = after[1] - before[1], after[2] + before[2]
    if (
        abs(lost) > (LOST + LOST_EACH * evaluations) * size
        and line.weight == 0.0
        and math.inf not in line.masses
    ):
        raise GuardFailed(
            f"The run changed the momentum by {lost / size:.1e} of itself; no force from outside acts."
        )
