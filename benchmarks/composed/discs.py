"""Rigid discs in a plane, and what holds, pushes and rubs them: the kinematics of the reference by enumerated modes.

A state is a row of numbers: x, y and the angle of every disc, one disc after the other, and then how fast each of these changes.
Nothing here is shared with what is judged; a constraint is a row of numbers that the velocities are multiplied by.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np

Motion = Callable[[float], tuple[float, float, float]]
"""How far, how fast and how much faster something is along a line at a time."""


@dataclass(frozen=True, slots=True)
class Disc:
    """`inertia` (kg m^2) is that of a solid sphere unless another one is given; a point does not turn."""

    mass: float
    place: tuple[float, float]
    velocity: tuple[float, float] = (0.0, 0.0)
    radius: float = 0.0
    spin: float = 0.0
    inertia: float | None = None

    @property
    def resists_spin(self) -> float:
        if self.inertia is not None:
            return self.inertia
        return 0.4 * self.mass * self.radius**2 if self.radius else math.inf


@dataclass(frozen=True, slots=True)
class Plate:
    """A hard wall across `normal`, which moves steadily along it, or as `moves` tells; it is met by the discs of `only`, or by all."""

    normal: tuple[float, float]
    offset: float = 0.0
    restitution: float = 0.0
    friction: float = 0.0
    speed: float = 0.0
    moves: Motion | None = None
    only: tuple[int, ...] = ()

    def motion(self, t: float) -> tuple[float, float, float]:
        return self.moves(t) if self.moves else (self.offset + self.speed * t, self.speed, 0.0)


@dataclass(frozen=True, slots=True)
class Cord:
    """Between the centres of two discs; it jerks when it becomes taut."""

    ends: tuple[int, int]
    length: float
    restitution: float = 0.0


@dataclass(frozen=True, slots=True)
class SoftContact:
    """k overlap^q where discs overlap, and a dashpot; with friction, surfaces rub and the dashpot acts along the line of centres alone."""

    stiffness: float
    power: float
    damping: float = 0.0
    friction: float = 0.0
    pairs: tuple[tuple[int, int], ...] | None = None


@dataclass(frozen=True, slots=True)
class Composed:
    """Discs and all that acts on them; `bars` keep the distance their ends begin with."""

    discs: tuple[Disc, ...]
    gravity: float = 0.0
    plates: tuple[Plate, ...] = ()
    cords: tuple[Cord, ...] = ()
    bars: tuple[tuple[int, int], ...] = ()
    contact: SoftContact | None = None


class Row(NamedTuple):
    """What is held is `on @ velocities + rate`; it changes as `on @ accelerations + drift`."""

    on: Any
    rate: float
    drift: float


class Apart(NamedTuple):
    """Of two discs: the distance, the direction from the first to the second, and the relative velocity."""

    distance: float
    x: float
    y: float
    vx: float
    vy: float

    @property
    def growth(self) -> float:
        return self.vx * self.x + self.vy * self.y

    @property
    def across(self) -> float:
        return -self.vx * self.y + self.vy * self.x


def apart(state: Any, a: int, b: int) -> Apart:
    n, a, b = len(state) // 2, 3 * a, 3 * b
    x, y = (state[b : b + 2] - state[a : a + 2]).tolist()
    vx, vy = (state[n + b : n + b + 2] - state[n + a : n + a + 2]).tolist()
    distance = math.hypot(x, y)
    return Apart(distance, x / distance, y / distance, vx, vy)


@dataclass(frozen=True, slots=True)
class OnPlate:
    """A disc stays above a plate; where that is rough, it may stick to it or slip."""

    disc: int
    radius: float
    plate: Plate
    opens: ClassVar[bool] = True

    @property
    def restitution(self) -> float:
        return self.plate.restitution

    def gap(self, t: float, state: Any) -> float:
        x, y = state[3 * self.disc : 3 * self.disc + 2]
        nx, ny = self.plate.normal
        return nx * x + ny * y - self.plate.motion(t)[0] - self.radius

    def row(self, t: float, state: Any) -> Row:
        on = np.zeros(len(state) // 2)
        on[3 * self.disc : 3 * self.disc + 2] = self.plate.normal
        _, speed, growth = self.plate.motion(t)
        return Row(on, -speed, -growth)

    def slip(self, state: Any) -> Row:
        """Of the surface of the disc along the plate."""
        on, i = np.zeros(len(state) // 2), 3 * self.disc
        nx, ny = self.plate.normal
        on[i : i + 3] = ny, -nx, self.radius
        return Row(on, 0.0, 0.0)


@dataclass(frozen=True, slots=True)
class Tie:
    """A cord, which opens, or a bar, which does not; the gap of a cord is what it lacks to be taut."""

    ends: tuple[int, int]
    length: float
    restitution: float
    opens: bool

    def gap(self, t: float, state: Any) -> float:
        a, b = self.ends
        distance = math.hypot(state[3 * b] - state[3 * a], state[3 * b + 1] - state[3 * a + 1])
        return self.length - distance if self.opens else distance - self.length

    def row(self, t: float, state: Any) -> Row:
        a, b = self.ends
        between, sign = apart(state, a, b), -1.0 if self.opens else 1.0
        on = np.zeros(len(state) // 2)
        on[3 * b : 3 * b + 2] = sign * between.x, sign * between.y
        on[3 * a : 3 * a + 2] = -sign * between.x, -sign * between.y
        return Row(on, 0.0, sign * between.across**2 / between.distance)


Hold = OnPlate | Tie


@dataclass(frozen=True, slots=True)
class Pair:
    """Two discs that push each other while they overlap."""

    a: int
    b: int
    radii: tuple[float, float]
    contact: SoftContact

    def depth(self, state: Any) -> float:
        return self.radii[0] + self.radii[1] - apart(state, self.a, self.b).distance

    def elastic(self, state: Any) -> float:
        return self.contact.stiffness * max(self.depth(state), 0.0) ** self.contact.power

    def stored(self, state: Any) -> float:
        """The potential energy."""
        power = self.contact.power + 1
        return self.contact.stiffness * max(self.depth(state), 0.0) ** power / power

    def push(self, state: Any) -> tuple[float, float]:
        """On the second one, drag included, friction left out."""
        between, damping = apart(state, self.a, self.b), self.contact.damping
        overlap = max(self.radii[0] + self.radii[1] - between.distance, 0.0)
        elastic = self.contact.stiffness * overlap**self.contact.power
        if self.contact.friction:
            force = elastic - damping * between.growth
            return force * between.x, force * between.y
        return elastic * between.x - damping * between.vx, elastic * between.y - damping * between.vy

    def slip(self, state: Any) -> Row:
        """Of the surface of the second one along that of the first, in the middle of the lens they share."""
        between, n = apart(state, self.a, self.b), len(state) // 2
        a, b, total = 3 * self.a, 3 * self.b, sum(self.radii)
        arms = [between.distance * radius / total for radius in self.radii]
        on = np.zeros(n)
        on[b : b + 3] = -between.y, between.x, -arms[1]
        on[a : a + 3] = between.y, -between.x, -arms[0]
        turning = between.across / between.distance
        rim = (self.radii[0] * state[n + a + 2] + self.radii[1] * state[n + b + 2]) / total
        return Row(on, 0.0, -turning * between.growth - between.growth * rim)


class System:
    """The same discs as rows and columns: what each may be held by, which pairs push, where friction acts, and the state at first."""

    def __init__(self, given: Composed) -> None:
        discs = given.discs
        self.discs, self.gravity = discs, given.gravity
        self.moving = [i for i, disc in enumerate(discs) if not math.isinf(disc.mass)]
        shares = [1 / each for disc in discs for each in (disc.mass, disc.mass, disc.resists_spin)]
        self.mobility = np.array(shares)  # 1 / inf is zero
        places = [each for disc in discs for each in (*disc.place, 0.0)]
        rates = [each for disc in discs for each in (*disc.velocity, disc.spin)]
        self.start = np.array([*places, *rates], dtype=float)
        self.holds: list[Hold] = []
        self.rubs: list[tuple[int, OnPlate | Pair, float]] = []
        for plate in given.plates:
            for i in plate.only or range(len(discs)):
                if i in self.moving:
                    self.holds.append(on_plate := OnPlate(i, discs[i].radius, plate))
                    if plate.friction:
                        self.rubs.append((len(self.holds) - 1, on_plate, plate.friction))
        self.holds += [Tie(cord.ends, cord.length, cord.restitution, True) for cord in given.cords]
        for a, b in given.bars:
            self.holds.append(Tie((a, b), math.dist(discs[a].place, discs[b].place), 0.0, False))
        self.pairs: list[Pair] = []
        if given.contact:
            for a, b in given.contact.pairs or itertools.combinations(range(len(discs)), 2):
                if a in self.moving or b in self.moving:
                    pair = Pair(a, b, (discs[a].radius, discs[b].radius), given.contact)
                    self.pairs.append(pair)
                    if given.contact.friction:
                        self.rubs.append((len(self.pairs) - 1, pair, given.contact.friction))

    def forces(self, state: Any, touching: frozenset[int]) -> Any:
        """Weights, and the pushes of the pairs that touch."""
        forces = np.zeros(3 * len(self.discs))
        for i in self.moving:
            forces[3 * i + 1] -= self.discs[i].mass * self.gravity
        for k in sorted(touching):
            pair, push = self.pairs[k], self.pairs[k].push(state)
            forces[3 * pair.b : 3 * pair.b + 2] += push
            forces[3 * pair.a : 3 * pair.a + 2] -= push
        return forces

    def energy(self, state: Any) -> float:
        """Kinetic, of weights above zero, and of contacts."""
        n, total = 3 * len(self.discs), 0.0
        for i in self.moving:
            disc, (vx, vy, spin) = self.discs[i], state[n + 3 * i : n + 3 * i + 3]
            total += disc.mass * ((vx * vx + vy * vy) / 2 + self.gravity * state[3 * i + 1])
            if not math.isinf(disc.resists_spin):
                total += disc.resists_spin * spin * spin / 2
        return float(total + sum(pair.stored(state) for pair in self.pairs))
