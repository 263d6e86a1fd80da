"""Scenes far from the origin, followed from an origin of their own: doubles know places there as finely as bodies need them."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace

from corollary.scenes import measure
from corollary.scenes.run import Measurement, Observable, Run, components
from corollary.scenes.scene import Scene, start_of
from corollary.scenes.validation import is_own

FAR = 100.0
"""So many times as far from the origin as from each other bodies are far: two digits are lost there, and differences of their places exact."""
OF_THE_ORIGIN = {Observable.TURNING_POINTS, Observable.PERIOD, Observable.ENERGY}
"""Distances from it, and potentials that are zero there."""


def measured(
    scene: Scene, observe: Collection[Observable], tolerance: float, why: str, times: Sequence[float] = ()
) -> list[Run]:
    """`measure.measured` in one run; in two where bodies are far from the origin: what knows none comes from one among them, first."""
    free = set(observe) - OF_THE_ORIGIN
    nearer = _nearer(scene) if free else None
    if nearer is None:
        return [measure.measured(scene, observe, tolerance, why, times)]
    near, origin = nearer
    run = measure.measured(near, free, tolerance, why, times)
    name = Observable.TRAJECTORY.value
    if name in run.measured:
        run = replace(run, measured=run.measured | {name: _moved_back(run.measured[name], origin)})
    tied = OF_THE_ORIGIN.intersection(observe)
    return [run, measure.measured(scene, tied, tolerance, why)] if tied else [run]


def _nearer(scene: Scene) -> tuple[Scene, tuple[float, ...]] | None:
    """The scene from the place of its first body along axes on which all are far, and that place; none where a force cannot be told from there."""
    first, start = scene.bodies[0].place, start_of(scene)
    gaps = (constraint.gap(0.0, start) for force in scene.forces for constraint in force.constraints(scene))
    sizes = (size for body in scene.bodies for size in (math.dist(body.place, first), body.radius))
    spread = max(*sizes, *map(abs, gaps))
    origin = tuple(x if abs(x) > FAR * spread else 0.0 for x in first)
    if not spread or not any(origin):
        return None
    forces = [None if is_own(force) else force.from_origin(origin) for force in scene.forces]
    known = tuple(force for force in forces if force is not None)
    if len(known) < len(forces):
        return None
    bodies = tuple(
        replace(body, place=tuple(x - o for x, o in zip(body.place, origin, strict=True)))
        for body in scene.bodies
    )
    return replace(scene, bodies=bodies, forces=known), origin


def _moved_back(found: Measurement, origin: tuple[float, ...]) -> Measurement:
    places = [x + origin[i % len(origin)] for i, x in enumerate(components(found.value))]
    errors = [e + math.ulp(x) for e, x in zip(components(found.error), places, strict=True)]
    size = max([found.size, *map(abs, places)])
    condition = None if found.condition is None else found.condition * found.size / size
    return replace(found, value=tuple(places), error=tuple(errors), size=size, condition=condition)
