"""Refusals of a start that cannot be and of an end out of reach, and hits that an end leaves in doubt."""

from __future__ import annotations

import math
from collections import deque
from itertools import combinations
from statistics import median

import numpy as np

from corollary.scenes.constraint import Constraint, State
from corollary.scenes.motion.path import Trajectory
from corollary.scenes.motion.sizes import FINEST_OVERLAP, Sizes
from corollary.scenes.motion.system import Mode, System
from corollary.scenes.run import BadSetting

# Forces on what is lighter (kg) are below the numbers that have all their digits.
LIGHTEST = 1e-305
# A speed along a rod that is such a part of those of its ends is what rounding leaves: it is taken out.
PARTING = 1e-6
# Rods that hold the same motion are told by singular values.
DEPENDENT = 1e-9
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
    _refuse_locked(system, start)


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


def _refuse_locked(system: System, start: State) -> None:
    """Raises BadSetting where rods hold one motion twice: how they share their forces rigid bodies leave open."""
    rods = [c for c in system.constraints if c.two_sided]
    movable = system.inverse(0.0) > 0.0
    if len(rods) < 2 or not movable.any():
        return
    rows = np.array([c.row(0.0, start) for c in rods])[:, movable]
    if np.linalg.matrix_rank(rows, DEPENDENT * float(np.abs(rows).max())) < len(rods):
        names = ", ".join(c.name for c in rods)
        raise BadSetting(
            f"{system.scene.name}: {names} hold the same motion more than once, and what each of them takes is open; take one away."
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
