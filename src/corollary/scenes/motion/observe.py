"""Every observable, read off a trajectory; how the scene ended, and where a distance turns."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import assert_never

import numpy as np
from scipy.optimize import minimize_scalar

from corollary.scenes.body import loose, starts_across
from corollary.scenes.motion.conserved import energy, impulses, kinetic, masses_at, momentum, refuse_rest
from corollary.scenes.motion.equations_of_motion import served
from corollary.scenes.motion.path import (
    POINTS,
    Stretch,
    Trajectory,
    Turn,
    certainly_positive,
    coefficients,
    first_fall,
    root_of,
)
from corollary.scenes.run import BadSetting, Observable, Observed, Outcome
from corollary.scenes.scene import (
    Conserves,
    ContactForce,
    Scene,
    overlap,
    pairs,
    place,
    seen_from,
    spin,
    start_of,
    velocity,
)


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


Value = Callable[[Sequence[float]], float]

# Returns whose times differ by a larger share are no period.
UNEQUAL = 1e-6
# Nor are those by a larger one, however coarsely places are known.
COARSE = 1e-3


def outcome(scene: Scene, path: Trajectory) -> Outcome:
    """How it ended."""
    if path.settled or _at_rest(scene, path) or _stuck(scene, path):
        return "sticks"
    if scene.until is not None:
        return "escaped" if _beyond_every_edge(scene, path.state) else "bound"
    return "released" if contact_span(path) else "missed"


def _at_rest(scene: Scene, path: Trajectory) -> bool:
    """Whether everything that can move is held where it is."""
    if path.mode is None or not (path.mode.held or path.mode.rubbed):
        return False
    held = any(s in ("on", "stick") for s in (*path.mode.held, *path.mode.rubbed))
    movable, count = loose(scene.bodies), scene.axes * len(scene.bodies)
    moved = max((abs(v) for stretch in path.stretches for v in stretch.before[count:]), default=0.0)
    slow = max(1e-9 * moved, 1e-12 * path.fast)
    return (
        held and bool(movable) and all(math.hypot(*velocity(scene, path.state, i)) <= slow for i in movable)
    )


def _stuck(scene: Scene, path: Trajectory) -> bool:
    """Whether damped contacts have left everything that can move as fast as something it touches, through the last step."""
    if not path.stretches or Conserves.ENERGY in scene.conserves:
        return False
    ends = path.stretches[-1].before, path.state
    stuck = {
        i
        for (_, a, b), on in zip(served(scene), path.touching(), strict=True)
        if on and all(math.hypot(*seen_from(scene, y, a, b)[1]) <= 1e-9 * path.fast for y in ends)
        for i in (a, b)
    }
    movable = loose(scene.bodies)
    return bool(movable) and stuck.issuperset(movable)


def _beyond_every_edge(scene: Scene, state: Sequence[float]) -> bool:
    """Whether forces of the scene have edges, and its bodies are beyond them on their way out."""
    edges = [force.edge for force in scene.forces if math.isfinite(force.edge)]
    places = [(place(scene, state, i), velocity(scene, state, i)) for i in loose(scene.bodies)]
    outward = all(sum(a * b for a, b in zip(x, v, strict=True)) > 0.0 for x, v in places)
    return bool(edges) and outward and all(math.hypot(*x) >= edge for x, _ in places for edge in edges)


def look(scene: Scene, path: Trajectory, what: Observable, times: Sequence[float]) -> Observed:
    """One observable; `times` (s) are those of a trajectory. Raises BadSetting where the scene has no such thing."""
    every = range(len(scene.bodies))
    match what:
        case Observable.VELOCITIES:
            return tuple(v for i in every for v in velocity(scene, path.state, i))
        case Observable.SPINS:
            return tuple(spin(scene, path.state, i) for i in every)
        case Observable.ENERGY_RATIO:
            refuse_rest(scene)
            return kinetic(scene, path.time, path.state) / kinetic(scene, 0.0, start_of(scene))
        case Observable.LARGEST_OVERLAP:
            chosen = {(a, b) for _, a, b in served(scene)}
            found = [
                _largest(lambda y, a=a, b=b: overlap(scene, y, a, b)[0], touching)
                for _, a, b, touching in _touching(scene, path)
            ]
            # Bodies that pass through each other on purpose overlap as well; with a point that no contact serves nothing does.
            seen = [(a, b) for a, b in pairs(scene) if (a, b) in chosen or _solid(scene, a, b)]
            passed = [
                _largest(lambda y, a=a, b=b: overlap(scene, y, a, b)[0], path.stretches)
                for a, b in seen
                if (a, b) not in chosen
            ]
            at_start = [overlap(scene, start_of(scene), a, b)[0] for a, b in seen]
            return max([0.0, *found, *passed, *at_start])
        case Observable.PEAK_FORCE:
            felt = [
                _largest(lambda y, f=f, a=a, b=b: math.hypot(*f.between(scene, y, a, b)), touching)
                for f, a, b, touching in _touching(scene, path)
            ]
            return max([0.0, *felt])
        case Observable.DURATION:
            if path.settled:
                return math.inf
            span = contact_span(path)
            return span.lasts if span else 0.0
        case Observable.TURNING_POINTS:
            distances = [turn.distance for turn in turns(scene, path)]
            if distances and flat(scene, path):  # a circle: both are its radius
                return distances[0], distances[0]
            return tuple(sorted({min(distances), max(distances)})) if distances else ()
        case Observable.PERIOD:
            if path.stretches and flat(scene, path):
                raise BadSetting(
                    f"{scene.name}: the distance from the origin does not change, so it has no period."
                )
            inner = _returns(scene, path)
            if len(inner) < 2:
                raise BadSetting(
                    f"{scene.name}: the distance did not return twice before the end, {path.time:.6g} s; watch for a longer time."
                )
            return _period(scene, path, inner)
        case Observable.IMPULSE:
            if masses_at(scene, 1.0) != masses_at(scene, 0.0):
                raise BadSetting(
                    f"{scene.name}: the impulse on a body whose mass changes is not its change of momentum; ask for velocities."
                )
            return impulses(scene, start_of(scene), path.state)
        case Observable.MOMENTUM:
            return momentum(scene, path.time, path.state)
        case Observable.ENERGY:
            return energy(scene, path.time, path.state)
        case Observable.TRAJECTORY:
            count = scene.axes * len(scene.bodies)
            return tuple(x for time in times for x in state_at(scene, path, time)[:count])
        case _:
            assert_never(what)


def _solid(scene: Scene, a: int, b: int) -> bool:
    return min(scene.bodies[a].radius, scene.bodies[b].radius) > 0.0


def _period(scene: Scene, path: Trajectory, returns: Sequence[Turn]) -> float:
    """The time between two of the returns (s). Raises BadSetting where it is another each time, or they are to other distances."""
    lasted = _between(returns)
    # What steps are off they hand on to all returns after.
    off, far = len(lasted) * path.near, max(math.hypot(*place(scene, y, 0)) for y in path.ends())
    distances = [turn.distance for turn in returns]
    if max(distances) - min(distances) > UNEQUAL * far + min(off, COARSE * far):
        raise BadSetting(
            f"{scene.name}: the distance is least at {min(distances):.6g} m once and at {max(distances):.6g} m another time: there is no "
            "period. Ask for turning points, or for a trajectory."
        )
    if max(lasted) - min(lasted) > UNEQUAL * max(lasted) + min(
        off / fastest(scene, path), COARSE * max(lasted)
    ):
        raise BadSetting(
            f"{scene.name}: the distance returns after {min(lasted):.6g} s and after {max(lasted):.6g} s: there is no period. "
            "Ask for turning points, or for a trajectory."
        )
    return math.fsum(lasted) / len(lasted)


def _between(returns: Sequence[Turn]) -> list[float]:
    """How long (s) it is from each return to the next."""
    return [after.time - before.time for before, after in pairwise(returns)]


def unequal(scene: Scene, path: Trajectory) -> float:
    """By how much (s) the times between returns differ that are taken for a period as places are known no better."""
    lasted = _between(_returns(scene, path))
    apart = max(lasted, default=0.0) - min(lasted, default=0.0)
    return apart if apart > UNEQUAL * max(lasted, default=0.0) else 0.0


def _returns(scene: Scene, path: Trajectory) -> list[Turn]:
    """Where the first body has come back to a least distance; one that starts in the origin itself has not come back."""
    return [turn for turn in turns(scene, path) if turn.inward and (turn.time or turn.distance)]


def state_at(scene: Scene, path: Trajectory, time: float) -> Sequence[float]:
    """The state at any time from the start on; after the end of a motion that no time ends, bodies go on straight."""
    if time <= path.time:
        return path.at(time)
    half = scene.axes * len(scene.bodies)
    places, velocities = path.state[:half], path.state[half:]
    return [
        *(x + v * (time - path.time) for x, v in zip(places, velocities[:half], strict=True)),
        *velocities,
    ]


def _largest(value: Value, stretches: Sequence[Stretch]) -> float:
    """The largest value at any moment of these stretches: the best of their samples, and between its neighbours the maximum."""
    if not stretches:
        return 0.0
    best, stretch, at = -math.inf, stretches[0], 0
    for each in stretches:
        values = [value(y) for y in each.sampled()]
        top = max(range(len(values)), key=values.__getitem__)
        if values[top] > best:
            best, stretch, at = values[top], each, top
    left, right = float(POINTS[max(at - 1, 0)]), float(POINTS[min(at + 1, len(POINTS) - 1)])
    found = minimize_scalar(
        lambda x: -value(stretch.at(float(x))),
        bounds=(left, right),
        method="bounded",
        options={"xatol": 1e-9},
    )
    inside = stretch.again(float(found["x"]))  # pyright: ignore[reportIndexIssue]
    return max(value(stretch.before), value(inside), value(stretch.after))


@dataclass(frozen=True, slots=True)
class Span:
    """From the first touch to the last opening (s), and by how much (s) its ends may be off."""

    lasts: float
    slack: float


def contact_span(path: Trajectory) -> Span | None:
    """How long there was a contact; none when there was none."""
    touched = [i for i, each in enumerate(path.stretches) if any(each.mode.touching)]
    if not touched:
        return None
    first, last = touched[0], touched[-1]
    ends = [h.slack for h in path.happenings if h.what.startswith("touch") and h.stretch in (first, last + 1)]
    # Added up: no digits are lost to the time before.
    return Span(math.fsum(each.lasts for each in path.stretches[first : last + 1]), math.fsum(ends))


def _touching(scene: Scene, path: Trajectory) -> Iterator[tuple[ContactForce, int, int, list[Stretch]]]:
    """Every two bodies between which a contact acts, and the stretches in which they touch."""
    for i, (force, a, b) in enumerate(served(scene)):
        yield force, a, b, [each for each in path.stretches if each.mode.touching[i]]
