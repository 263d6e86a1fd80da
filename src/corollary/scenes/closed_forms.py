"""Composed scenes that a ready model answers without the loop of composed scenes: rows of bodies, and two spheres."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.weight import Weight
from corollary.scenes.integrate.single_contact import collided
from corollary.scenes.line_collision import Collided, collide
from corollary.scenes.models.certain import found
from corollary.scenes.models.pair import Pair, refuse_too_soft
from corollary.scenes.models.two_bodies import collision
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import Measurement, Observable, Observed, Run, components
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
        if run.outcome == "sticks":
            endless = Measurement(math.inf, 0.0, "bound", run.model, run.why, math.inf)
            run = replace(run, measured=run.measured | {Observable.DURATION.value: endless})
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
    if (
        contacts[0].eta > 0.0 and len(row) > 2
    ):  # whether several damped contacts stay together the loop of composed scenes tells
        return None
    return RowOfBodies(
        masses=tuple(body.mass for body in row),
        velocities=tuple(body.velocity[0] for body in row),
        gaps=tuple(b.place[0] - a.place[0] - a.radius - b.radius for a, b in pairwise(row)),
        contacts=tuple(contacts) * (len(row) - 1),
        weight=weight,
    )


def _collided(line: RowOfBodies, found: Collided, observe: Collection[Observable]) -> Run:
    result = found.result
    loose = [
        (m, u, v)
        for m, u, v in zip(line.masses, line.velocities, result.velocities, strict=True)
        if not math.isinf(m)
    ]
    before, after = sum(0.5 * m * u * u for m, u, _ in loose), sum(0.5 * m * v * v for m, _, v in loose)
    known: dict[Observable, Observed] = {
        Observable.VELOCITIES: result.velocities,
        Observable.DURATION: result.duration,
        Observable.LARGEST_OVERLAP: max(result.overlaps),
        Observable.PEAK_FORCE: max(result.forces),
        Observable.ENERGY_RATIO: after / before if before else math.inf,
        Observable.IMPULSE: tuple(m * (v - u) for m, u, v in loose),
        Observable.MOMENTUM: (math.fsum(m * v for m, _, v in loose),),
        Observable.ENERGY: after,
    }
    # Rounding and steps are a share of what came in, not of what is left of it.
    fast = max(map(abs, line.velocities))
    thrown = max(m for m, _, _ in loose) * fast
    scales = {
        "velocities": fast,
        "impulse": thrown,
        "momentum": thrown,
        "energy": before,
        "energy_ratio": 1.0,
    }
    return found.observed({o.value: known[o] for o in observe}, scales)


def in_a_plane(scene: Scene, observe: Collection[Observable], tolerance: float) -> Run | None:
    """Two spheres that nothing else acts on: quadrature without damping, else the contact followed in its own time."""
    if (
        scene.axes != 2
        or scene.until is not None
        or len(scene.bodies) != 2
        or not set(observe) <= ALONE_ON_A_LINE
    ):
        return None
    a, b = scene.bodies
    reach = a.radius + b.radius
    match scene.forces:
        case (Contact() as contact,) if (
            reach > 0.0
            and not contact.rubs_surfaces
            and contact.chosen is None
            and not (a.spin or b.spin or scene.passes)
            and not math.isinf(a.mass)
            and not math.isinf(b.mass)
            and a.place != b.place
        ):
            pass
        case _:
            return None
    (ax, ay), (bx, by), (ua, va), (ub, vb) = a.place, b.place, a.velocity, b.velocity
    pair = Pair(a.mass, b.mass, (bx - ax, by - ay), ((ua, va), (ub, vb)), reach, contact)
    run = collided(pair, tolerance)
    of_each = replace(run, measured=run.measured | {"impulse": run.measured["impulses"]})
    return of_each.only(o.value for o in observe)
