"""How far two runs of one scene are apart: what is made of it is the error that is stated."""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.scenes.motion.observe import state_at
from corollary.scenes.motion.path import Trajectory
from corollary.scenes.run import Observable, Observed, components
from corollary.scenes.scene import ForceBetween, Scene, place, velocity

BY_BODY = {Observable.VELOCITIES, Observable.TRAJECTORY, Observable.IMPULSE}
HANDED_ON = 0.3
"""Such a part of a body's error is another's, too, that it pulls at."""


def shares(
    scene: Scene,
    rough: Trajectory,
    right: Trajectory,
    what: Observable,
    times: Sequence[float],
    sizes: dict[Observable, float],
) -> list[float]:
    """How far two runs are apart as a whole, body by body, in the unit of each number that is observed.

    The error of a single component may pass through zero between two tolerances; that of a body's place and velocity together does
    not. For what is not a number of each body: the largest, in units of the sizes of the scene. What fades for ever is given up at
    other moments by both, and compared at the earlier one; what flies apart at the later one.
    """
    long, fast, axes = sizes[Observable.TRAJECTORY], sizes[Observable.VELOCITIES], scene.axes
    ends = None
    if scene.until is None:
        ends = (min if rough.settled and right.settled else max)(rough.time, right.time)

    def spread(time: float | None) -> list[float]:
        first, second = (p.state if time is None else state_at(scene, p, time) for p in (rough, right))
        # At a hit velocities jump, and places do not.
        jumps = time is not None and rough.hits_before(time) != right.hits_before(time)
        own = [
            max(
                math.dist(place(scene, first, i), place(scene, second, i)) / long,
                0.0 if jumps else math.dist(velocity(scene, first, i), velocity(scene, second, i)) / fast,
            )
            for i in range(len(scene.bodies))
        ]
        return _handed_on(scene, own)

    match what:
        case Observable.VELOCITIES:
            return [each * fast for each in spread(ends) for _ in range(axes)]
        case Observable.TRAJECTORY:
            return [each * long for time in times for each in spread(time) for _ in range(axes)]
        case Observable.IMPULSE:
            loose = [(b.mass, s) for b, s in zip(scene.bodies, spread(ends), strict=True)]
            return [m * s * fast for m, s in loose if not math.isinf(m) for _ in range(axes)]
        case _:
            return [max(spread(ends))]


def _handed_on(scene: Scene, own: Sequence[float]) -> list[float]:
    """With what those are off that a body is tied to: they pull it along, as far as their masses can; by chance two runs may agree about it."""
    found, masses = list(own), [body.mass for body in scene.bodies]
    for a, b in (force.ends for force in scene.forces if isinstance(force, ForceBetween)):
        for i, j in ((a, b), (b, a)):
            if not math.isinf(masses[j]):
                found[i] = max(found[i], HANDED_ON * min(1.0, masses[j] / masses[i]) * own[j])
    return found


def largest_of_body(scene: Scene, what: Observable, each: Sequence[float]) -> list[float]:
    """For every component the largest of its body's, where bodies have such; otherwise of all."""
    axes = scene.axes if what in BY_BODY else len(each) or 1
    return [max(each[i - i % axes : i - i % axes + axes]) for i in range(len(each))]


def apart_by(a: Observed, b: Observed) -> tuple[float, ...]:
    """How far two values are apart, component by component; infinitely where they have not as many."""
    first, second = components(a), components(b)
    if len(first) != len(second):
        return (math.inf,) * len(second)
    return tuple(abs(x - y) if x != y else 0.0 for x, y in zip(first, second, strict=True))
