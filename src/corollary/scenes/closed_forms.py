"""Composed scenes that a ready model answers without time steps: rows of bodies, two spheres, a well, a fixed centre."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from itertools import pairwise

from corollary.formula.ball import Ball
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.inverse_square import InverseSquare
from corollary.scenes.forces.weight import Weight
from corollary.scenes.forces.well import Well
from corollary.scenes.integrate.single_contact import collided
from corollary.scenes.line_collision import Collided, collide
from corollary.scenes.models.central import in_well, orbit
from corollary.scenes.models.certain import Balls, Evaluated, found, sign
from corollary.scenes.models.pair import Pair, refuse_too_soft
from corollary.scenes.models.two_bodies import collision
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import GuardFailed, Measurement, Observable, Observed, Run, components
from corollary.scenes.scene import Scene

OF_BODIES_ALONE = {Observable.IMPULSE, Observable.MOMENTUM, Observable.ENERGY}
BEFORE_AND_AFTER = {Observable.VELOCITIES, Observable.ENERGY_RATIO} | OF_BODIES_ALONE
ALONE_ON_A_LINE = BEFORE_AND_AFTER | {Observable.DURATION, Observable.LARGEST_OVERLAP, Observable.PEAK_FORCE}
ON_A_LINE = ALONE_ON_A_LINE - OF_BODIES_ALONE
OF_AN_ORBIT = {Observable.PERIOD, Observable.TURNING_POINTS}
# A period is seen when the distance has come back to its least value twice, both turning points after one; until then those are met so far.
SEEN = {Observable.PERIOD: 2.0, Observable.TURNING_POINTS: 1.0}


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


def in_a_well(scene: Scene, observe: Collection[Observable], tolerance: float) -> Run | None:
    """One body in a well: bound, its period and turning points; or its velocity once it has left."""
    if len(scene.bodies) != 1 or math.isinf(scene.bodies[0].mass):
        return None
    (body,) = scene.bodies
    if scene.axes == 1 and body.place[0] < 0.0:
        return None
    match scene.forces:
        case (Well() as well,) if well.d < well.b and math.hypot(*body.place) >= well.wall:
            pass
        case _:
            return None
    (x, y), (u, v) = (*body.place, 0.0)[:2], (*body.velocity, 0.0)[:2]
    played = found(lambda: in_well(well, body.mass, (x, y), (u, v), scene.axes == 2))
    until = math.inf if scene.until is None else scene.until
    match played.outcome:
        case "bound":
            period = played.observed["period"]
            fits = set(observe) <= OF_AN_ORBIT and isinstance(period, float) and _seen(observe, until, period)
        case "escaped":
            gone = played.observed["duration"]
            # One that starts across the radius turns at once, which these integrals do not count.
            turned = {Observable.TURNING_POINTS} if played.observed["turning_points"] else set[Observable]()
            observable = {Observable.VELOCITIES} | turned
            fits = set(observe) <= observable and isinstance(gone, float) and until >= gone
        case _:
            fits = set(observe) <= {Observable.VELOCITIES}
    return played.only(o.value for o in observe) if fits else None


def round_a_centre(scene: Scene, observe: Collection[Observable], tolerance: float) -> Run | None:
    """One body under an inverse-square force from a wall-like body at rest in the origin: its orbit closes."""
    if len(scene.bodies) != 2 or not set(observe) <= OF_AN_ORBIT:
        return None
    body, centre = scene.bodies
    at_rest = math.isinf(centre.mass) and not any(centre.place) and not any(centre.velocity)
    match scene.forces:
        case (InverseSquare(ends=ends, strength=strength),) if (
            set(ends) == {0, 1} and at_rest and any(body.place)
        ):
            pass
        case _:
            return None
    (x, y), (u, v) = (*body.place, 0.0)[:2], (*body.velocity, 0.0)[:2]
    run = found(lambda: _orbit(strength, body.mass, (x, y), (u, v)))
    if run.outcome == "missed":
        return None
    if run.outcome == "escaped":
        # It turns once at most; when, no closed form says.
        if scene.until is not None or Observable.PERIOD in observe:
            return None
    else:
        period = run.observed["period"]
        if scene.until is not None and isinstance(period, float) and not _seen(observe, scene.until, period):
            return None
    _refuse_overlap(scene, min([math.hypot(x, y), *components(run.observed["turning_points"])]))
    return run.only(o.value for o in observe)


def _seen(observe: Collection[Observable], until: float, period: float) -> bool:
    """Whether by the end (s) everything that is asked of an orbit has shown."""
    return until >= period * max(SEEN[what] for what in observe)


def _refuse_overlap(scene: Scene, nearest: float) -> None:
    """Raises GuardFailed where two bodies that no contact acts between come so near (m) that they overlap, as who follows them does."""
    body, centre = scene.bodies
    solid = body.radius > 0.0 and centre.radius > 0.0 and not scene.passes
    if solid and nearest < body.radius + centre.radius:
        raise GuardFailed(
            f"{scene.name}: bodies 0 and 1 come as near as {nearest:.6g} m, where they overlap, and no contact acts between them. "
            "Give them one, or radius zero, or name them in passes=…"
        )


def _orbit(
    strength: float, mass: float, place: tuple[float, float], velocity: tuple[float, float]
) -> Evaluated:
    """As a run; missed when the body meets the centre."""
    seen = orbit(strength, mass, place, velocity)
    if seen is None:
        return Evaluated("missed", {}, "conservation", "it meets the centre")
    if seen.farthest is None or seen.period is None:
        (x, y), (u, v) = (tuple(map(Ball, each)) for each in (place, velocity))
        turns = (seen.nearest,) if sign(x * u + y * v) < 0 else ()
        why = "it comes and goes: energy and angular momentum give the nearest distance, the root of a quadratic"
        return Evaluated("escaped", {"turning_points": turns}, "conservation", why)
    why = "bound to a fixed centre: energy and angular momentum give the orbit, Kepler's third law its period"
    values: dict[str, Balls] = {"turning_points": (seen.nearest, seen.farthest), "period": seen.period}
    return Evaluated("bound", values, "conservation", why)
