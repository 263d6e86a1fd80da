"""What is read off a path: the largest values of something along it, its turning points, and how long bodies touched."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize_scalar

from corollary.scenes.motion.isolation import POINTS, certainly_positive, coefficients, first_fall, root_of
from corollary.scenes.motion.path import Stretch, Trajectory, Turn
from corollary.scenes.scene import Scene, overlap, place, velocity

Value = Callable[[Sequence[float]], float]


def largest(path: Trajectory, value: Value, stretches: Sequence[Stretch]) -> float:
    """The largest value at any moment of these stretches: the best of their samples, and between its neighbours the maximum."""
    best, top, where = -math.inf, 0, (0, 0)
    for i, stretch in enumerate(stretches):
        values = [value(y) for y in stretch.sampled()]
        top = max(range(len(values)), key=values.__getitem__)
        if values[top] > best:
            best, where = values[top], (i, top)
    if not stretches:
        return 0.0
    stretch, at = stretches[where[0]], where[1]
    left, right = float(POINTS[max(at - 1, 0)]), float(POINTS[min(at + 1, len(POINTS) - 1)])
    found = minimize_scalar(
        lambda x: -value(stretch.at(float(x))),
        bounds=(left, right),
        method="bounded",
        options={"xatol": 1e-9},
    )
    inside = stretch.again(float(found["x"]))  # pyright: ignore[reportIndexIssue]
    return max(value(stretch.before), value(inside), value(stretch.after))


def turns(scene: Scene, path: Trajectory) -> list[Turn]:
    """Where the first body's distance from the origin turns, at walls, too. They are found once for a path."""
    if path.turned is None:
        path.turned = _turns(scene, path)
    return path.turned


def _turns(scene: Scene, path: Trajectory) -> list[Turn]:
    if path.stretches and flat(scene, path):
        first = path.stretches[0]
        return [Turn(first.begin, math.hypot(*place(scene, first.before, 0)), False)]
    found: list[Turn] = []
    last = 0.0
    for stretch in path.stretches:
        begin = _outward(scene, stretch.before)
        if last * begin < 0.0 or (begin == 0.0 and not found and stretch is path.stretches[0]):
            first = _outward(scene, stretch.at(0.5)) > 0.0 if begin == 0.0 else begin > 0.0
            found.append(Turn(stretch.begin, math.hypot(*place(scene, stretch.before, 0)), first))
        found += _inside(scene, stretch, lambda y: _outward(scene, y))
        last = _outward(scene, stretch.after)
    return _without_those_of_rounding(found, path.near)


def _without_those_of_rounding(turns: Sequence[Turn], near: float) -> list[Turn]:
    """Where a body is thrown back at the origin itself, rounding may send it past: what turns within `near` (m) and comes back is one turn."""
    found: list[Turn] = []
    for turn in turns:
        past = not turn.inward and turn.distance <= near
        if not found or not (past or turn.inward is found[-1].inward):
            found.append(turn)
    return found


def _outward(scene: Scene, y: Sequence[float]) -> float:
    """Place times velocity of the first body (m^2/s): it goes through zero where the distance turns."""
    return sum(a * b for a, b in zip(place(scene, y, 0), velocity(scene, y, 0), strict=True))


def flat(scene: Scene, path: Trajectory) -> bool:
    """Whether the distance of the first body never changes by more than errors of steps: on a circle nothing turns."""
    states = [y for each in path.stretches for y in each.sampled()]
    least = path.near * max((math.hypot(*velocity(scene, y, 0)) for y in states), default=0.0)
    return all(abs(_outward(scene, y)) <= least for y in states)


def _inside(scene: Scene, stretch: Stretch, along: Value) -> list[Turn]:
    found: list[Turn] = []
    left = 0.0
    values = np.array([along(y) for y in stretch.sampled()])
    sign = 1.0 if (values[0] or values[1]) > 0.0 else -1.0  # it may turn before the second sample
    if certainly_positive(coefficients(sign * values)):
        return found
    while True:
        span = 1.0 - left
        scaled = lambda x, left=left, span=span, sign=sign: sign * along(stretch.at(left + x * span))  # noqa: E731
        several = lambda x, left=left, span=span, sign=sign: (  # noqa: E731
            sign * np.array([along(y) for y in stretch.states(left + x * span)])
        )
        fall = first_fall(several, several(POINTS) if left else sign * values)
        if fall is None or fall[1] <= 0.0:
            return found
        low, high = fall
        part = root_of(scaled, low, high) if scaled(low) > 0.0 >= scaled(high) else high
        at = left + part * span
        y = stretch.again(at)
        found.append(Turn(stretch.begin + at * stretch.lasts, math.hypot(*place(scene, y, 0)), sign < 0.0))
        left, sign = min(at + 1e-9, 1.0), -sign
        if left >= 1.0:
            return found


@dataclass(frozen=True, slots=True)
class Span:
    """From the first touch to the last opening (s), and by how much (s) its ends may be off."""

    lasts: float
    slack: float


def contact_span(path: Trajectory) -> Span | None:
    """How long there was a contact; none when there was none."""
    touched = [i for i, stretch in enumerate(path.stretches) if any(stretch.mode.touching)]
    if not touched:
        return None
    first, last = touched[0], touched[-1]
    ends = [h.slack for h in path.happenings if h.what.startswith("touch") and h.stretch in (first, last + 1)]
    return Span(path.lasted(first, last), math.fsum(ends))


def contact_stretches(path: Trajectory, contact: int) -> list[Stretch]:
    """The stretches in which a pair touches."""
    return [stretch for stretch in path.stretches if stretch.mode.touching[contact]]


def depth_of(scene: Scene, a: int, b: int) -> Value:
    """The overlap of two bodies in a state."""
    return lambda y: overlap(scene, y, a, b)[0]
