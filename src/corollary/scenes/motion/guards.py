"""Guards of a mode: functions of the state that are positive while it lasts, and fall through zero when something happens."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from corollary.scenes.body import inside
from corollary.scenes.constraint import State
from corollary.scenes.integrate.contact_motion import NEAREST
from corollary.scenes.motion.contact_forces import SLIPS, Array, Item, Status, most_held
from corollary.scenes.motion.equations_of_motion import Mode, System
from corollary.scenes.motion.first_root import minima
from corollary.scenes.motion.path import Stretch
from corollary.scenes.motion.sizes import Sizes
from corollary.scenes.scene import pairs, seen_from

Value = Callable[[float, State], float]
Kind = Literal["touch", "overlap", "soft", "hit", "event", "release", "break", "stop"]
# By such a part of what errors decide a parting is seen late: an overlap that fades away ends by errors alone.
SEEN_LATE = 0.1
# Such a part of a force decides nothing; and such a part of others that are found together with it.
TRIFLE, ROUNDED = 1e-9, 1e-13


@dataclass(frozen=True, slots=True)
class Guard:
    """`kind` and `number` say what happens when it falls: which contact, constraint, event or rub.

    It is seen to happen `late`, by so much of what the guard looks at.
    """

    kind: Kind
    number: int
    name: str
    late: float = 0.0


class Guards:
    """All guards of a mode, evaluated together."""

    def __init__(self, system: System, mode: Mode, since: list[float], begun: float, sizes: Sizes) -> None:
        self.system, self.mode, self.since, self.sizes = system, mode, since, sizes
        scene = system.scene
        self.late = 16.0 * math.ulp(sizes.long)
        """By so much (m) a hit is seen late: what has just bounced is not to hit again by rounding."""
        self.names: list[Guard] = []
        self.places: list[Value] = []
        served = {(a, b) for _, a, b in system.contacts}
        passing = {(min(p), max(p)) for p in scene.passes}
        for j, (_, a, b) in enumerate(system.contacts):
            reach = scene.bodies[a].radius + scene.bodies[b].radius
            self._pair("touch", j, a, b, 1.0 if mode.touching[j] else -1.0, reach)
            if mode.touching[j]:
                self._pair("soft", j, a, b, -1.0, NEAREST * reach)
        solid = [i for i, body in enumerate(scene.bodies) if body.radius > 0.0]
        for a, b in pairs(scene):
            if (a, b) not in served | passing and a in solid and b in solid:
                self._pair("overlap", 0, a, b, -1.0, scene.bodies[a].radius + scene.bodies[b].radius)
        for i, status in enumerate(mode.held):
            constraint = system.constraints[i]
            if status == "off" and not constraint.two_sided:
                self._add(
                    Guard("hit", i, constraint.name, self.late),
                    lambda t, y, c=constraint: c.gap(t, y) + self.late,
                )
        for j, (side, event) in enumerate(zip(mode.sides, system.events, strict=True)):
            slow = sizes.rest if event.of_speed else 0.0
            # A hit may have turned a speed since.
            if event.of_speed and event.value(since):
                side = math.copysign(1.0, event.value(since))
            self._add(
                Guard("event", j, "an event"),
                lambda t, y, side=side, event=event, slow=slow: side * event.value(y) + slow,
            )
        for k, status in enumerate(mode.rubbed):
            if status in SLIPS:
                late, way = 0.1 * sizes.speed, SLIPS[status]
                self._add(
                    Guard("stop", k, system.rubs[k].name, late),
                    lambda t, y, k=k, way=way, late=late: way * system.slip(y, k) + late,
                )
        held = [i for i, s in enumerate(mode.held) if s == "on"]
        self.presses = [(i, at) for at, i in enumerate(held) if not system.constraints[i].two_sided]
        active = [k for k, s in enumerate(mode.rubbed) if s != "off"]
        self.sticks = [(k, len(held) + at) for at, k in enumerate(active) if mode.rubbed[k] == "stick"]
        self.names += [Guard("release", i, system.constraints[i].name) for i, _ in self.presses]
        self.names += [Guard("break", k, system.rubs[k].name) for k, _ in self.sticks]
        self.trifles: list[float] = []
        if self.presses or self.sticks:
            self._measure(begun, held, active)

    def values(self, time: float, y: State) -> list[float]:
        """All guards in a state, in the order of `names`."""
        return [value(time, y) for value in self.places] + self._forces(time, y)

    def nearest(self, values: Array, states: Sequence[State]) -> tuple[float, float]:
        """How little (m) bodies that may hit or touch, sampled over a step, miss each other by, or reach into each other in passing; and
        after which part of it.

        Only turning points within the step count: a gap that has just opened, or is about to close, does not graze; nor does one
        between bodies that touch, which rounding alone bends, or that all but rest in each other.
        """
        chosen = [i for i, guard in enumerate(self.names) if guard.kind in ("hit", "touch")]
        least = math.inf, 0.0
        for i, gaps in zip(chosen, values[chosen], strict=True):
            if gaps.min() > 0.1 * np.ptp(gaps) or self.together(self.names[i], states):
                continue
            for part, value in minima(gaps):
                # What has just been let go opens with no speed: that is no touch.
                apart = abs(value) > 4.0 * self.sizes.blur
                if gaps[0] - value > 4.0 * self.sizes.blur or (apart and gaps[-1] > value):
                    least = min(least, (abs(value), part))
        return least

    def together(self, guard: Guard, states: Sequence[State]) -> bool:
        """Whether two bodies touch, but for errors, and are as fast as each other through a step: they go on so, whether they part or not."""
        if guard.kind != "touch":
            return False
        (_, a, b), scene, sizes = self.system.contacts[guard.number], self.system.scene, self.sizes
        reach, slow = scene.bodies[a].radius + scene.bodies[b].radius, sizes.doubt / sizes.place * sizes.fast
        seen = [seen_from(scene, y, a, b) for y in states]
        near = self.mode.touching[guard.number] or all(abs(inside(x, reach)) < sizes.doubt for x, _ in seen)
        return near and all(math.hypot(*v) < slow for _, v in seen)

    def one(self, index: int) -> Value:
        """A single guard as a function of time and state."""
        if index < len(self.places):
            return self.places[index]
        return lambda time, y: self._forces(time, y)[index - len(self.places)]

    def landing(self, index: int) -> Value:
        """What is zero where a guard's happening takes place.

        A hit takes place where the gap is closed, not where it was seen to be: a body that is let go from there, time and again, would
        gain the energy of the way between the two at each bounce. So does a stop where nothing slips any more.
        """
        one, late = self.one(index), self.names[index].late
        return (lambda t, y: one(t, y) - late) if late else one

    def undecided(self, guard: Guard, stretch: Stretch) -> bool:
        """Whether bodies stay at the very edge of a force, as two ends of a spring of some length that are pressed to one place."""
        if guard.kind != "event":
            return False
        event, least = self.system.events[guard.number], 8.0 * math.ulp(self.sizes.long)
        long_enough = stretch.lasts * self.sizes.fast > 1e3 * least
        stays = all(abs(event.value(y)) <= least for y in (stretch.before, stretch.after))
        return stays and long_enough and event.turn is None and not event.of_speed

    def broken(self, number: int, time: float, y: State) -> dict[int, Status]:
        """Which way a rub slips from now on that breaks loose: against the force that held it."""
        _, forces, _ = self.system.held(time, y, self.since, self.mode)
        at = next(at for k, at in self.sticks if k == number)
        return {number: "back" if forces.multipliers[at] > 0.0 else "forward"}

    def _pair(self, kind: Kind, number: int, a: int, b: int, sign: float, reach: float) -> None:
        """What touches parts where its overlap is over, and is seen to beyond what some steps may be off."""
        late = max(SEEN_LATE * self.sizes.doubt - self.sizes.blur, 0.0) if sign > 0.0 else 0.0
        blur = self.sizes.blur + late

        def value(time: float, y: State) -> float:
            return sign * inside(seen_from(self.system.scene, y, a, b)[0], reach) + blur

        self._add(Guard(kind, number, f"bodies {a} and {b}", self.sizes.blur + late), value)

    def _add(self, guard: Guard, value: Value) -> None:
        self.names.append(guard)
        self.places.append(value)

    def _forces(self, time: float, y: State) -> list[float]:
        if not (self.presses or self.sticks):
            return []
        items, forces, _ = self.system.held(time, y, self.since, self.mode)
        found = [forces.multipliers[at] + self.trifles[at] for _, at in self.presses]
        for _, at in self.sticks:
            most = most_held(items, forces, at)
            # Squares are as smooth as the forces; the sign of the normal force is not to be lost in one.
            margin = math.copysign(most * most, most) - forces.multipliers[at] ** 2
            found.append(margin + self.trifles[at] ** 2)
        return found

    def _measure(self, time: float, held: Sequence[int], active: Sequence[int]) -> None:
        """As the mode begins: forces (N) too small to decide about what presses and sticks.

        They are a part of what each holds, can hold, or would have to if it were alone, and of what rounding leaves of all that it holds
        together with.
        """
        items, found, _ = self.system.held(time, self.since, self.since, self.mode)
        inverse = self.system.inverse(time)
        limits = [most_held(items, found, at) if item.rub else 0.0 for at, item in enumerate(items)]
        own = [
            max(limit, abs(z), _alone(item, inverse))
            for item, z, limit in zip(items, found.multipliers, limits, strict=True)
        ]
        together = [0.0] * len(items)
        for constraints, rubs in self.system.clusters(time, self.since, held, active):
            group = [held.index(i) for i in constraints] + [len(held) + active.index(k) for k in rubs]
            for at in group:
                together[at] = max(own[each] for each in group)
        self.trifles = [
            max(TRIFLE * each, ROUNDED * others, 1e-300) for each, others in zip(own, together, strict=True)
        ]


def _alone(item: Item, inverse: Array) -> float:
    """The force (N) with which an item would hold what pulls at it if nothing else held."""
    resists = item.yields(inverse)
    return abs(item.bias) / resists if resists > 0.0 else 0.0
