"""A body pushed for a short time: what the push does to its velocity (exercises 12.5 and 12.6)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.models.gauss import integral
from corollary.scenes.run import Observed, Run

SETTINGS = (
    Setting("m", "mass of the body", "kg", 0.43, above=0.0),
    Setting("v0", "velocity before the push", "m/s", 0.0),
    Setting("F", "time-averaged force", "N", 86.0),
    Setting("dt", "time of contact", "s", 0.1, above=0.0),
    Setting(
        "pulse",
        "shape: F(t) goes as sin(pi t/dt)^pulse, 0 for a constant force",
        "1",
        1.0,
        least=0.0,
        most=8.0,
        whole=True,
    ),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Velocity after the push, impulse, greatest force, and the way made meanwhile: Newton's second law, integrated."""
    m, v0, force, dt, pulse = (one(settings, name) for name in ("m", "v0", "F", "dt", "pulse"))
    # The mean of sin^p over half a turn is Gamma((p + 1)/2) / (sqrt(pi) Gamma(p/2 + 1)).
    peak = force * math.sqrt(math.pi) * math.gamma(0.5 * pulse + 1.0) / math.gamma(0.5 * (pulse + 1.0))

    def push(part: float) -> float:
        return peak * math.sin(math.pi * part) ** pulse

    impulse, error_estimate, first = integral(push, 0.0, 1.0, tolerance) if force else (0.0, 0.0, 0)
    arm, error_of_arm, second = (
        integral(lambda part: push(part) * (1.0 - part), 0.0, 1.0, tolerance) if force else (0.0, 0.0, 0)
    )
    observed: dict[str, Observed] = {
        "velocities": (v0 + impulse * dt / m,),
        "impulse": impulse * dt,
        "peak_force": peak,
        "way": v0 * dt + arm * dt * dt / m,
    }
    errors = {
        "velocities": error_estimate,
        "impulse": error_estimate,
        "peak_force": ROUNDING,
        "way": error_of_arm,
    }
    why = "one body, a force given in time: the velocity is an integral over the force"
    return Run(observed, errors, "quadrature", why, first + second, "released")


SCENE = SceneDefinition("a body pushed for a short time by a force of given mean", SETTINGS, play)
