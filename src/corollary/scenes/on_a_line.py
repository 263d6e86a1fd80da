"""Scenes of an author's own that are bodies in a row: momentum and energy alone, or the collision on a line by its own models."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from itertools import pairwise

from corollary.scenes.collision import Collided, collide
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.weight import Weight
from corollary.scenes.models.certain import found
from corollary.scenes.models.pair import refuse_too_soft
from corollary.scenes.models.two_bodies import collision
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import Observable, Observed, Run, by_relative_errors, components
from corollary.scenes.scene import Scene

OF_BODIES_ALONE = {Observable.IMPULSE, Observable.MOMENTUM, Observable.ENERGY}
BEFORE_AND_AFTER = {Observable.VELOCITIES, Observable.ENERGY_RATIO} | OF_BODIES_ALONE
ALONE_ON_A_LINE = BEFORE_AND_AFTER | {Observable.DURATION, Observable.LARGEST_OVERLAP, Observable.PEAK_FORCE}
ON_A_LINE = ALONE_ON_A_LINE - OF_BODIES_ALONE


def on_a_line(scene: Scene, observe: Collection[Observable], tolerance: float) -> Run | None:
    """Bodies in a row that touch their neighbours, perhaps on a floor."""
    line = as_line(scene)
    if line is None or not set(observe) <= (ALONE_ON_A_LINE if line.weight == 0.0 else ON_A_LINE):
        return None
    contact = line.contacts[0]
    touching = len(line.masses) == 2 and line.gaps[0] >= 0.0 and line.weight == 0.0
    if touching and (contact.eta == 0.0 or contact.q == 1.0):
        (a, b), (u, v) = line.masses, line.velocities
        run = found(lambda: collision((a, b), (u, v), contact))
        depth = run.observed["largest_overlap"]
        _refuse_too_soft(scene, components(depth))
        return run.only(o.value for o in observe)
    result = collide(line, tolerance)
    _refuse_too_soft(scene, result.result.overlaps)
    return _collided(line, result, observe)


def _refuse_too_soft(scene: Scene, overlaps: Sequence[float]) -> None:
    """Raises BadSetting when neighbours are so soft that they pass through each other; points without a radius keep their order."""
    for overlap, (a, b) in zip(overlaps, pairwise(scene.bodies), strict=True):
        if a.radius + b.radius > 0.0:
            refuse_too_soft(overlap, a.radius + b.radius)


def as_line(scene: Scene) -> RowOfBodies | None:
    """The scene as bodies in a row that touch their neighbours, if it is one; weight needs a floor below."""
    if (
        scene.axes != 1
        or scene.until is not None
        or not all(isinstance(force, (Contact, Weight)) for force in scene.forces)
        or len(scene.bodies) < 2
    ):
        return None
    contacts = [force for force in scene.forces if isinstance(force, Contact)]
    if any(contact.chosen is not None for contact in contacts) or scene.passes:
        return None
    weight = math.fsum(force.g for force in scene.forces if isinstance(force, Weight))
    row = sorted(scene.bodies, key=lambda body: body.place)
    walls = [i for i, body in enumerate(row) if math.isinf(body.mass)]
    if len(contacts) != 1 or row != list(scene.bodies) or len(walls) > 1 or (weight and walls != [0]):
        return None
    return RowOfBodies(
        masses=tuple(body.mass for body in row),
        velocities=tuple(body.velocity[0] for body in row),
        gaps=tuple(b.place[0] - a.place[0] - a.radius - b.radius for a, b in pairwise(row)),
        contacts=tuple(contacts) * (len(row) - 1),
        weight=weight,
    )


def _kinetic(line: RowOfBodies, velocities: tuple[float, ...]) -> float:
    return sum(0.5 * m * v * v for m, v in zip(line.masses, velocities, strict=True) if not math.isinf(m))


def _alone(line: RowOfBodies, after: tuple[float, ...]) -> dict[Observable, Observed]:
    """What velocities say of bodies on which nothing acts but each other."""
    loose = [
        (m, u, v) for m, u, v in zip(line.masses, line.velocities, after, strict=True) if not math.isinf(m)
    ]
    return {
        Observable.IMPULSE: tuple(m * (v - u) for m, u, v in loose),
        Observable.MOMENTUM: (math.fsum(m * v for m, _, v in loose),),
        Observable.ENERGY: _kinetic(line, after),
    }


def _scales(line: RowOfBodies) -> dict[str, float]:
    """The sizes that rounding and steps are a share of: what came in, not what is left of it."""
    fast = max(map(abs, line.velocities))
    heavy = max(m for m in line.masses if not math.isinf(m))
    return {
        "velocities": fast,
        "impulse": heavy * fast,
        "momentum": heavy * fast,
        "energy_ratio": 1.0,
    }


def _collided(line: RowOfBodies, found: Collided, observe: Collection[Observable]) -> Run:
    result = found.result
    before = _kinetic(line, line.velocities)
    known: dict[Observable, tuple[Observed, str]] = {
        Observable.VELOCITIES: (result.velocities, "velocities"),
        Observable.DURATION: (result.duration, "duration"),
        Observable.LARGEST_OVERLAP: (max(result.overlaps), "overlaps"),
        Observable.PEAK_FORCE: (max(result.forces), "forces"),
        Observable.ENERGY_RATIO: (
            _kinetic(line, result.velocities) / before if before else math.inf,
            "velocities",
        ),
        **{what: (value, "velocities") for what, value in _alone(line, result.velocities).items()},
    }
    observed = {o.value: known[o][0] for o in observe}
    errors = {o.value: found.errors.get(known[o][1], 0.0) for o in observe}
    return by_relative_errors(
        observed, errors, found.model, found.why, found.spent, result.outcome, _scales(line), found.warnings
    )
