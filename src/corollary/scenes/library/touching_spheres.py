"""Two spheres watched for a time while they push each other and both fall: the weight is the one force from outside (12.4, 12.6)."""

from __future__ import annotations

import math

from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers
from corollary.scenes.forces.weight import Weight
from corollary.scenes.library.spheres import pair_of
from corollary.scenes.measure import measured
from corollary.scenes.models.pair import refuse_too_soft
from corollary.scenes.run import BadSetting, Observable, Run, by_relative_errors
from corollary.scenes.scene import Body, Scene

SETTINGS = (
    Setting("mA", "mass of A", "kg", 0.2, above=0.0),
    Setting("mB", "mass of B", "kg", 0.3, above=0.0),
    Setting("R", "radius of each sphere", "m", 0.05, above=0.0),
    Setting("k", "contact constant", "N/m^q", 1.2e4, above=0.0),
    Setting("q", "exponent of the contact force", "1", 1.0, least=1.0, most=10.0),
    Setting("eta", "viscous constant", "kg/s", 0.0, least=0.0),
    Setting("dx", "x of B seen from A at the start", "m", 0.06),
    Setting("dy", "y of B seen from A at the start, up", "m", 0.08),
    Setting("vA", "velocity of A (x, y)", "m/s", (3.0, 4.0), many=True),
    Setting("vB", "velocity of B (x, y)", "m/s", (-0.75, -1.0), many=True),
    Setting("g", "acceleration of gravity, against y", "m/s^2", 9.8, least=0.0),
    Setting("t", "time for which they are watched", "s", 0.01, above=0.0),
)
# So many times the drag alone would have stopped the spheres: steps as short as that would not come to an end.
MOST_FADING = 1e4


def play(settings: Settings, tolerance: float) -> Run:
    """After the time t: `velocities` (A x, A y, B x, B y), the total `momentum` (x, y), and the kinetic energy over that at the start.

    `duration` is how long they touched while they were watched.
    `momentum_change` (x, y) is that of both together; `mean_force` (x, y) is that of B on A while they were watched, without the
    weight. Each is there only if its force is.
    """
    pair = pair_of(settings, "touching_spheres")
    ma, mb, reach, contact, (va, vb) = pair.mass_a, pair.mass_b, pair.reach, pair.contact, pair.velocities
    g, t = numbers(settings, "g", "t")
    if contact.eta * t * (1.0 / ma + 1.0 / mb) > MOST_FADING:
        raise BadSetting(
            "touching_spheres: the drag has stopped the spheres long before the time t; lower eta, or t."
        )
    bodies = Body(ma, (0.0, 0.0), va, 0.5 * reach, "A"), Body(mb, pair.apart, vb, 0.5 * reach, "B")
    forces = (contact, Weight(g)) if g else (contact,)
    seen = {Observable.VELOCITIES, Observable.DURATION, Observable.LARGEST_OVERLAP, Observable.ENERGY_RATIO}
    why = "contact and weight act at once: Newton's second law, step by step"
    run = measured(Scene(bodies, forces, until=t, name="touching_spheres"), seen, tolerance, why)
    after, overlap = run.observed["velocities"], run.observed["largest_overlap"]
    assert isinstance(after, tuple)
    assert isinstance(overlap, float)
    refuse_too_soft(overlap, reach)
    observed, errors = run.observed, {name: each.relative_error for name, each in run.measured.items()}
    scales = {name: each.size for name, each in run.measured.items()}
    on_a, on_b = (
        (m * (v - u), m * (w - s)) for m, (u, s), (v, w) in ((ma, va, after[:2]), (mb, vb, after[2:]))
    )
    # Momenta are differences: what rounding or steps leave of a velocity may be much of a small change.
    off = errors["velocities"] * scales["velocities"]
    error_estimate = off * max(ma, mb)
    thrown = scales["velocities"] * max(ma, mb)
    # The energy goes with the squares of the velocities, those of the body that moves fast too.
    swift = ma * math.hypot(*after[:2]) + mb * math.hypot(*after[2:])
    had = 0.5 * (ma * math.hypot(*va) ** 2 + mb * math.hypot(*vb) ** 2)
    ratio = observed.get("energy_ratio")
    if isinstance(ratio, float) and ratio > 0.0:
        errors["energy_ratio"] = max(errors["energy_ratio"], swift * off / had / scales["energy_ratio"])
    observed["momentum"] = ma * after[0] + mb * after[2], ma * after[1] + mb * after[3]
    errors["momentum"], scales["momentum"] = _share(2.0 * error_estimate, observed["momentum"], thrown)
    if overlap > 0.0:
        observed["mean_force"] = push = on_a[0] / t, (on_a[1] + ma * g * t) / t
        errors["mean_force"], scales["mean_force"] = _share(error_estimate / t, push, thrown / t)
    if g:
        observed["momentum_change"] = change = on_a[0] + on_b[0], on_a[1] + on_b[1]
        errors["momentum_change"], scales["momentum_change"] = _share(2.0 * error_estimate, change, thrown)
    outcome = "released" if overlap > 0.0 else "missed"
    return by_relative_errors(
        observed, errors, run.model, run.why, run.evaluations, outcome, scales, run.warnings
    )


def _share(error_estimate: float, of: tuple[float, ...], natural: float) -> tuple[float, float]:
    """An error in units of a value's size, and that: of what is zero, its natural size."""
    size = max(map(abs, of)) or natural
    return error_estimate / size, size


SCENE = SceneDefinition("two spheres push each other while both fall", SETTINGS, play)
