"""Damped contacts that never end: when that is certain, and how the bodies go on."""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.scenes.forces.contact import Contact, stored
from corollary.scenes.models.flight import fall_of
from corollary.scenes.row import RowOfBodies, reduced_mass


def stays(line: RowOfBodies, state: Sequence[float], touching: Sequence[bool], tolerance: float) -> bool:
    """Whether the bodies that touch will touch for ever, and their overlaps have seen their largest.

    Certain for a single damped contact that opens: with z = -rate/overlap, dz/dt = z^2 - (eta/mu) z + (k/mu) overlap^(q-1): once
    z is below the larger root it stays there, and the overlap fades exponentially at most; weight on a floor makes z smaller
    still. Certain on a floor, too, when the energy left does not lift the ball. For several damped contacts: when all have come
    to rest within the tolerance.
    """
    count = len(line.masses)
    live = [j for j, on in enumerate(touching) if on]
    if not live or any(line.contacts[j].eta == 0.0 for j in live):
        return False
    rates = [state[count + j] - state[count + j + 1] for j in range(count - 1)]
    if any(rates[j] > tolerance for j in range(count - 1) if j not in live):
        return False
    if len(live) > 1:
        return all(state[1 + j] > 0.0 and abs(rates[j]) < tolerance for j in live)
    (j,) = live
    overlap, rate, contact = state[1 + j], rates[j], line.contacts[j]
    mass, fall = reduced_mass(line.masses[j], line.masses[j + 1]), fall_of(line, j)
    if overlap <= 0.0:
        return False
    if rate > 0.0:
        return fall > 0.0 and _sinks(contact, mass, fall, overlap, rate)
    if fall > 0.0 and 0.5 * mass * rate**2 + stored(contact, overlap) < mass * fall * overlap:
        return True
    return never_faster(contact.eta / mass, contact.k / mass * overlap ** (contact.q - 1.0), -rate / overlap)


def _sinks(contact: Contact, mass: float, fall: float, overlap: float, rate: float) -> bool:
    """Whether a ball creeps down to its resting overlap without ever passing it: the same argument, seen from there."""
    rest = (mass * fall / contact.k) ** (1.0 / contact.q)
    stiffness = contact.k * contact.q * rest ** (contact.q - 1.0)
    return overlap < rest and never_faster(contact.eta / mass, stiffness / mass, rate / (rest - overlap))


def never_faster(drag: float, spring: float, z: float) -> bool:
    """Whether z is below the larger root of z^2 - drag z + spring."""
    room = drag**2 - 4.0 * spring
    return room > 0.0 and z < 0.5 * (drag + math.sqrt(room))


def resting_overlaps(line: RowOfBodies, touching: Sequence[bool]) -> list[float]:
    """How deep weight alone squeezes each contact that stays, in the end."""
    rests: list[float] = []
    for j, on in enumerate(touching):
        mass = reduced_mass(line.masses[j], line.masses[j + 1])
        rests.append(
            (mass * fall_of(line, j) / line.contacts[j].k) ** (1.0 / line.contacts[j].q) if on else 0.0
        )
    return rests


def common_velocities(
    line: RowOfBodies, state: Sequence[float], touching: Sequence[bool]
) -> tuple[float, ...]:
    """Velocities once every chain of touching bodies moves as one."""
    count = len(line.masses)
    speeds = list(state[count:])
    start = 0
    while start < count:
        stop = start + 1
        while stop < count and touching[stop - 1]:
            stop += 1
        masses = line.masses[start:stop]
        walls = [v for m, v in zip(masses, speeds[start:stop], strict=True) if math.isinf(m)]
        together = (
            walls[0]
            if walls
            else sum(m * v for m, v in zip(masses, speeds[start:stop], strict=True)) / sum(masses)
        )
        speeds[start:stop] = [together] * (stop - start)
        start = stop
    return tuple(speeds)
