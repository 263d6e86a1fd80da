"""The equations of motion of a scene: its forces, and the constraints and friction that hold at a moment.

What presses or sticks is decided by complementarity and Coulomb's law, and so are hits, where multipliers are impulses: J. J. Moreau, in
Nonsmooth Mechanics and Applications (1988); D. E. Stewart, SIAM Rev. 42 (2000) 3.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import product
from operator import mul
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.body import Constraint, Rub, State
from corollary.scenes.run import BadSetting, GuardFailed, NoForce
from corollary.scenes.scene import ContactForce, Scene, opposite
from corollary.scenes.validation import is_own

Array = NDArray[np.float64]
Status = Literal["off", "on", "stick", "forward", "back"]
"""A constraint is off or on; a rub is off, sticks, or slips forward or back along its row."""
SLIPS: dict[Status, float] = {"forward": 1.0, "back": -1.0}

# The determinant of equations, each scaled to its size, and the singular value, of which only rounding is left.
DEPENDENT, RANK = 1e-11, 1e-12
# A multiplier or an acceleration so small against the others is zero.
NOISE = 1e-10
MOST_COMBINATIONS = 3000


@dataclass(slots=True)
class Item:
    """Something that may hold: `bias` is the acceleration (or velocity) along its row if nothing held.

    `pressed` is the item that presses a rub, by its place in the list, or `given` its normal force.
    """

    name: str
    row: Array
    bias: float
    may: tuple[Status, ...]
    rub: bool = False
    two_sided: bool = False
    pressed: int = -1
    given: float = 0.0
    kinetic: float = 0.0
    static: float = 0.0

    def yields(self, inverse: Array) -> float:
        """How much a force (or impulse) of one along the row changes what is along it (per kg)."""
        return float(np.square(self.row) @ inverse)


@dataclass(slots=True)
class Answer:
    """For each item its multiplier and what is left along its row; `total` is the generalized force (or impulse) of all."""

    multipliers: list[float]
    left: list[float]
    total: Array


def answer(items: Sequence[Item], statuses: Sequence[Status], inverse: Array) -> Answer:
    """The multipliers when each item has its status. `inverse` holds the inverse masses."""
    total, sliding = np.zeros(len(inverse)), dict[int, Array]()
    for item, status in zip(items, statuses, strict=True):
        if status in SLIPS:
            force = -item.kinetic * SLIPS[status] * item.row
            if item.pressed < 0:
                total = total + item.given * force
            else:
                sliding[item.pressed] = force
    multipliers = [0.0] * len(items)
    active = [i for i, status in enumerate(statuses) if status in ("on", "stick")]
    if active:
        rows = np.array([items[i].row for i in active])
        columns = np.array([items[i].row + sliding[i] if i in sliding else items[i].row for i in active])
        across = rows * inverse
        wanted = -(np.array([items[i].bias for i in active]) + across @ total)
        solved = _solved(across @ columns.T, wanted, np.array([items[i].rub for i in active]))
        total = total + columns.T @ solved
        for i, z in zip(active, solved.tolist(), strict=True):
            multipliers[i] = z
    change = inverse * total
    return Answer(multipliers, [item.bias + float(item.row @ change) for item in items], total)


def _solved(matrix: Array, wanted: Array, rubs: NDArray[np.bool_]) -> Array:
    """The multipliers; where several could hold the same, what is rigid does, and friction only what is left."""
    size = np.sqrt(np.abs(matrix.diagonal()))
    if size.all() and abs(float(np.linalg.det(matrix / size / size[:, None]))) > DEPENDENT:
        return np.asarray(np.linalg.solve(matrix, wanted), dtype=np.float64)
    found, holds = np.zeros(len(wanted)), np.ones(len(wanted), dtype=bool)
    if rubs.any() and np.linalg.matrix_rank(matrix[:, ~rubs], RANK) == np.linalg.matrix_rank(matrix, RANK):
        holds = ~rubs
    found[holds] = np.linalg.lstsq(matrix[:, holds], wanted, rcond=RANK)[0]
    return found


def most_held(items: Sequence[Item], found: Answer, i: int) -> float:
    """The most (N) that a rub can hold before it slips."""
    return items[i].static * _normal_force(items, found, i)


def _normal_force(items: Sequence[Item], found: Answer, i: int) -> float:
    item = items[i]
    return item.given if item.pressed < 0 else found.multipliers[item.pressed]


def settled(items: Sequence[Item], inverse: Array, where: str) -> tuple[Status, ...]:
    """The first combination of statuses that is consistent: what presses and what sticks is tried first.

    Raises GuardFailed when there is none, or when there are too many to try.
    """
    names = ", ".join(item.name for item in items)
    if math.prod(len(item.may) for item in items) > MOST_COMBINATIONS:
        raise GuardFailed(f"{where}: too many things rest on each other at once ({names}).")
    for statuses in _combinations(items):
        if _consistent(items, statuses, answer(items, statuses, inverse), inverse):
            return statuses
    raise GuardFailed(
        f"{where}: no forces of rigid bodies obey Coulomb's law here ({names}); give the contact a stiffness instead."
    )


def _combinations(items: Sequence[Item]) -> Iterator[tuple[Status, ...]]:
    """All that items may do together; what nothing presses does not rub."""
    for statuses in product(*(item.may for item in items)):
        if all(
            (status == "off") == (statuses[item.pressed] == "off")
            for item, status in zip(items, statuses, strict=True)
            if item.rub and item.pressed >= 0
        ):
            yield statuses


def _consistent(items: Sequence[Item], statuses: Sequence[Status], found: Answer, inverse: Array) -> bool:
    """Whether what was found for a combination obeys complementarity and Coulomb's law."""
    # Along rows: how fast something turns is no speed.
    change = np.abs(inverse * found.total)
    fast = max(max(abs(item.bias), float(np.abs(item.row) @ change)) for item in items)
    strong = max(
        max(abs(z), item.given * item.static) for item, z in zip(items, found.multipliers, strict=True)
    )
    # What is left of frictions that cancel is nothing to what friction can hold.
    fast = max(fast, 1e-8 * max(item.given * item.static * item.yields(inverse) for item in items))
    for i, (item, status) in enumerate(zip(items, statuses, strict=True)):
        z, w = found.multipliers[i], found.left[i]
        if status == "stick":
            if abs(w) > 1e-6 * fast or abs(z) > most_held(items, found, i) + NOISE * strong:
                return False
        elif status in SLIPS:
            if "stick" in item.may and SLIPS[status] * w < -NOISE * fast:
                return False
        elif item.rub or item.two_sided:
            continue
        elif status == "on":
            if z < -NOISE * strong or abs(w) > 1e-6 * fast:
                return False
        elif len(item.may) > 1 and w < -NOISE * fast:
            return False
    return True


Slope = Callable[[float, Array], list[float]]


@dataclass(frozen=True, slots=True)
class Mode:
    """The status of each constraint and of each rub; which pairs touch; on which side of its event each force is."""

    held: tuple[Status, ...]
    rubbed: tuple[Status, ...]
    touching: tuple[bool, ...]
    sides: tuple[float, ...]


def served(scene: Scene) -> list[tuple[ContactForce, int, int]]:
    """Every two bodies that a contact acts between; a mode tells in this order which touch."""
    return [(force, a, b) for force in scene.contacts for a, b in force.serves(scene)]


class System:
    """A scene taken apart once: its constraints, rubs, contacts and events in lists, so that a mode can name them by number.

    There are `count` places, and as many velocities; `always` are the forces that need no touch, `heavy` the masses (kg) at the start, of
    bodies, and `each` of the components of their velocities.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene, self.count = scene, scene.axes * len(scene.bodies)
        self.heavy, self.evaluations = [body.mass for body in scene.bodies], 0
        self.each = [mass for mass in self.heavy for _ in range(scene.axes)]
        self.constraints: list[Constraint] = []
        self.rubs: list[Rub] = []
        self.pressed = list[int]()
        self.always = [force for force in scene.forces if not isinstance(force, ContactForce)]
        self.contacts = served(scene)
        for force in scene.forces:
            held = list(force.constraints(scene))
            first = len(self.constraints)
            self.constraints += held
            for rub in force.rubs(scene, held):
                self.rubs.append(rub)
                self.pressed.append(next((first + i for i, c in enumerate(held) if c is rub.pressed), -1))
        self.events = [event for force in scene.forces for event in force.events(scene)]
        self.changing = [each for force in scene.forces for each in force.mass_rates]
        self.fixed: Array | None = None
        self.steady: list[float] = self.inverse(0.0).tolist()

    def velocity(self, y: State) -> State:
        """The generalized velocity in a state: velocities, then spins."""
        return y[self.count :]

    def masses(self, time: float) -> list[float]:
        """The masses (kg) after what has been burnt and taken up."""
        if not self.changing:
            return self.heavy
        masses = list(self.heavy)
        for i, rate in self.changing:
            masses[i] += rate * time
        return masses

    def inverse(self, time: float) -> Array:
        """One over mass or moment of inertia, for each component of the generalized velocity."""
        if not self.changing and self.fixed is not None:
            return self.fixed
        straight = [1.0 / m for m in self.masses(time) for _ in range(self.scene.axes)]
        turned = [1.0 / body.resists_spin for body in self.scene.bodies] if self.scene.spins else []
        self.fixed = np.array(straight + turned)
        return self.fixed

    def gains(
        self, time: float, y: State, since: State, touching: Sequence[bool] | None = None
    ) -> list[float]:
        """The acceleration of each component of the generalized velocity if nothing held or rubbed.

        With `touching`, pairs that do not touch in a mode do not push, even where a trial step reaches into them.
        """
        axes = self.scene.axes
        masses = self.masses(time)
        sums = [0.0] * (len(y) - self.count)
        for i, newtons in self._pushes(time, y, masses, since, touching):
            for axis, newton in enumerate(newtons):
                sums[axes * i + axis] += newton
        each = [mass for mass in masses for _ in range(axes)] if self.changing else self.each
        sums[: self.count] = [0.0 if m == math.inf else f / m for f, m in zip(sums, each, strict=False)]
        return sums

    def _pushes(
        self,
        time: float,
        y: State,
        masses: Sequence[float],
        since: State,
        touching: Sequence[bool] | None,
    ) -> Iterator[tuple[int, Sequence[float]]]:
        for force in self.scene.forces if touching is None else self.always:
            yield from force.act_at(self.scene, time, y, masses, since)
        if touching is not None:
            for (force, a, b), on in zip(self.contacts, touching, strict=True):
                if on:
                    yield from opposite(a, b, force.between(self.scene, y, a, b))

    def items(self, time: float, y: State, gained: Sequence[float], mode: Mode) -> list[Item]:
        """What holds or rubs in a mode, as the rows of its linear equations. Their statuses are those of `statuses`."""
        gains, found, place = np.asarray(gained), list[Item](), dict[int, int]()
        for i, (constraint, status) in enumerate(zip(self.constraints, mode.held, strict=True)):
            if status == "on":
                place[i] = len(found)
                found.append(self.held_item(time, y, gains, constraint, ("on",)))
        for k, status in enumerate(mode.rubbed):
            if status != "off":
                found.append(self.rub_item(time, gains, k, (status,), place.get(self.pressed[k], -1)))
        return found

    def held_item(
        self, time: float, y: State, gains: Array, constraint: Constraint, may: tuple[Status, ...]
    ) -> Item:
        """A constraint as a row of accelerations."""
        row = np.array(constraint.row(time, y))
        bias = float(row @ gains) + constraint.drift(time, y)
        return Item(constraint.name, row, bias, may, two_sided=constraint.two_sided)

    def rub_item(self, time: float, gains: Array, k: int, may: tuple[Status, ...], pressed: int) -> Item:
        """One rub as a row of accelerations."""
        rub, row = self.rubs[k], np.array(self.rubs[k].row)
        given = rub.normal(time) if rub.normal else 0.0
        item = Item(rub.name, row, float(row @ gains), may, rub=True, pressed=pressed, given=given)
        item.kinetic, item.static = rub.kinetic, rub.static
        return item

    def slip(self, y: State, k: int) -> float:
        """The slip velocity (m/s) of a rub."""
        return sum(map(mul, self.rubs[k].row, self.velocity(y)))

    def rate(self, time: float, y: State, constraint: Constraint) -> float:
        """How fast a gap grows (m/s)."""
        return sum(map(mul, constraint.row(time, y), self.velocity(y)))

    def _braked(self, time: float, mode: Mode, gained: list[float]) -> None:
        """Add to the accelerations what the slips of a mode take, all under a known normal force."""
        inverse = self.inverse(time) if self.changing else self.steady
        for rub, status in zip(self.rubs, mode.rubbed, strict=True):
            if status in SLIPS and rub.normal is not None:
                brake = SLIPS[status] * rub.kinetic * rub.normal(time)
                for j, x in enumerate(rub.row):
                    if x:
                        gained[j] -= brake * x * inverse[j]

    def _held_by_one(self, time: float, y: State, constraint: Constraint, gained: list[float]) -> None:
        """Add to the accelerations what a single constraint takes; nothing where it holds nothing that moves."""
        inverse = self.inverse(time).tolist() if self.changing else self.steady
        row = constraint.row(time, y)
        moved = list(map(mul, row, inverse))
        resists = sum(map(mul, row, moved))
        if resists == 0.0:
            return
        bias = sum(map(mul, row, gained)) + constraint.drift(time, y)
        for j, m in enumerate(moved):
            gained[j] -= bias / resists * m

    def clusters(
        self, time: float, y: State, constraints: Sequence[int], rubs: Sequence[int]
    ) -> Iterator[tuple[list[int], list[int]]]:
        """What has to be settled together, constraints and rubs by number: no group has a movable body in common with another."""
        movable = self.inverse(time) > 0.0
        nodes = [(i, -1) for i in constraints] + [(-1, k) for k in rubs]
        rows = [self.constraints[i].row(time, y) if k < 0 else self.rubs[k].row for i, k in nodes]
        # A velocity row across a wall reaches the body's other components, too: what it shares is the body.
        bodies = [
            frozenset(self._body(j) for j in np.flatnonzero(np.array(row) * movable).tolist()) for row in rows
        ]
        left = list(range(len(nodes)))
        while left:
            group = [left.pop(0)]
            reached = set(bodies[group[0]])
            while more := [j for j in left if reached & bodies[j]]:
                group += more
                left = [j for j in left if j not in more]
                reached.update(*(bodies[j] for j in more))
            yield (
                [nodes[j][0] for j in group if nodes[j][1] < 0],
                [nodes[j][1] for j in group if nodes[j][1] >= 0],
            )

    def _body(self, component: int) -> int:
        """The body to which a component of the generalized velocity belongs."""
        return component // self.scene.axes if component < self.count else component - self.count

    def held(self, time: float, y: State, since: State, mode: Mode) -> tuple[list[Item], Answer, list[float]]:
        """What holds in a mode, with which forces; and the accelerations without them."""
        gained = self.gains(time, y, since, mode.touching)
        items = self.items(time, y, gained, mode)
        return items, answer(items, [item.may[0] for item in items], self.inverse(time)), gained

    def accelerations(self, time: float, y: State, mode: Mode) -> Array:
        """Of each component of the generalized velocity in a mode (m/s^2)."""
        _, found, gained = self.held(time, y, y, mode)
        return np.asarray(gained) + self.inverse(time) * found.total

    def slope(self, mode: Mode, since: State, begun: float) -> Slope:
        """The rate of change of the state in a mode, at a time counted from `begun`."""
        on = [c for c, s in zip(self.constraints, mode.held, strict=True) if s == "on"]
        # Nothing sticks, and what slips is pressed by a known force: what it takes is known before anything holds.
        brakes = all(
            s == "off" or (s != "stick" and rub.normal is not None)
            for rub, s in zip(self.rubs, mode.rubbed, strict=True)
        )

        def rates(time: float, state: Array) -> list[float]:
            self.evaluations += 1
            y: list[float] = state.tolist()
            try:
                return [*y[self.count : 2 * self.count], *accelerations(begun + time, y)]
            except (
                OverflowError,
                ZeroDivisionError,
                NoForce,
            ):  # a stage thrown out too far: its step is not taken
                return [math.nan] * len(y)
            except ValueError as error:
                if isinstance(error, BadSetting) or not any(map(is_own, self.scene.forces)):
                    raise
                return [math.nan] * len(y)

        def accelerations(time: float, y: list[float]) -> list[float]:
            gained = self.gains(time, y, since, mode.touching)
            if brakes and len(on) <= 1:
                self._braked(time, mode, gained)
                for constraint in on:
                    self._held_by_one(time, y, constraint, gained)
                return gained
            items = self.items(time, y, gained, mode)
            found = answer(items, [item.may[0] for item in items], self.inverse(time))
            return (np.asarray(gained) + self.inverse(time) * found.total).tolist()

        return rates
