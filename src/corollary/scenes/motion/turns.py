"""Turning points of the first body's distance from the origin."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from corollary.scenes.body import starts_across
from corollary.scenes.motion.first_root import POINTS, certainly_positive, coefficients, first_fall, root_of
from corollary.scenes.motion.path import Stretch, Trajectory, Turn
from corollary.scenes.scene import Scene, place, velocity


def turns(scene: Scene, path: Trajectory) -> list[Turn]:
    """Where the first body's distance from the origin turns, at walls, too. They are found once for a path."""
    if path.turned is None:
        path.turned = _turns(scene, path)
    return path.turned


def _turns(scene: Scene, path: Trajectory) -> list[Turn]:
    if path.stretches and flat(scene, path):
        first = path.stretches[0]
        return [Turn(first.begin, math.hypot(*place(scene, first.before, 0)), False)]
    passed: list[Turn] = []
    for stretch in path.stretches:
        passed.append(Turn(stretch.begin, math.hypot(*place(scene, stretch.before, 0)), False))
        passed += _inside(scene, stretch)
    passed.append(Turn(path.time, math.hypot(*place(scene, path.state, 0)), False))
    least = near(scene, path)
    found = extremes(passed, least)
    if found and found[0].time == 0.0 and not starts_across(scene.bodies[0]):
        del found[0]
    return [replace(turn, time=_time_of(scene, path, turn, least)) if turn.inward else turn for turn in found]


def extremes(passed: Sequence[Turn], least: float) -> list[Turn]:
    """Of distances, one after the other, those from which it goes another way by more than `least` (m), and the first.

    What comes to rest, or creeps there, does not turn: where rounding sends it is no way. Nor does what rounding sends past the origin.
    """
    found: list[Turn] = []
    low = high = passed[0]
    way = 0.0  # which way the distance goes; at first it is not known
    for each in passed[1:]:
        if way >= 0.0 and high.distance - each.distance > least:
            found.append(replace(high, inward=False))
            way, low = -1.0, each
        elif way <= 0.0 and each.distance - low.distance > least:
            found.append(replace(low, inward=True))
            way, high = 1.0, each
        low = min(low, each, key=_distance)
        high = max(high, each, key=_distance)
    return found


def _distance(turn: Turn) -> float:
    return turn.distance


def _time_of(scene: Scene, path: Trajectory, turn: Turn, least: float) -> float:
    """When (s) a distance turns: as it comes to nothing, where errors decide about the moment, the middle of the time it is below `least` (m)."""

    def above(time: float) -> float:
        return math.hypot(*place(scene, path.at(time), 0)) - least

    ends: list[float] = []
    for way in (-1.0, 1.0) if above(turn.time) < 0.0 else ():
        ahead = way * least / path.fast
        while 0.0 < turn.time + ahead < path.time and above(turn.time + ahead) <= 0.0:
            ahead *= 2.0
        if 0.0 < turn.time + ahead < path.time:
            ends.append(root_of(above, turn.time, turn.time + ahead))
    return math.fsum(ends) / 2.0 if len(ends) == 2 else turn.time


def near(scene: Scene, path: Trajectory) -> float:
    """How near (m) places of the first body are not told apart.

    That of the path goes by the farthest thing in the scene. A swing of this body is known better, but no better than its speed is beside
    that of the fastest.
    """
    far, fast = max(math.hypot(*place(scene, y, 0)) for y in path.ends()), fastest(scene, path)
    share = far / path.long * path.fast / fast if fast else 1.0
    return max(path.near * min(share, 1.0), 16.0 * math.ulp(path.long))


def fastest(scene: Scene, path: Trajectory) -> float:
    """The largest speed (m/s) of the first body, as far as the ends of steps tell."""
    return max(math.hypot(*velocity(scene, y, 0)) for y in path.ends())


def _outward(scene: Scene, y: Sequence[float]) -> float:
    """Place times velocity of the first body (m^2/s): it goes through zero where the distance turns."""
    return sum(a * b for a, b in zip(place(scene, y, 0), velocity(scene, y, 0), strict=True))


def flat(scene: Scene, path: Trajectory) -> bool:
    """Whether the distance of the first body never changes by more than errors of steps: on a circle nothing turns."""
    least = near(scene, path) * fastest(scene, path)
    return all(abs(_outward(scene, y)) <= least for each in path.stretches for y in each.sampled())


def _inside(scene: Scene, stretch: Stretch) -> list[Turn]:
    def along(y: Sequence[float]) -> float:
        return _outward(scene, y)

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
