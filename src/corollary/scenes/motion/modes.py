"""Mode that holds from a moment on: places and velocities put back on what holds them, hits settled, then contacts and friction."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from corollary.scenes.motion.contact_forces import SLIPS, Array, Item, Status, answer, settled
from corollary.scenes.motion.equations_of_motion import Mode, System
from corollary.scenes.motion.sizes import Sizes, last_digit
from corollary.scenes.run import GuardFailed

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
