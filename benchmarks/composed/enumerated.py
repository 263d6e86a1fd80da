"""A reference for discs that stick, slip, bounce and come to rest: every mode is enumerated, every change of it located.

Steps are those of Dormand and Prince of order 8(5, 3), written here from their table, in the coordinates of the centres; a step ends where
something that must stay above zero does not. Bounces slower than `Fineness.bounce` are left out: two runs that leave out others say what that makes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as table
from scipy.optimize import minimize_scalar

from .changes import Kind, Watched, falls, watched
from .discs import Composed, System
from .modes import (
    AT_REST,
    CLOSING,
    STICKS,
    Mode,
    NoMode,
    NoReference,
    chosen,
    closing,
    hit,
    motion,
    put_right,
)

STAGES = 12
TOUCHES = 1e-11
"""A gap (m) that is none."""
PARTS = 3
"""Each step is looked at in so many parts."""


@dataclass(frozen=True, slots=True)
class Fineness:
    """Of steps, and the slowest bounce (m/s) that is followed."""

    relative: float = 1e-13
    bounce: float = 7e-7
    longest: float = 0.02
    most_steps: int = 1500
    most_changes: int = 400


class Course:
    """A system followed from its start; `met` are the times at which each constraint was met, `peak` the largest push of a pair so far."""

    def __init__(self, given: Composed, fineness: Fineness) -> None:
        self.system, self.fineness = System(given), fineness
        self.n = 3 * len(given.discs)
        self.t, self.state, self.peak = 0.0, self.system.start, 0.0
        self.met: list[tuple[float, int]] = []
        self.mode, self.h = Mode(), 1e-4
        self.changes = self.steps = 0

    def follow(self, times: Sequence[float]) -> list[Any]:
        """The states at times that grow."""
        self._begin()
        states: list[Any] = []
        for end in times:
            while end - self.t >= 1e-15 * max(1.0, end):
                self._advance(end)
            states.append(self.state)
        return states

    def _begin(self) -> None:
        holds, state = self.system.holds, self.state
        touched = [i for i, each in enumerate(holds) if not each.opens or abs(each.gap(0.0, state)) < TOUCHES]
        if any(holds[i].opens and closing(self.system, i, 0.0, state) < -CLOSING for i in touched):
            self.state = hit(self.system, 0.0, state, touched, self.fineness.bounce)
        overlapping = frozenset(k for k, pair in enumerate(self.system.pairs) if pair.depth(state) > 1e-13)
        self._settle(touched, overlapping, None)

    def _settle(self, touched: Sequence[int], touching: frozenset[int], change: Watched | None) -> None:
        """The mode to go on with after a change; what was stuck may stick on, unless it is what could not."""
        system, t, state, before = self.system, self.t, self.state, self.mode
        slow = [
            i for i in touched if not system.holds[i].opens or abs(closing(system, i, t, state)) < AT_REST
        ]
        kind, which = change or (Kind.GAP, -1)
        still: set[int] = set()
        if kind != Kind.GAP:
            still = {k for k, sense in before.rubbing.items() if sense == STICKS}
        if kind == Kind.SLIP:
            still.add(which)
        found: Mode | None = None
        try:
            if kind == Kind.FRICTION:
                found = chosen(system, t, state, slow, touching, still, loose=which)
            elif kind == Kind.FORCE:
                presses = motion(system, t, state, before).presses
                pressing = [
                    i
                    for i in slow
                    if not system.holds[i].opens or (i != which and presses.get(i, 1.0) > 1e-10)
                ]
                found = chosen(system, t, state, pressing, touching, still)
        except NoMode:
            found = None  # all that may hold is tried
        self.mode = found or chosen(system, t, state, slow, touching, still)
        self.state = put_right(system, t, self.state, self.mode)

    def _slope(self, t: float, state: Any) -> Any:
        return np.concatenate([state[self.n :], motion(self.system, t, state, self.mode).accelerations])

    def _stages(self, h: float, first: Any) -> tuple[Any, Any]:
        """The state a step ahead, and the slopes it was made of, with room for the one there."""
        slopes = np.zeros((STAGES + 1, 2 * self.n))
        slopes[0] = first
        for i in range(1, STAGES):
            part = h * (table.A[i, :i] @ slopes[:i])
            slopes[i] = self._slope(self.t + table.C[i] * h, self.state + part)
        return self.state + h * (table.B @ slopes[:STAGES]), slopes

    def _longest(self, end: float, first: Any) -> float:
        """No step goes far beyond where a gap would close if accelerations stayed as they are."""
        cap, system = math.inf, self.system
        for i, each in enumerate(system.holds):
            if i in self.mode.held or not each.opens:
                continue
            row, gap = each.row(self.t, self.state), max(each.gap(self.t, self.state), 0.0)
            rate = float(row.on @ self.state[self.n :] + row.rate)
            growth = float(row.on @ first[self.n :] + row.drift)
            under = rate * rate - 2 * growth * gap
            if under < 0:
                continue
            if abs(growth) < 1e-12:
                closes = -gap / rate if rate < 0 else math.inf
            elif rate >= 0:
                closes = (rate + math.sqrt(under)) / -growth if growth < 0 else math.inf
            else:
                closes = 2 * gap / (math.sqrt(under) - rate)
            if closes > 0:
                cap = min(cap, (0.6 if rate > 0 else 1.05) * closes + 1e-14)
        return min(self.h, self.fineness.longest, end - self.t, max(cap, 1e-12))

    def _advance(self, end: float) -> None:
        """One step, or what there is of it up to the first change."""
        self.steps += 1
        if self.steps > self.fineness.most_steps:
            raise NoReference("too many steps")
        first = self._slope(self.t, self.state)
        h = self._longest(end, first)
        while True:
            new, slopes = self._stages(h, first)
            slopes[STAGES] = self._slope(self.t + h, new)
            size = np.maximum(1e-3, np.maximum(np.abs(self.state), np.abs(new)))
            scale = 1e-15 + self.fineness.relative * size
            fifth = np.linalg.norm(slopes.T @ table.E5 / scale) ** 2
            third = np.linalg.norm(slopes.T @ table.E3 / scale) ** 2
            off = h * fifth / math.sqrt((fifth + 0.01 * third) * 2 * self.n) if fifth or third else 0.0
            if off <= 1 or h < 1e-12:
                break
            h *= max(0.2, 0.9 * off ** (-1 / 8))

        known = {0.0: self.state, h: new}

        def within(x: float) -> Any:
            if x not in known:
                known[x] = self._stages(x, first)[0]
            return known[x]

        parts = [h * j / PARTS for j in range(PARTS)] + [h]
        change = self._first_change(parts, within)
        self._see_pushes(
            parts if change is None else [x for x in parts if x < change[0]] + [change[0]], within
        )
        if change is None:
            self.t, self.state = self.t + h, new
            self.h = h * (min(4.0, 0.9 * off ** (-1 / 8)) if off > 0 else 4.0)
            if abs(self.t - end) < 1e-15 * max(1.0, end):
                self.t = end
            return
        self.h = h
        self._change(*change, within)

    def _first_change(
        self, parts: Sequence[float], within: Callable[[float], Any]
    ) -> tuple[float, Watched] | None:
        """When in this step, and which, if any of what is watched falls below zero."""
        seen = [watched(self.system, self.mode, self.t + x, within(x)) for x in parts]

        def at(x: float) -> tuple[float, Any]:
            return self.t + x, within(x)

        for j in range(1, len(parts)):
            found = [
                (x, what)
                for what in seen[j]
                for x in falls(
                    self.system, self.mode, what, parts[j - 1], parts[j], seen[j - 1][what], seen[j][what], at
                )
            ]
            if found:
                return min(found)
        return None

    def _change(self, x: float, what: Watched, within: Callable[[float], Any]) -> None:
        """Go to where it is, and on from there in the mode that follows; a constraint that is met is a hit."""
        self.changes += 1
        if self.changes > self.fineness.most_changes:
            raise NoReference("too many changes")
        self.t, self.state = self.t + x, within(x)
        kind, which = what
        touched, touching = set(self.mode.held), self.mode.touching
        if kind == Kind.GAP:
            touched.add(which)
            self.met.append((self.t, which))
        elif kind == Kind.OVERLAP:
            touching = touching ^ {which}
        for i, each in enumerate(self.system.holds):
            near = abs(each.gap(self.t, self.state)) < TOUCHES
            if near and closing(self.system, i, self.t, self.state) < AT_REST:
                touched.add(i)
        if kind == Kind.GAP:
            self.state = hit(self.system, self.t, self.state, sorted(touched), self.fineness.bounce)
        self._settle(sorted(touched), touching, what)
        self.peak = max(self.peak, self._pushed(self.state))
        self.h = min(self.h, 1e-5 if kind == Kind.OVERLAP else 1e-3)

    def _pushed(self, state: Any) -> float:
        """The largest push there is now."""
        return max((math.hypot(*self.system.pairs[k].push(state)) for k in self.mode.touching), default=0.0)

    def _see_pushes(self, places: Sequence[float], within: Callable[[float], Any]) -> None:
        """The largest one within this step."""
        if not self.mode.touching:
            return
        pushes = [self._pushed(within(x)) for x in places]
        k = int(np.argmax(pushes))
        self.peak = max(self.peak, pushes[k])
        low, high = places[max(k - 1, 0)], places[min(k + 1, len(places) - 1)]
        if high > low and pushes[k] > 0.9 * self.peak:
            top = minimize_scalar(
                lambda x: -self._pushed(within(x)),
                bounds=(low, high),
                method="bounded",
                options={"xatol": 1e-5 * (high - low) + 1e-16},
            )
            self.peak = max(self.peak, -float(top.fun))


def observed(course: Course, times: Sequence[float], until: float) -> dict[str, tuple[float, ...]]:
    """A course, followed until then: velocities, spins, places at `times`, energy, and the largest push."""
    states, n = course.follow(sorted({*times, until})), course.n
    seen, end = dict(zip(sorted({*times, until}), states, strict=True)), states[-1]
    discs = range(len(course.system.discs))
    return {
        "velocities": tuple(float(end[n + 3 * i + k]) for i in discs for k in (0, 1)),
        "spins": tuple(float(end[n + 3 * i + 2]) for i in discs),
        "trajectory": tuple(float(seen[t][3 * i + k]) for t in times for i in discs for k in (0, 1)),
        "energy": (course.system.energy(end),),
        "peak_force": (float(course.peak),),
    }
