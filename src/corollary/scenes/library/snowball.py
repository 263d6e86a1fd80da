"""Throwing and catching a snowball while standing on ice: short forces between the two, nothing from outside along the ice."""

from __future__ import annotations

import math

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.forces.spring import FADING
from corollary.scenes.models.certain import Evaluated, by_formulas

SETTINGS = (
    Setting("M", "your mass", "kg", 80.0, above=0.0),
    Setting("Ms", "your son's mass", "kg", 20.0, above=0.0),
    Setting("m", "mass of the snowball", "kg", 2.0, above=0.0),
    Setting("v", "speed of the snowball over the ice", "m/s", 20.0, above=0.0),
    Setting(
        "theta",
        "angle of the throw above the horizontal",
        "rad",
        math.pi / 6.0,
        least=0.0,
        below=0.5 * math.pi,
    ),
    Setting("dt", "time the throw takes, and the catch at most", "s", 0.1, above=0.0),
)


def _evaluated(you: Ball, son: Ball, ball: Ball, v: Ball, theta: Ball, dt: Ball) -> Evaluated:
    """Velocities along the ice, toward the son. `velocities_after_throw` and `velocities` are (yours, your son's).

    Thrown by a constant force between hand and ball (each feels it, oppositely), of size m v/dt: nothing weighs. Caught by a dashpot
    along the ice between ball and son, and then held fast. The ice carries what either does vertically.
    """
    level, up = v * theta.cos(), v * theta.sin()
    yours, both = -ball * level / you, ball + son
    values = {
        "momentum": (ball * level, ball * up),
        "velocities_after_throw": (yours, Ball(0)),
        "velocities": (yours, ball * level / both),
        "peak_force": (ball * v / dt).max(FADING * ball * son / both * level / dt),
    }
    why = "a constant force and a dashpot, one after the other: each moves the bodies in closed form"
    return Evaluated("sticks", values, "piecewise exact", why)


SCENE = by_formulas("a snowball thrown and caught on ice", SETTINGS, _evaluated)
