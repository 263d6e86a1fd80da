"""What a start may not be, what an end leaves open, and when it is out of reach: told from bounces that die away while it can be seen."""

from __future__ import annotations

import math
from collections import deque
from itertools import combinations
from statistics import median

import numpy as np

from corollary.scenes.constraint import Constraint, State
from corollary.scenes.motion.path import Trajectory
from corollary.scenes.motion.sizes import FINEST_OVERLAP, Sizes
from corollary.scenes.motion.system import Array, Mode, System
from corollary.scenes.run import BadSetting

# Forces on what is lighter (kg) are below the numbers that have all their digits.
LIGHTEST = 1e-305
# A speed along a rod that is such a part of those of its ends is what rounding leaves: it is taken out.
PARTING = 1e-6
# Rods that hold the same motion are told by singular values, and what bends by such a part of what it could.
DEPENDENT, LOCKED = 1e-9, 1e-6
MANY = 100
"""So many happenings are held against as many before them."""
SLOWER = 0.9
"""Bounces that die away have lost more than the rest of their speed meanwhile."""


def refuse_bad_start(system: System, start: State, sizes: Sizes) -> None:
    """Raises BadSetting where places cannot show what happens, or something is where it cannot be."""
    name = system.scene.name
    if system.contacts and sizes.deep < FINEST_OVERLAP * math.ulp(sizes.long):
        raise BadSetting(
            f"{name}: bodies squeeze each other by about {sizes.deep:.1g} m, which places of {sizes.long:.1g} m do not show. "
            "Make contacts softer, or bodies less unequal, or move them nearer to the origin."
        )
    if light := [body.mass for body in system.scene.bodies if body.mass < LIGHTEST]:
        raise BadSetting(
            f"{name}: of forces on a body of {min(light):.3g} kg a computer holds too few digits; {LIGHTEST:g} kg or more is right."
        )
    for constraint in system.constraints:
        gap = constraint.gap(0.0, start)
        if gap < -sizes.gap or (constraint.two_sided and gap > 1e-9 * sizes.long):
            raise BadSetting(
                f"{name}: {constraint.name} starts {abs(gap):.3g} m where it cannot be; move it."
            )
        if constraint.two_sided:
            _refuse_parting(system, start, sizes, constraint)
    _refuse_locked(system, start, sizes)


def _refuse_parting(system: System, start: State, sizes: Sizes, rod: Constraint) -> None:
    """Raises BadSetting where the ends of a rod leave or near each other by more than rounding of what moves them."""
    scene, axes = system.scene, system.scene.axes
    gained = system.gains(0.0, start, start)
    fast = sum(math.hypot(*scene.bodies[i].velocity) for i in rod.bodies)
    pulled = max(abs(gained[axes * i + axis]) for i in rod.bodies for axis in range(axes))
    long = max(
        math.dist(scene.bodies[a].place, scene.bodies[b].place) for a, b in combinations(rod.bodies, 2)
    )
    rate = system.rate(0.0, start, rod)
    if abs(rate) > PARTING * (fast + math.sqrt(pulled * long)) + sizes.speed:
        raise BadSetting(
            f"{scene.name}: the ends of {rod.name} {'part' if rate > 0.0 else 'near each other'} with {abs(rate):.3g} m/s at the start, "
            "which it cannot let them do; give them velocities that agree along it."
        )


def _refuse_locked(system: System, start: State, sizes: Sizes) -> None:
    """Raises BadSetting where rods hold together, by how they bend, what none of them holds alone: a body in line between two nails.

    Where J v = 0 leaves bodies motions v, J a + c(v, v) = 0 has an answer only if l c(v, v) = 0 for every l with l J = 0; where l c is
    never negative there is no way out of it.
    """
    rods, count = [c for c in system.constraints if c.two_sided], system.count
    movable = np.flatnonzero(system.inverse(0.0)[:count] > 0.0)
    if len(rods) < 2 or not len(movable):
        return
    rows = np.array([c.row(0.0, start) for c in rods])[:, movable]
    left, found, right = np.linalg.svd(rows)
    rank = int((found > DEPENDENT * found.max()).sum())
    ways = right[rank:]
    if rank == len(rods) or not len(ways):
        return

    def bent(way: Array) -> Array:
        velocities = np.zeros(len(start) - count)
        velocities[movable] = way
        state = [*start[:count], *velocities.tolist()]
        return np.array([c.drift(0.0, state) for c in rods])

    alone = [bent(way) for way in ways]
    size = max([1.0 / sizes.long, *(float(np.abs(each).max()) for each in alone)])
    for stress in left.T[rank:]:
        bends = np.array(
            [
                [stress @ (bent(one + other) - alone[n] - alone[m]) for m, other in enumerate(ways)]
                for n, one in enumerate(ways)
            ]
        )
        values = np.linalg.eigvalsh(bends)
        if np.abs(values).max() > LOCKED * size and (
            values.min() > -LOCKED * size or values.max() < LOCKED * size
        ):
            names = ", ".join(c.name for c, z in zip(rods, stress, strict=True) if abs(z) > LOCKED)
            raise BadSetting(
                f"{system.scene.name}: {names} lie so that they hold each other only by how they would bend, and with no force that is known; "
                "take one away."
            )


def hit_in_doubt(system: System, path: Trajectory, mode: Mode, slow: float) -> bool:
    """Whether a hit is so near before or after the end that errors decide if velocities are those of before or after it."""
    time, y = path.time, path.state
    return any(
        status == "off" and abs(c.gap(time, y)) < path.near and abs(system.rate(time, y, c)) > slow
        for c, status in zip(system.constraints, mode.held, strict=True)
    )


class Pace:
    """The last happenings: when (s) each was, after how many steps, and how fast (m/s) what hits or touches closed then."""

    def __init__(self) -> None:
        self.seen: deque[tuple[float, int, float | None]] = deque(maxlen=2 * MANY + 1)

    def met(self, time: float, steps: int, speed: float | None) -> None:
        """One more; `speed` for hits and touches alone."""
        self.seen.append((time, steps, speed))

    @property
    def lasted(self) -> float:
        """How long (s) the last of them took together."""
        return self.seen[-1][0] - self.seen[-1 - MANY][0]

    def hopeless(self, left: float, steps: int) -> bool:
        """Whether so many steps do not reach an end so far ahead (s) at this pace, and nothing slows down."""
        if len(self.seen) <= 2 * MANY:
            return False
        spent = self.seen[-1][1] - self.seen[-1 - MANY][1]
        if left * spent <= steps * self.lasted:
            return False
        before, now = (self._speed(first, first + MANY) for first in (1, MANY + 1))
        return now >= SLOWER * before

    def _speed(self, first: int, last: int) -> float:
        return median([speed for _, _, speed in list(self.seen)[first:last] if speed is not None] or [0.0])
