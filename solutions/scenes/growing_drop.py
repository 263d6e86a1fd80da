"""A drop falls and takes up vapour on its way (section 12.7, test your understanding)."""

from __future__ import annotations

from second_way import followed

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Absorption
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.run import (
    Observable,
    Observed,
    Run,
    by_relative_errors,
    components,
)
from corollary.scenes.scene import Body, Scene

SETTINGS = (
    Setting("m", "mass of the drop at the start", "kg", 2.0, above=0.0),
    Setting("v", "velocity of the drop at the start, downwards", "m/s", 6.0),
    Setting("R", "vapour taken up per time", "kg/s", 0.4, least=0.0),
    Setting("u", "velocity of the vapour, downwards", "m/s", 0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, least=0.0),
    Setting("t", "time of the fall", "s", 1.5, above=0.0),
)


def _evaluated(m: Ball, v: Ball, rate: Ball, u: Ball, g: Ball, t: Ball) -> Evaluated:
    """Velocity and way (both downwards) after the time t, and the mass then.

    Momentum is what the drop had, what the vapour brought, and the push of a growing weight; the way is the integral of
    v = u + g (m + R t)/(2 R) + c/(m + R t).
    """
    mass = m + rate * t
    velocity = (m * v + rate * t * u + g * t * (m + mass) / 2) / mass
    if rate.is_zero():
        way = v * t + g * t * t / 2
    else:
        c = m * (v - u) - g * m * m / (2 * rate)
        way = u * t + g * t * (m + mass) / (4 * rate) + c / rate * (rate * t / m).log1p()
    values = {"velocities": (velocity,), "way": way, "mass": mass}
    why = "momentum gives the velocity of a drop whose mass is known, and its integral is a logarithm"
    return Evaluated("bound", values, "piecewise exact", why)


def second_way(settings: Settings, tolerance: float) -> Run:
    """Each moment the vapour, slower by v - u, pulls with R (v - u)."""
    m, v, rate, u, g, t = numbers(settings, "m", "v", "R", "u", "g", "t")
    forces = Weight(g), Absorption(0, (-u,), rate)
    drop = Scene((Body(m, (0.0,), (-v,)),), forces, until=t, name="growing_drop")
    run = followed(drop, {Observable.VELOCITIES, Observable.TRAJECTORY}, tolerance, (t,))
    fallen, gone = run.measured["velocities"], run.measured["trajectory"]
    (fall,), (place,) = components(fallen.value), components(gone.value)
    observed: dict[str, Observed] = {"velocities": (-fall,), "way": -place, "mass": m + rate * t}
    errors = {"velocities": fallen.relative_error, "way": gone.relative_error, "mass": 2e-16}
    # A drop that is blown up and falls again may end where it began: its errors are those of the way that it went.
    scales = {"velocities": fallen.size, "way": gone.size}
    why = "a force that depends on velocity and time, a mass that grows: Newton's second law, step by step"
    return by_relative_errors(observed, errors, run.model, why, run.evaluations, "bound", scales)


SCENE = by_formulas("a drop takes up vapour as it falls", SETTINGS, _evaluated, second_way=second_way)
