"""A drop falls and takes up vapour on its way (section 12.7, test your understanding)."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.forces.absorption import Absorption
from corollary.scenes.forces.weight import Weight
from corollary.scenes.models.certain import Evaluated, balls, found
from corollary.scenes.run import Observable, Observed, Run, by_relative_errors, components
from corollary.scenes.scene import Body, Scene

SETTINGS = (
    Setting("m", "mass of the drop at the start", "kg", 2.0, above=0.0),
    Setting("v", "velocity of the drop at the start, downwards", "m/s", 6.0),
    Setting("R", "vapour taken up per time", "kg/s", 0.4, least=0.0),
    Setting("u", "velocity of the vapour, downwards", "m/s", 0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, least=0.0),
    Setting("t", "time of the fall", "s", 1.5, above=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Velocity and way (both downwards) after the time t, and the mass then.

    Momentum is what the drop had, what the vapour brought, and the push of a growing weight; the way is the integral of
    v = u + g (m + R t)/(2 R) + c/(m + R t).
    """
    return found(lambda: _evaluated(settings))


def _evaluated(settings: Mapping[str, Observed]) -> Evaluated:
    m, v, rate, u, g, t = balls(settings, "m", "v", "R", "u", "g", "t")
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


def stepped(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """The same by Newton's second law in steps: each moment the vapour, slower by v - u, pulls with R (v - u)."""
    from corollary.scenes.measure import measured  # here, since it brings scipy

    m, v, rate, u, g, t = (one(settings, name) for name in ("m", "v", "R", "u", "g", "t"))
    drop = Scene(
        (Body(m, (0.0,), (-v,)),), (Weight(g), Absorption(0, (-u,), rate)), until=t, name="growing_drop"
    )
    why = "a force that depends on velocity and time, a mass that grows: Newton's second law, step by step"
    run = measured(drop, {Observable.VELOCITIES, Observable.TRAJECTORY}, tolerance, why, times=(t,))
    (fall,), (place,) = (components(run.observed[name]) for name in ("velocities", "trajectory"))
    observed: dict[str, Observed] = {"velocities": (-fall,), "way": -place, "mass": m + rate * t}
    errors = {
        "velocities": run.relative_error("velocities"),
        "way": run.relative_error("trajectory"),
        "mass": 2e-16,
    }
    # A drop that is blown up and falls again may end where it began: its errors are those of the way that it went.
    scales = {"velocities": run.measured["velocities"].size, "way": run.measured["trajectory"].size}
    return by_relative_errors(observed, errors, run.model, run.why, run.evaluations, "bound", scales)


SCENE = SceneDefinition("a drop takes up vapour as it falls", SETTINGS, play)
