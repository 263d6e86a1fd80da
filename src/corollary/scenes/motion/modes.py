"""Mode that holds from a moment on: hits settled, contacts and friction; and the guards that tell when it ends."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from corollary.scenes.body import State, inside
from corollary.scenes.integrate.contact_motion import NEAREST
from corollary.scenes.motion.equations_of_motion import (
    SLIPS,
    Array,
    Item,
    Mode,
    Status,
    System,
    answer,
    most_held,
    settled,
)
from corollary.scenes.motion.path import Stretch, minima
from corollary.scenes.motion.sizes import Sizes, last_digit
from corollary.scenes.run import GuardFailed
from corollary.scenes.scene import pairs, seen_from

MOST_HITS = 100
"""So many hits at one moment are followed: a rough wall may throw a body against the one beside it."""


def settle_hits(system: System, time: float, y: list[float], near: Sequence[int], slow: float) -> int:
    """Change the velocities in a state where what is `near` is hit, faster than is `slow` (m/s); how many hits there are.

    Raises GuardFailed where no impulses of rigid bodies are consistent, or hits do not end.
    """
    hits = _hit(system, time, y, near, slow)
    while hits and (more := _hit(system, time, y, near, slow)):
        hits += more
        if hits > MOST_HITS:
            raise GuardFailed(
                f"at {time:.6g} s bodies hit what holds them more than {MOST_HITS} times at once."
            )
    return hits


def _hit(system: System, time: float, y: list[float], near: Sequence[int], slow: float) -> int:
    """Settle what is hit at once; how much that is."""
    inverse, hits = system.inverse(time), 0
    rates = {i: system.rate(time, y, system.constraints[i]) for i in near}
    closing = {i for i in near if rates[i] < -slow and not system.constraints[i].two_sided}
    if not closing:
        return 0
    pressed = [i for i in near if system.constraints[i].two_sided or rates[i] <= slow]
    for group, _ in system.clusters(time, y, pressed, []):
        if closing.isdisjoint(group):
            continue
        hits += len(closing.intersection(group))
        items: list[Item] = []
        for i in group:
            c, rate = system.constraints[i], rates[i]
            bias = rate * (1.0 + c.gives_back(time)) if rate < 0.0 and not c.two_sided else rate
            may: tuple[Status, ...] = ("on",) if c.two_sided else ("on", "off")
            items.append(Item(c.name, np.array(c.row(time, y)), bias, may, two_sided=c.two_sided))
        for k, rub in enumerate(system.rubs):
            if system.pressed[k] in group:
                row, slip, at = np.array(rub.row), system.slip(y, k), group.index(system.pressed[k])
                rubs = Item(rub.name, row, slip, ("stick", "forward", "back", "off"), rub=True, pressed=at)
                rubs.kinetic = rubs.static = rub.kinetic
                items.append(rubs)
        statuses = settled(items, inverse, f"at {time:.6g} s")
        change = inverse * answer(items, statuses, inverse).total
        for j, v in enumerate(change.tolist(), start=system.count):
            y[j] += v
    return hits


def small_bounces(
    system: System, time: float, y: list[float], near: Sequence[int], mode: Mode, sizes: Sizes
) -> dict[int, tuple[float, float]]:
    """Of what is `near` the constraints that open so slowly under what presses them that their bounces are lower than is looked at: they rest.

    Bounce after bounce, each lower by the square of the restitution, ends after a finite time: that is not waited for. Each with how fast
    (m/s) it opens and how long (s) its bounces would have taken.
    """
    opening = {
        i: rate
        for i in near
        if not (c := system.constraints[i]).two_sided
        and mode.held[i] == "off"
        and (rate := system.rate(time, y, c)) > sizes.speed
        and c.restitution < 1.0
    }
    if not opening:
        return {}
    # Where bodies have got to places are not known as finely as where they began.
    low = max(sizes.bounce, 64.0 * last_digit(y[: system.count]))
    acceleration = system.accelerations(time, y, mode)
    slow: dict[int, tuple[float, float]] = {}
    for i, rate in opening.items():
        c = system.constraints[i]
        pulled = float(np.array(c.row(time, y)) @ acceleration) + c.drift(time, y)
        if pulled < 0.0 and rate * rate < -2.0 * pulled * low:
            slow[i] = rate, -2.0 * rate / pulled / (1.0 - c.restitution)
    return slow


# So many last digits of places and velocities are what rounding leaves of none.
LAST_DIGITS = 16.0


def held_in(mode: Mode) -> tuple[list[int], list[int]]:
    """The constraints that hold in a mode, and the rubs that stick."""
    return (
        [i for i, s in enumerate(mode.held) if s == "on"],
        [i for i, s in enumerate(mode.rubbed) if s == "stick"],
    )


def project(
    system: System,
    time: float,
    y: list[float],
    constraints: Sequence[int],
    rubs: Sequence[int],
) -> None:
    """Take out of the places and velocities what rounding and steps left against what holds."""
    _put_on(system, time, y, constraints)
    inverse, rows = system.inverse(time), [system.constraints[i].row(time, y) for i in constraints]
    speeds = [system.rate(time, y, system.constraints[i]) for i in constraints]
    rows += [system.rubs[k].row for k in rubs]
    speeds += [system.slip(y, k) for k in rubs]
    if rows:
        matrix = np.array(rows)
        change = inverse * (matrix.T @ _solved(matrix, inverse, speeds))
        for j, v in enumerate(change.tolist(), start=system.count):
            y[j] -= v


def drifted(system: System, time: float, y: list[float], mode: Mode, sizes: Sizes, part: float) -> bool:
    """Whether steps have moved bodies off what holds them by more than such a part of the sizes of the scene, and than rounding does."""
    far = max(part * sizes.place, LAST_DIGITS * last_digit(y[: system.count]))
    fast = max(part * sizes.fast, LAST_DIGITS * last_digit(system.velocity(y)))
    return any(
        abs(c.gap(time, y)) > far or abs(system.rate(time, y, c)) > fast
        for c, status in zip(system.constraints, mode.held, strict=True)
        if status == "on"
    )


def push_out(
    system: System, time: float, y: list[float], near: Sequence[int], held: Sequence[int], rubs: Sequence[int]
) -> None:
    """Places that rounding left a little behind what stops them, of what is `near`, are put upon it; what is `held`, or sticks, stays so."""
    known = system.constraints
    behind = [i for i in near if i not in held and not known[i].two_sided and known[i].gap(time, y) < 0.0]
    if behind:
        _put_on(system, time, y, [*held, *behind])
        project(system, time, y, held, rubs)


def _put_on(system: System, time: float, y: list[float], constraints: Sequence[int]) -> None:
    """Close the gaps of constraints, twice, for they may bend."""
    if not constraints:
        return
    weights = system.inverse(time).copy()
    weights[system.count :] = 0.0
    for _ in range(2):
        gaps = [system.constraints[i].gap(time, y) for i in constraints]
        matrix = np.array([system.constraints[i].row(time, y) for i in constraints])
        moved = weights * (matrix.T @ _solved(matrix, weights, gaps))
        for j, x in enumerate(moved.tolist()[: system.count]):
            y[j] -= x


def _solved(matrix: Array, inverse: Array, right: Sequence[float]) -> Array:
    """Multipliers; each equation in its own unit, for a light body's is not to drown that of a heavy one."""
    across = (matrix * inverse) @ matrix.T
    units = np.sqrt(across.diagonal())
    units[units == 0.0] = 1.0
    scaled = np.linalg.lstsq(across / units / units[:, None], np.array(right) / units, rcond=1e-12)[0]
    return np.asarray(scaled / units, dtype=np.float64)


# Such a part of what is too slow to be seen is rounding.
ROUNDED = 0.01


@dataclass(slots=True)
class Moment:
    """A moment at which the law may change: the state is corrected in place, `before` is the mode until then.

    `barred` are constraints that must let go and `broken` rubs that must slip, because that is why the moment came, `stopped` are rubs that
    have just stopped slipping. `hits` counts what was hit; `dropped` is the speed (m/s) taken for none; bounces left out would last
    for `lasts` (s).
    """

    system: System
    time: float
    y: list[float]
    sizes: Sizes
    before: Mode | None = None
    barred: frozenset[int] = frozenset()
    broken: dict[int, Status] = field(default_factory=dict[int, Status])
    stopped: frozenset[int] = frozenset()
    hits: int = 0
    dropped: float = 0.0
    lasts: float = 0.0

    def decided(self, touching: Sequence[bool], sides: Sequence[float]) -> Mode:
        """Settle hits, then what holds. Raises GuardFailed where no forces of rigid bodies are consistent."""
        system, time, y = self.system, self.time, self.y
        # What has been held until now, steps have left a little off.
        held: tuple[list[int], list[int]] = held_in(self.before) if self.before else ([], [])
        project(system, time, y, *held)
        push_out(system, time, y, self._near(), *held)
        slipping = self._slipping()
        self.hits += settle_hits(system, time, y, self._near(), self.sizes.speed)
        self.stopped |= slipping - self._slipping()
        mode = self._settled_forces(touching, sides)
        resting: set[int] = set()
        for _ in range(len(system.constraints) + 1 if self.hits else 0):
            slow = small_bounces(system, time, y, self._near(), mode, self.sizes)
            if not slow:
                break
            self.dropped = max(self.dropped, *(rate for rate, _ in slow.values()))
            self.lasts = max(self.lasts, *(lasts for _, lasts in slow.values()))
            # What brings one to rest must not set another moving.
            resting |= {*slow, *held_in(mode)[0]}
            project(system, time, y, sorted(resting), [])
            mode = self._settled_forces(touching, sides)
        project(system, time, y, *held_in(mode))
        return mode

    def _near(self) -> list[int]:
        """The constraints whose gap is closed, as far as the places tell, which may have got far from where they began."""
        known = enumerate(self.system.constraints)
        near = max(self.sizes.gap, 16.0 * last_digit(self.y[: self.system.count]))
        return [i for i, c in known if c.two_sided or c.gap(self.time, self.y) <= near]

    def _slipping(self) -> frozenset[int]:
        """The rubs that slip in the mode until now, fast enough to be seen."""
        rubbed = enumerate(self.before.rubbed if self.before else ())
        return frozenset(k for k, status in rubbed if status in SLIPS and self._seen(k))

    def _seen(self, k: int) -> bool:
        return abs(self.system.slip(self.y, k)) > self.sizes.speed

    def _settled_forces(self, touching: Sequence[bool], sides: Sequence[float]) -> Mode:
        system, time, y = self.system, self.time, self.y
        held: list[Status] = ["off"] * len(system.constraints)
        rubbed: list[Status] = ["off"] * len(system.rubs)
        resting = [
            i
            for i in self._near()
            if (c := system.constraints[i]).two_sided or system.rate(time, y, c) <= self.sizes.speed
        ]
        gains = np.array(system.gains(time, y, y, touching))
        rubbing = [k for k, rub in enumerate(system.rubs) if rub.normal or system.pressed[k] in resting]
        for group, rubs in system.clusters(time, y, resting, rubbing):
            statuses = settled(self._items(group, rubs, gains), system.inverse(time), f"at {time:.6g} s")
            for i, status in zip(group, statuses, strict=False):
                held[i] = status
            for k, status in zip(rubs, statuses[len(group) :], strict=True):
                rubbed[k] = status
        return Mode(tuple(held), tuple(rubbed), tuple(touching), tuple(sides))

    def _items(self, group: Sequence[int], rubs: Sequence[int], gains: Array) -> list[Item]:
        """What could hold or rub, with what it may do."""
        system, items = self.system, list[Item]()
        for i in group:
            constraint = system.constraints[i]
            may: tuple[Status, ...] = ("on",) if constraint.two_sided else ("on", "off")
            may = ("off",) if i in self.barred else may
            items.append(system.held_item(self.time, self.y, gains, constraint, may))
        for k in rubs:
            pressed = group.index(system.pressed[k]) if system.pressed[k] >= 0 else -1
            may = self._ways(k) + (("off",) if pressed >= 0 else ())
            items.append(system.rub_item(self.time, gains, k, may, pressed))
        return items

    def _ways(self, k: int) -> tuple[Status, ...]:
        """How a rub may go on: as it slips, or, where it does not slip, held or beginning to slip."""
        slip, before = self.system.slip(self.y, k), self.before.rubbed[k] if self.before else "stick"
        if self._seen(k) and k not in self.stopped:
            return ("forward" if slip > 0.0 else "back",)
        if k in self.broken:
            return (self.broken[k],)
        # One that has just begun to slip goes on, though rounding may have it slip back.
        if before in SLIPS and k not in self.stopped and SLIPS[before] * slip > -ROUNDED * self.sizes.speed:
            return (before,)
        return "stick", "forward", "back"


Value = Callable[[float, State], float]
Kind = Literal["touch", "overlap", "soft", "hit", "event", "release", "break", "stop"]
# By such a part of what errors decide a parting is seen late: an overlap that fades away ends by errors alone.
SEEN_LATE = 0.1
# Such a part of a force decides nothing; and such a part of others that are found together with it.
TRIFLE, SHARED_TRIFLE = 1e-9, 1e-13


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
            max(TRIFLE * each, SHARED_TRIFLE * others, 1e-300)
            for each, others in zip(own, together, strict=True)
        ]


def _alone(item: Item, inverse: Array) -> float:
    """The force (N) with which an item would hold what pulls at it if nothing else held."""
    resists = item.yields(inverse)
    return abs(item.bias) / resists if resists > 0.0 else 0.0
