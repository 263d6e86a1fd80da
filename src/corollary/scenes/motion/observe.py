"""Every observable, read off a trajectory; and how the scene ended."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import assert_never

from corollary.scenes.motion.energy import energy, impulses, kinetic, masses_at, momentum
from corollary.scenes.motion.lookup import contact_span, contact_stretches, depth_of, flat, largest, turns
from corollary.scenes.motion.path import Trajectory
from corollary.scenes.run import BadSetting, Observable, Observed, Outcome
from corollary.scenes.scene import Scene, overlap, pairs, place, spin, start_of, velocity


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
    fast = (
        max(
            abs(v)
            for stretch in path.stretches or ()
            for v in stretch.before[scene.axes * len(scene.bodies) :]
        )
        if path.stretches
        else 1.0
    )
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
                largest(path, depth_of(scene, a, b), contact_stretches(path, j))
                for j, (_, a, b) in enumerate(served)
            ]
            # Bodies that pass through each other on purpose overlap as well.
            passed = [
                largest(path, depth_of(scene, a, b), path.stretches)
                for a, b in pairs(scene)
                if (a, b) not in chosen
            ]
            at_start = [overlap(scene, start_of(scene), a, b)[0] for a, b in pairs(scene)]
            return max([0.0, *found, *passed, *at_start])
        case Observable.PEAK_FORCE:
            return max(
                (
                    largest(
                        path,
                        lambda y, f=f, a=a, b=b: math.hypot(*f.between(scene, y, a, b)),
                        contact_stretches(path, j),
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
                    f"{scene.name}: the distance did not return twice before until = {scene.until} s."
                )
            return (inner[-1] - inner[0]) / (len(inner) - 1)
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
