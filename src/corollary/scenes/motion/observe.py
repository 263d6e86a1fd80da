"""Every observable, read off a trajectory; and how the scene ended."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import assert_never

import numpy as np
from scipy.optimize import minimize_scalar

from corollary.scenes.motion.energy import energy, impulses, kinetic, masses_at, momentum
from corollary.scenes.motion.isolation import POINTS, certainly_positive, coefficients, first_fall, root_of
from corollary.scenes.motion.path import Stretch, Trajectory, Turn
from corollary.scenes.run import BadSetting, Observable, Observed, Outcome
from corollary.scenes.scene import Scene, overlap, pairs, place, spin, start_of, velocity

Value = Callable[[Sequence[float]], float]

# Returns whose times differ by a larger share are no period.
UNEQUAL = 1e-6


def outcome(scene: Scene, path: Trajectory) -> Outcome:
    """How it ended."""
    if path.settled or _at_rest(scene, path):
        return "sticks"
    if scene.until is not None:
        return "escaped" if _beyond_every_edge(scene, path.state) else "bound"
    return "released" if contact_span(path) else "missed"


def _at_rest(scene: Scene, path: Trajectory) -> bool:
    """Whether everything that can move is held where it is."""
    if path.mode is None or not (path.mode.held or path.mode.rubbed):
        return False
    held = any(s in ("on", "stick") for s in (*path.mode.held, *path.mode.rubbed))
    loose = [i for i, body in enumerate(scene.bodies) if not math.isinf(body.mass)]
    count = scene.axes * len(scene.bodies)
    fast = max((abs(v) for stretch in path.stretches for v in stretch.before[count:]), default=1.0)
    return held and all(math.hypot(*velocity(scene, path.state, i)) <= 1e-9 * fast for i in loose)


def _beyond_every_edge(scene: Scene, state: Sequence[float]) -> bool:
    """Whether forces of the scene have edges, and its bodies are beyond them on their way out."""
    edges = [force.edge for force in scene.forces if math.isfinite(force.edge)]
    places = [(place(scene, state, i), velocity(scene, state, i)) for i in range(len(scene.bodies))]
    outward = all(sum(a * b for a, b in zip(x, v, strict=True)) > 0.0 for x, v in places)
    return bool(edges) and outward and all(math.hypot(*x) >= edge for x, _ in places for edge in edges)


def look(scene: Scene, path: Trajectory, what: Observable, times: Sequence[float]) -> Observed:
    """One observable; `times` (s) are those of a trajectory. Raises BadSetting where the scene has no such thing."""
    every = range(len(scene.bodies))
    served = [(force, a, b) for force in scene.contacts for a, b in force.serves(scene)]
    match what:
        case Observable.VELOCITIES:
            return tuple(v for i in every for v in velocity(scene, path.state, i))
        case Observable.SPINS:
            return tuple(spin(scene, path.state, i) for i in every)
        case Observable.ENERGY_RATIO:
            before = kinetic(scene, 0.0, start_of(scene))
            if not before:
                raise BadSetting(
                    f"{scene.name}: nothing moves at the start; ask for the energy, not for its ratio."
                )
            return kinetic(scene, path.time, path.state) / before
        case Observable.LARGEST_OVERLAP:
            chosen = {(a, b) for _, a, b in served}
            found = [
                _largest(lambda y, a=a, b=b: overlap(scene, y, a, b)[0], _touching(path, j))
                for j, (_, a, b) in enumerate(served)
            ]
            # Bodies that pass through each other on purpose overlap as well.
            passed = [
                _largest(lambda y, a=a, b=b: overlap(scene, y, a, b)[0], path.stretches)
                for a, b in pairs(scene)
                if (a, b) not in chosen
            ]
            at_start = [overlap(scene, start_of(scene), a, b)[0] for a, b in pairs(scene)]
            return max([0.0, *found, *passed, *at_start])
        case Observable.PEAK_FORCE:
            return max(
                (
                    _largest(
                        lambda y, f=f, a=a, b=b: math.hypot(*f.between(scene, y, a, b)), _touching(path, j)
                    )
                    for j, (f, a, b) in enumerate(served)
                ),
                default=0.0,
            )
        case Observable.DURATION:
            span = contact_span(path)
            return span.lasts if span else 0.0
        case Observable.TURNING_POINTS:
            distances = [turn.distance for turn in turns(scene, path)]
            if distances and flat(scene, path):  # a circle: both are its radius
                return distances[0], distances[0]
            return tuple(sorted({min(distances), max(distances)})) if distances else ()
        case Observable.PERIOD:
            inner = [turn.time for turn in turns(scene, path) if turn.inward]
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


def _period(scene: Scene, path: Trajectory, returns: Sequence[float]) -> float:
    """The time between two of the returns (s). Raises BadSetting where it is another each time."""
    lasted = [after - before for before, after in pairwise(returns)]
    if max(lasted) - min(lasted) > UNEQUAL * max(lasted) + path.near / path.fast:
        raise BadSetting(
            f"{scene.name}: the distance returns after {min(lasted):.6g} s and after {max(lasted):.6g} s: there is no period. "
            "Ask for turning points, or for a trajectory."
        )
    return (returns[-1] - returns[0]) / len(lasted)


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
        found += _inside(scene, stretch)
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
    ends = (path.state, *(each.before for each in path.stretches))
    least = path.near * max(math.hypot(*velocity(scene, y, 0)) for y in ends)
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
    # Added up: no digits are lost to the time before.
    return Span(math.fsum(each.lasts for each in path.stretches[first : last + 1]), math.fsum(ends))


def _touching(path: Trajectory, contact: int) -> list[Stretch]:
    """The stretches in which a pair touches."""
    return [stretch for stretch in path.stretches if stretch.mode.touching[contact]]
