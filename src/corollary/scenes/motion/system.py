"""The equations of motion of a scene: its forces, and the constraints and friction that hold at a moment."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from operator import mul

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.body import nothing_moves
from corollary.scenes.constraint import Constraint, Rub, State
from corollary.scenes.motion.multipliers import Answer, Item, Status, answer
from corollary.scenes.refused import is_own
from corollary.scenes.run import BadSetting, NoForce
from corollary.scenes.scene import ContactForce, Scene, opposite

Array = NDArray[np.float64]
Slope = Callable[[float, Array], list[float]]


@dataclass(frozen=True, slots=True)
class Mode:
    """What holds: the status of each constraint and of each rub; which pairs touch; on which side of its event each force is.

    `creeps` is, for each rub, a speed (m/s) far below all others: a slip of two components that begins from rest has no direction of its
    own until it is faster than that. From then on friction turns it to where it is pushed, at a rate mu g over its speed: what it was off
    before is forgotten.
    """

    held: tuple[Status, ...]
    rubbed: tuple[Status, ...]
    touching: tuple[bool, ...]
    sides: tuple[float, ...]
    creeps: tuple[float, ...] = ()


def moved_contacts(scene: Scene) -> list[tuple[ContactForce, int, int]]:
    """Every two bodies that a contact acts between, and that something moves; a mode tells in this order which touch."""
    served = [(force, a, b) for force in scene.contacts for a, b in force.serves(scene)]
    return [(f, a, b) for f, a, b in served if not nothing_moves(scene.bodies[a], scene.bodies[b])]


class System:
    """A scene taken apart once: its constraints, rubs, contacts and events in lists, so that a mode can name them by number.

    There are `count` places, and as many velocities; `always` are the forces that need no touch, `heavy` the masses (kg) at the start.
    Two bodies that nothing moves have no contact, though they may rub. `rival`: which of two motions open is taken.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene, self.count = scene, scene.axes * len(scene.bodies)
        self.heavy, self.evaluations = [body.mass for body in scene.bodies], 0
        self.rival: int | None = None
        self.constraints: list[Constraint] = []
        self.rubs: list[Rub] = []
        self.pressed, self.rub_contacts = list[int](), list[int]()
        self.always = [force for force in scene.forces if not isinstance(force, ContactForce)]
        self.contacts = moved_contacts(scene)
        for force in scene.forces:
            held = list(force.constraints(scene))
            first = len(self.constraints)
            self.constraints += held
            for rub in force.rubs(scene, held):
                self.rubs.append(rub)
                self.pressed.append(next((first + i for i, c in enumerate(held) if c is rub.pressed), -1))
                mine = (j for j, (f, a, b) in enumerate(self.contacts) if f is force and (a, b) == rub.bodies)
                self.rub_contacts.append(next(mine, -1))
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
        for j in range(self.count):
            mass = masses[j // axes]
            sums[j] = 0.0 if mass == math.inf else sums[j] / mass
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
        gains = np.asarray(gained)
        found: list[Item] = []
        place: dict[int, int] = {}
        for i, (constraint, status) in enumerate(zip(self.constraints, mode.held, strict=True)):
            if status == "on":
                row = np.array([constraint.row(time, y)])
                place[i] = len(found)
                bias = row @ gains + constraint.drift(time, y)
                found.append(Item(constraint.name, row, bias, ("on",), two_sided=constraint.two_sided))
        for i, status in enumerate(mode.rubbed):
            if status != "off":
                creep = mode.creeps[i] if mode.creeps else 0.0
                found.append(
                    self.rub_item(time, y, gains, i, (status,), place.get(self.pressed[i], -1), creep)
                )
        return found

    def rub_item(
        self,
        time: float,
        y: State,
        gains: Array,
        i: int,
        may: tuple[Status, ...],
        pressed: int,
        creep: float = 0.0,
    ) -> Item:
        """One rub as rows of accelerations; a slip of two components takes the direction it has now."""
        rub = self.rubs[i]
        rows = np.array(rub.rows(time, y))
        given = rub.normal(time, y) if rub.normal else 0.0
        if len(rows) == 2:
            may = tuple(self._way(time, y, i, s, creep) if isinstance(s, tuple) else s for s in may)
        bias = rows @ gains + np.array(rub.drift(time, y))
        return Item(
            rub.name,
            rows,
            bias,
            may,
            rub=True,
            pressed=pressed,
            given=given,
            kinetic=rub.kinetic,
            static=rub.static,
        )

    def _way(
        self, time: float, y: State, i: int, begun: tuple[float, ...], creep: float
    ) -> tuple[float, ...]:
        """The direction of a slip of two components that began in another.

        Past a stop, where a trial step may reach, it goes on as before: the force is then smooth through it, as the step is.
        """
        slip = [v + creep * b for v, b in zip(self.slip(time, y, i), begun, strict=True)]
        along = sum(a * b for a, b in zip(slip, begun, strict=True))
        speed = math.copysign(math.hypot(*slip), along)
        return tuple(v / speed for v in slip) if speed else begun

    def slip(self, time: float, y: State, i: int) -> list[float]:
        """The slip velocity (m/s) of a rub, by components."""
        rub, u = self.rubs[i], self.velocity(y)
        return [
            sum(map(mul, row, u)) - driven for row, driven in zip(rub.rows(time, y), rub.driven, strict=True)
        ]

    def rate(self, time: float, y: State, constraint: Constraint) -> float:
        """How fast a gap grows (m/s)."""
        row = constraint.row(time, y)
        return sum(map(mul, row, self.velocity(y))) + constraint.driven(time)

    def _braked(self, time: float, y: State, mode: Mode, gained: list[float]) -> None:
        """Add to the accelerations what the slips of a mode take, all under a known normal force."""
        inverse = self.inverse(time) if self.changing else self.steady
        for i, status in enumerate(mode.rubbed):
            rub = self.rubs[i]
            if isinstance(status, tuple) and rub.normal is not None:
                creep = mode.creeps[i] if mode.creeps else 0.0
                way = self._way(time, y, i, status, creep) if len(status) == 2 else status
                brake = rub.kinetic * rub.normal(time, y)
                for row, part in zip(rub.rows(time, y), way, strict=True):
                    for j, x in enumerate(row):
                        if x:
                            gained[j] -= brake * part * x * inverse[j]

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
        moved: list[Array] = []
        for i, k in nodes:
            rows = [self.constraints[i].row(time, y)] if k < 0 else self.rubs[k].rows(time, y)
            moved.append((np.abs(np.array(rows)).sum(axis=0) > 0.0) & movable)
        # A velocity row across a wall reaches the body's other components, too: what it shares is the body.
        bodies = [frozenset(self._body(j) for j in np.flatnonzero(each).tolist()) for each in moved]
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
                self._braked(time, y, mode, gained)
                for constraint in on:
                    self._held_by_one(time, y, constraint, gained)
                return gained
            items = self.items(time, y, gained, mode)
            found = answer(items, [item.may[0] for item in items], self.inverse(time), fair=False)
            return (np.asarray(gained) + self.inverse(time) * found.total).tolist()

        return rates
