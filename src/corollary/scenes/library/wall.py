"""A ball reflected from a stiff smooth wall that it meets at an angle (exercise 12.7)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.models.flow import Mover, under_spring
from corollary.scenes.run import Observed, Run

SETTINGS = (
    Setting("m", "mass of the ball", "kg", 0.2, above=0.0),
    Setting("v0", "speed of the ball", "m/s", 8.0, above=0.0),
    Setting(
        "theta",
        "angle between the velocity and the wall's surface",
        "rad",
        math.pi / 6.0,
        above=0.0,
        most=0.5 * math.pi,
    ),
    Setting("dt", "time of contact", "s", 0.01, above=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Vectors are (along the wall, away from the wall). The wall has no friction and gives like a spring.

    A spring's contact lasts half its period whatever the speed, so k = m (pi/dt)^2, and its motion is known exactly.
    """
    m, v0, theta, dt = (one(settings, name) for name in ("m", "v0", "theta", "dt"))
    along, into = v0 * math.cos(theta), v0 * math.sin(theta)
    k = m * (math.pi / dt) ** 2
    # Squeezed is negative: the ball comes with velocity -into and leaves when the spring is at rest length again.
    deepest = under_spring(Mover(0.0, -into), m, k, 0.5 * dt)
    after = under_spring(Mover(0.0, -into), m, k, dt)
    change = (0.0, m * (after.v + into))
    observed: dict[str, Observed] = {
        "velocities": (along, after.v),
        "momentum_change": change,
        "impulse": (0.0 - change[0], -change[1]),
        "mean_force": (change[0] / dt, change[1] / dt),
        "peak_force": -k * deepest.x,
        "largest_overlap": -deepest.x,
        "duration": dt,
        "energy_ratio": (along**2 + after.v**2) / v0**2,
    }
    why = "a smooth wall that gives like a spring: the motion into it is half a swing, known exactly"
    return Run(observed, dict.fromkeys(observed, ROUNDING), "piecewise exact", why, 0, "released")


SCENE = SceneDefinition("a ball reflected from a stiff smooth wall at an angle", SETTINGS, play)
