"""Throwing and catching a snowball while standing on ice: short forces between the two, nothing from outside along the ice."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.models.flow import Mover, faded_time, under_dashpot, under_force
from corollary.scenes.run import Observed, Run

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


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Velocities along the ice, toward the son. `velocities_after_throw` and `velocities` are (yours, your son's).

    Thrown by a constant force between hand and ball (each feels it, oppositely); caught by a dashpot between ball and son that
    leaves less than 1e-17 of the relative velocity. The ice carries what the throw does vertically.
    """
    you, son, ball, v, theta, dt = (one(settings, name) for name in ("M", "Ms", "m", "v", "theta", "dt"))
    level, up = v * math.cos(theta), v * math.sin(theta)
    force = ball * level / dt
    thrown, yours = (
        under_force(Mover(0.0, 0.0), ball, force, dt),
        under_force(Mover(0.0, 0.0), you, -force, dt),
    )
    grip = faded_time(ball, son, 1.0) / dt
    caught, sons = under_dashpot(Mover(0.0, thrown.v), Mover(0.0, 0.0), ball, son, grip, dt)
    observed: dict[str, Observed] = {
        "momentum": (ball * thrown.v, ball * up),
        "velocities_after_throw": (yours.v, 0.0),
        "velocities": (yours.v, sons.v),
        "peak_force": max(force, grip * thrown.v),
    }
    errors = dict.fromkeys(observed, ROUNDING) | {"velocities": ROUNDING + abs(caught.v - sons.v) / level}
    why = "a constant force and a dashpot, one after the other: each moves the bodies in closed form"
    return Run(observed, errors, "piecewise exact", why, 0, "sticks")


SCENE = SceneDefinition("a snowball thrown and caught on ice", SETTINGS, play)
