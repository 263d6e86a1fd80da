"""A bullet gets stuck in a block, which then slides over a rough table until it stops (exercise 12.10)."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.models.flow import Mover, faded_time, stopping, under_dashpot
from corollary.scenes.run import Observed, Run

SETTINGS = (
    Setting("m", "mass of the bullet", "kg", 0.1, above=0.0),
    Setting("M", "mass of the block", "kg", 2.0, above=0.0),
    Setting("v", "velocity of the bullet", "m/s", 20.0, above=0.0),
    Setting("mu", "coefficient of kinetic friction", "1", 0.5, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("dt", "time the bullet takes to get stuck", "s", 1e-4, above=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """`distance` is how far the block slides on the rough region, `energy_change` that of the collision (J).

    The bullet is braked by a dashpot that leaves less than 1e-17 of its velocity relative to the block; only then does the
    rough region begin, as in the exercise.
    """
    m, block, v, mu, g, dt = (one(settings, name) for name in ("m", "M", "v", "mu", "g", "dt"))
    grip = faded_time(m, block, 1.0) / dt
    bullet, stuck = under_dashpot(Mover(0.0, v), Mover(0.0, 0.0), m, block, grip, dt)
    both = m + block
    stop, slid = stopping(Mover(0.0, stuck.v), both, mu * both * g)
    observed: dict[str, Observed] = {
        "velocities": (bullet.v, stuck.v),
        "energy_change": 0.5 * m * (bullet.v**2 - v**2) + 0.5 * block * stuck.v**2,
        "distance": stop.x,
        "duration": slid,
        "depth": bullet.x - stuck.x,
        "peak_force": grip * v,
    }
    errors = dict.fromkeys(observed, 2.0 * ROUNDING + 2.0 * abs(bullet.v - stuck.v) / stuck.v)
    why = "a dashpot, then constant friction: each moves the bodies in closed form"
    return Run(observed, errors, "piecewise exact", why, 0, "sticks")


SCENE = SceneDefinition("a bullet gets stuck in a block that slides to rest", SETTINGS, play)
