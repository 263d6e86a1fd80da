"""A ball reflected from a stiff smooth wall that it meets at an angle (exercise 12.7)."""

from __future__ import annotations

import math

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.models.certain import Evaluated, by_formulas

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


def _evaluated(m: Ball, v0: Ball, theta: Ball, dt: Ball) -> Evaluated:
    """Vectors are (along the wall, away from the wall). The wall has no friction and gives like a spring.

    A spring's contact lasts half its period whatever the speed, so k = m (pi/dt)^2, and its motion is half a swing.
    """
    along, into = v0 * theta.cos(), v0 * theta.sin()
    change = 2 * m * into
    values = {
        "velocities": (along, into),
        "momentum_change": (Ball(0), change),
        "impulse": (Ball(0), -change),
        "mean_force": (Ball(0), change / dt),
        "peak_force": m * into * Ball.pi() / dt,
        "largest_overlap": into * dt / Ball.pi(),
        "duration": dt,
        "energy_ratio": Ball(1),
    }
    why = "a smooth wall that gives like a spring: the motion into it is half a swing, known exactly"
    return Evaluated("released", values, "piecewise exact", why)


SCENE = by_formulas("a ball reflected from a stiff smooth wall at an angle", SETTINGS, _evaluated)
