"""Scenes of an author's own that a ready model answers without following them in time: two spheres, a well, a fixed centre."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import replace

from corollary.scenes.collision import ROUNDING
from corollary.scenes.conserved import impulses, momentum
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.inverse_square import InverseSquare
from corollary.scenes.forces.well import Well
from corollary.scenes.integrate.equations_of_motion import energy
from corollary.scenes.library import atom, spheres
from corollary.scenes.models.central import orbit
from corollary.scenes.run import Observable, Observed, Run
from corollary.scenes.scene import Scene, start_of

OF_A_PAIR = {
    Observable.VELOCITIES,
    Observable.DURATION,
    Observable.LARGEST_OVERLAP,
    Observable.PEAK_FORCE,
    Observable.ENERGY_RATIO,
    Observable.IMPULSE,
    Observable.MOMENTUM,
    Observable.ENERGY,
}
OF_AN_ORBIT = {Observable.PERIOD, Observable.TURNING_POINTS}
# A period is seen when the distance has come back to its least value twice; until then "turning points" are those met so far.
SEEN = 2.0


def in_a_plane(scene: Scene, observe: Collection[Observable], tolerance: float) -> Run | None:
    """Two spheres that nothing else acts on: quadrature without damping, else the contact followed in its own time."""
    if scene.axes != 2 or scene.until is not None or len(scene.bodies) != 2 or not set(observe) <= OF_A_PAIR:
        return None
    a, b = scene.bodies
    reach = a.radius + b.radius
    match scene.forces:
        case (Contact() as contact,) if (
            reach > 0.0 and not math.isinf(a.mass) and not math.isinf(b.mass) and a.place != b.place
        ):
            pass
        case _:
            return None
    settings: dict[str, Observed] = {
        "mA": a.mass,
        "mB": b.mass,
        "R": 0.5 * reach,
        "k": contact.k,
        "q": contact.q,
        "eta": contact.eta,
        "dx": b.place[0] - a.place[0],
        "dy": b.place[1] - a.place[1],
        "vA": a.velocity,
        "vB": b.velocity,
    }
    played = spheres.play(settings, tolerance)
    velocities = played.observed["velocities"]
    assert isinstance(velocities, tuple)
    start = start_of(scene)
    after = [*start[:4], *velocities]
    # Once the spheres are apart nothing is stored, and while they stick it has faded.
    apart = replace(scene, forces=())
    known = played.observed | {
        "impulse": impulses(scene, start, after),
        "momentum": momentum(scene, 0.0, after),
        "energy": energy(apart, 0.0, after),
    }
    error = max(played.errors["velocities"], ROUNDING)
    return _observed_only(replace(played, observed=known, errors=dict.fromkeys(known, error)), observe)


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
    settings: dict[str, Observed] = {
        "m": body.mass,
        "k": well.k,
        "b": well.b,
        "d": well.d,
        "dimension": float(scene.axes),
        "r0": (*body.place, 0.0)[:2],
        "v0": (*body.velocity, 0.0)[:2],
    }
    played = atom.play(settings, tolerance)
    until = math.inf if scene.until is None else scene.until
    match played.outcome:
        case "bound":
            period = played.observed["period"]
            fits = set(observe) <= OF_AN_ORBIT and isinstance(period, float) and until >= SEEN * period
        case "escaped":
            gone = played.observed["duration"]
            # One that starts across the radius turns at once, which these integrals do not count.
            observable = (
                {Observable.VELOCITIES, Observable.TURNING_POINTS}
                if played.observed["turning_points"]
                else {Observable.VELOCITIES}
            )
            fits = set(observe) <= observable and isinstance(gone, float) and until >= gone
        case _:
            fits = set(observe) <= {Observable.VELOCITIES}
    return _observed_only(played, observe) if fits else None


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
    r = math.hypot(x, y)
    found = orbit(strength / body.mass, r, (x * u + y * v) / r, (x * v - y * u) / r)
    if found is None:
        return None
    if math.isinf(found.period):
        # It turns once at most; when, no closed form says.
        if scene.until is not None or Observable.PERIOD in observe:
            return None
        turns: Observed = (found.nearest,) if x * u + y * v < 0.0 else ()
        known: dict[str, Observed] = {"turning_points": turns}
        why = "it comes and goes: energy and angular momentum give the nearest distance, the root of a quadratic"
        return _observed_only(
            Run(known, dict.fromkeys(known, 4.0 * ROUNDING), "conservation", why, 0, "escaped"), observe
        )
    if scene.until is not None and scene.until < SEEN * found.period:
        return None
    known = {"turning_points": (found.nearest, found.farthest), "period": found.period}
    why = "bound to a fixed centre: energy and angular momentum give the orbit, Kepler's third law its period"
    return _observed_only(
        Run(known, dict.fromkeys(known, 8.0 * ROUNDING), "conservation", why, 0, "bound"), observe
    )


def _observed_only(played: Run, observe: Collection[Observable]) -> Run:
    names = [o.value for o in observe]
    return replace(
        played, observed={n: played.observed[n] for n in names}, errors={n: played.errors[n] for n in names}
    )
