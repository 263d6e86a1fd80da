"""What holds from a moment on: hits are settled first, then which contacts press and which surfaces stick, body by body."""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

import numpy as np

from corollary.scenes.motion.complementarity import consistent
from corollary.scenes.motion.hits import rub_less, settle_hits, small_bounces, speeds
from corollary.scenes.motion.multipliers import Item, Status, answer
from corollary.scenes.motion.onset import beginning
from corollary.scenes.motion.path import Doubt
from corollary.scenes.motion.projection import held_in, project, push_out, same_twice
from corollary.scenes.motion.reversal import just_begun, left_over, not_yet, slid, unseen
from corollary.scenes.motion.rivals import rivals
from corollary.scenes.motion.sizes import Sizes, last_digit
from corollary.scenes.motion.system import Array, Mode, System
from corollary.scenes.motion.ties import crowded, tied
from corollary.scenes.run import GuardFailed

# So far ahead, in times that what is fast takes through the scene, bodies have begun to move.
AHEAD = 1e-2


@dataclass(slots=True)
class Moment:
    """A moment at which the law may change: the state is corrected in place, `mode` says what holds from then on.

    `barred` are constraints that must let go and rubs that must slip (with the direction of the force that held them), because
    that is why the moment came, `stopped` are rubs that have just stopped slipping; `before` is the mode until then. `looks_ahead`: what
    holds is decided by what comes next, where it is not by what is. `hits` counts what was hit, `doubts` are what errors decide; `dropped` is the
    speed (m/s) taken for none, `calmed` that of a slip; bounces left out would last for `lasts` (s), and leave slips off by `astray` (m/s).
    """

    system: System
    time: float
    y: list[float]
    sizes: Sizes
    before: Mode | None = None
    barred_constraints: frozenset[int] = frozenset()
    barred_rubs: dict[int, tuple[float, ...]] = field(default_factory=dict[int, tuple[float, ...]])
    stopped: frozenset[int] = frozenset()
    looks_ahead: bool = True
    hits: int = 0
    doubts: set[Doubt] = field(default_factory=set[Doubt])
    dropped: float = 0.0
    calmed: float = 0.0
    lasts: float = 0.0
    astray: float = 0.0

    def decided(self, touching: Sequence[bool], sides: Sequence[float]) -> Mode:
        """Settle hits, then what holds. Raises GuardFailed where no forces of rigid bodies are consistent."""
        if self.barred_rubs and (helped := self._helped(touching, sides)) is not None:
            return helped
        # What has been held until now, steps have left a little off.
        held: tuple[list[int], list[int]] = held_in(self.before) if self.before else ([], [])
        project(self.system, self.time, self.y, *held)
        push_out(self.system, self.time, self.y, self._near(), *held)
        self.doubts |= crowded(self.system, self.time, self.y, self._near(), self.sizes)
        slipping = slid(self.system, self.time, self.y, self.before, self.sizes.speed)
        self.hits += settle_hits(self.system, self.time, self.y, self._near(), self.sizes.speed)
        self.stopped |= {k for k in slipping if unseen(self.system, self.time, self.y, k, self.sizes.speed)}
        mode = self._at_rest(touching, sides) or self._settle_forces(touching, sides)
        resting: set[int] = set()
        for _ in range(len(self.system.constraints) + 1 if self.hits else 0):
            slow = small_bounces(self.system, self.time, self.y, self._near(), mode, self.sizes)
            if not slow:
                break
            self.dropped = max(self.dropped, *(rate for rate, _ in slow.values()))
            self.lasts = max(self.lasts, *(lasts for _, lasts in slow.values()))
            # What brings one to rest must not set another moving: two strings would wake each other for ever.
            resting |= {*slow, *held_in(mode)[0]}
            project(self.system, self.time, self.y, sorted(resting), [])
            mode = self._settle_forces(touching, sides)
            self.astray += rub_less(self.system, self.time, self.y, mode, slow)
        project(self.system, self.time, self.y, *held_in(mode))
        if self.before is not None and mode.creeps:
            for k, extra in left_over(self.system, self.time, self.y, self.before, mode):
                project(self.system, self.time, self.y, held_in(mode)[0], [k], extra)
        return mode

    def _helped(self, touching: Sequence[bool], sides: Sequence[float]) -> Mode | None:
        """The mode in which what has only touched until now helps to hold what would have begun to slip: a string that was about to be taut."""
        assert self.before is not None
        idle = [i for i in self._resting() if self.before.held[i] == "off"]
        if not idle:
            return None
        moment = replace(self, barred_rubs={}, y=list(self.y), doubts=set[Doubt]())
        with suppress(GuardFailed):
            mode = moment.decided(touching, sides)
            slips = [k for k in self.barred_rubs if self.before.rubbed[k] == "stick" != mode.rubbed[k]]
            if not slips and any(mode.held[i] == "on" for i in idle):
                self.y[:], self.doubts, self.hits = moment.y, moment.doubts, moment.hits
                self.dropped, self.lasts, self.astray = moment.dropped, moment.lasts, moment.astray
                self.calmed = moment.calmed
                return mode
        return None

    def _resting(self) -> list[int]:
        """The constraints that could hold: closed, and not opening."""
        return [
            i
            for i in self._near()
            if (c := self.system.constraints[i]).two_sided
            or self.system.rate(self.time, self.y, c) <= self.sizes.speed
        ]

    def _near(self) -> list[int]:
        """The constraints whose gap is closed, as far as the places tell, which may have got far from where they began."""
        known = enumerate(self.system.constraints)
        near = max(self.sizes.gap, 16.0 * last_digit(self.y[: self.system.count]))
        return [i for i, c in known if c.two_sided or c.gap(self.time, self.y) <= near]

    def _settle_forces(self, touching: Sequence[bool], sides: Sequence[float]) -> Mode:
        system, sizes = self.system, self.sizes
        held: list[Status] = ["off"] * len(system.constraints)
        rubbed: list[Status] = ["off"] * len(system.rubs)
        resting = self._resting()
        gains = np.array(system.gains(self.time, self.y, self.y, touching))
        rubbing = [
            k
            for k, rub in enumerate(system.rubs)
            if (
                (j := system.rub_contacts[k]) < 0 or touching[j]
                if rub.normal
                else system.pressed[k] in resting
            )
        ]
        known: list[tuple[list[int], list[int], Sequence[Item]]] = []
        for group, rubs in system.clusters(self.time, self.y, resting, rubbing):
            known.append((group, rubs, self._settle_group(group, rubs, gains, held, rubbed)))
            if self.looks_ahead and same_twice(
                system, self.time, self.y, [i for i in group if held[i] == "on"]
            ):
                mode = Mode(tuple(held), tuple(rubbed), tuple(touching), tuple(sides))
                later = self._ahead(mode)._settle_forces(touching, sides)
                for i in group:
                    held[i] = later.held[i]
                for k in rubs:
                    rubbed[k] = later.rubbed[k]
        mode = Mode(tuple(held), tuple(rubbed), tuple(touching), tuple(sides))
        if self.looks_ahead:
            for group, rubs, items in known:
                mode = self._chosen(group, rubs, items, mode)
        creeps = tuple(
            0.1 * sizes.rests[k] if isinstance(s, tuple) and len(s) == 2 and self._creeps(k) else 0.0
            for k, s in enumerate(mode.rubbed)
        )
        return replace(mode, creeps=creeps) if any(creeps) else mode

    def _chosen(self, group: Sequence[int], rubs: Sequence[int], items: Sequence[Item], mode: Mode) -> Mode:
        """The mode; where several motions are open and last, the one this run goes by."""
        system = self.system

        def taking(statuses: Sequence[Status]) -> Mode:
            held, rubbed = list(mode.held), list(mode.rubbed)
            _put(statuses, group, held, rubs, rubbed)
            return replace(mode, held=tuple(held), rubbed=tuple(rubbed))

        def lasts(statuses: Sequence[Status]) -> bool:
            later = self._ahead(taking(statuses))
            resting = later._resting()
            if any(status == "on" and i not in resting for i, status in zip(group, statuses, strict=False)):
                return False
            gains = np.array(system.gains(later.time, later.y, later.y, mode.touching))
            items, inverse = later._items(group, rubs, gains), system.inverse(later.time)
            return consistent(items, statuses, answer(items, statuses, inverse), inverse)

        first: tuple[Status, ...] = (*(mode.held[i] for i in group), *(mode.rubbed[k] for k in rubs))
        open_ = rivals(items, first, system.inverse(self.time), lasts)
        if open_ is None:
            return mode
        self.doubts.add("rival")
        return mode if system.rival is None else taking(open_[system.rival])

    def _ahead(self, mode: Mode) -> Moment:
        """The moment a little later, as it would come to be in a mode."""
        lasts, count = AHEAD * self.sizes.long / self.sizes.fast, self.system.count
        slope = self.system.slope(mode, self.y, self.time)(0.0, np.array(self.y))
        velocities = [v + lasts * a for v, a in zip(self.y[count:], slope[count:], strict=True)]
        places = [x + lasts * v for x, v in zip(self.y[:count], velocities, strict=False)]
        later = replace(self, time=self.time + lasts, y=[*places, *velocities], looks_ahead=False)
        project(
            self.system,
            later.time,
            later.y,
            [i for i in held_in(mode)[0] if self.system.constraints[i].two_sided],
            [],
        )
        return later

    def _creeps(self, k: int) -> bool:
        """Whether a slip of two components is too slow to be told from rest."""
        return math.hypot(*self.system.slip(self.time, self.y, k)) <= self.sizes.rests[k] * 1.001

    def _begun(self, k: int) -> tuple[float, ...] | None:
        """The way in which a rub has just begun to slip, and goes on until it is seen to stop."""
        before = None if k in self.stopped else self.before
        return just_begun(self.system, self.time, self.y, before, k, self.sizes.speed)

    def _at_rest(self, touching: Sequence[bool], sides: Sequence[float]) -> Mode | None:
        """The mode in which all that hardly slips in a plane sticks, if there is one.

        What is left of its speed is gone then, and nothing has to hold a body on a curve with it.
        """
        system = self.system
        slow = [
            k
            for k, rub in enumerate(system.rubs)
            if len(rub.driven) == 2
            and k not in self.barred_rubs
            and self._creeps(k)
            and self._begun(k) is None
        ]
        moving = [k for k in slow if any(system.slip(self.time, self.y, k))]
        if not moving:
            return None
        before = list(self.y)
        project(self.system, self.time, self.y, [], moving)
        try:
            mode = self._settle_forces(touching, sides)
        except GuardFailed:
            mode = None
        if mode is None or any(mode.rubbed[k] != "stick" for k in slow):
            self.y[:] = before
            return None
        self.calmed = max(math.dist(speeds(system, before), speeds(system, self.y)), self.calmed)
        if self.before is not None:
            late = not_yet(system, self.time, before, self.before, self.y, mode, moving)
            self.y[system.count :] = [v + d for v, d in zip(system.velocity(self.y), late, strict=True)]
        return mode

    def _settle_group(
        self,
        group: Sequence[int],
        rubs: Sequence[int],
        gains: Array,
        held: list[Status],
        rubbed: list[Status],
    ) -> Sequence[Item]:
        inverse, items = self.system.inverse(self.time), self._items(group, rubs, gains)
        where = f"at {self.time:.6g} s"
        lines = {k for k in self.stopped if len(self.system.rubs[k].driven) == 1}
        rests = [False] * len(group) + [self._creeps(k) or k in lines for k in rubs]
        items, statuses = beginning(items, rests, inverse, where)
        if tied(items, statuses, inverse, self.sizes.tie):
            self.doubts.add("tie")
        _put(statuses, group, held, rubs, rubbed)
        return items

    def _items(self, group: Sequence[int], rubs: Sequence[int], gains: Array) -> list[Item]:
        """What could hold or rub, with what it may do."""
        system, items = self.system, list[Item]()
        for i in group:
            c = system.constraints[i]
            row = np.array([c.row(self.time, self.y)])
            may: tuple[Status, ...] = ("on",) if c.two_sided else ("on", "off")
            may = ("off",) if i in self.barred_constraints else may
            bias = row @ gains + c.drift(self.time, self.y)
            items.append(Item(c.name, row, bias, may, two_sided=c.two_sided))
        for k in rubs:
            pressed = group.index(system.pressed[k]) if system.pressed[k] >= 0 else -1
            item = system.rub_item(self.time, self.y, gains, k, (), pressed)
            item.may = self._ways(k, item) + (("off",) if pressed >= 0 else ())
            items.append(item)
        return items

    def _ways(self, k: int, item: Item) -> tuple[Status, ...]:
        """How a rub may go on: as it slips, or, where it does not slip, held or beginning to slip."""
        slip = self.system.slip(self.time, self.y, k)
        speed = math.hypot(*slip)
        if not self._creeps(k) if len(slip) == 2 else speed > self.sizes.speed and k not in self.stopped:
            return (tuple(v / speed for v in slip),)
        if k in self.barred_rubs:
            return (self.barred_rubs[k],)
        if (begun := self._begun(k)) is not None:
            return (begun,)
        if len(slip) == 1:
            return ("stick", (1.0,), (-1.0,))
        pull = math.hypot(*item.bias)
        return ("stick", tuple(float(b) / pull for b in item.bias)) if pull else ("stick",)


def _put(
    statuses: Sequence[Status],
    group: Sequence[int],
    held: list[Status],
    rubs: Sequence[int],
    rubbed: list[Status],
) -> None:
    """What a group of constraints, and then rubs, does goes into the lists of all."""
    for i, status in zip(group, statuses, strict=False):
        held[i] = status
    for k, status in zip(rubs, statuses[len(group) :], strict=True):
        rubbed[k] = status
