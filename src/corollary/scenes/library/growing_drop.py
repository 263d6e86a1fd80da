"""A drop falls and takes up vapour on its way (section 12.7, test your understanding)."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.forces.absorption import Absorption
from corollary.scenes.forces.weight import Weight
from corollary.scenes.measure import measured
from corollary.scenes.run import Observable, Observed, Run, by_relative_errors
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

    Each moment the vapour, slower by v - u, pulls with R (v - u): that is what bringing it to the drop's velocity takes.
    """
    m, v, rate, u, g, t = (one(settings, name) for name in ("m", "v", "R", "u", "g", "t"))
    drop = Scene(
        (Body(m, (0.0,), (-v,)),), (Weight(g), Absorption(0, (-u,), rate)), until=t, name="growing_drop"
    )
    why = "a force that depends on velocity and time, a mass that grows: Newton's second law, step by step"
    run = measured(drop, {Observable.VELOCITIES, Observable.TRAJECTORY}, tolerance, why, times=(t,))
    fall, place = run.observed["velocities"], run.observed["trajectory"]
    assert isinstance(fall, tuple)
    assert isinstance(place, tuple)
    observed: dict[str, Observed] = {"velocities": (-fall[0],), "way": -place[0], "mass": m + rate * t}
    errors = {
        "velocities": run.relative_error("velocities"),
        "way": run.relative_error("trajectory"),
        "mass": 2e-16,
    }
    return by_relative_errors(observed, errors, run.model, run.why, run.evaluations, "bound")


SCENE = SceneDefinition("a drop takes up vapour as it falls", SETTINGS, play)
