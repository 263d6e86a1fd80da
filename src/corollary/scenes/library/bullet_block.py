"""A bullet gets stuck in a block, which then slides over a rough table until it stops (exercise 12.10)."""

from __future__ import annotations

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.forces.spring import FADING
from corollary.scenes.models.certain import Evaluated, by_formulas

SETTINGS = (
    Setting("m", "mass of the bullet", "kg", 0.1, above=0.0),
    Setting("M", "mass of the block", "kg", 2.0, above=0.0),
    Setting("v", "velocity of the bullet", "m/s", 20.0, above=0.0),
    Setting("mu", "coefficient of kinetic friction", "1", 0.5, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("dt", "time the bullet takes to get stuck", "s", 1e-4, above=0.0),
)


def _evaluated(m: Ball, block: Ball, v: Ball, mu: Ball, g: Ball, dt: Ball) -> Evaluated:
    """`distance` is how far the block slides on the rough region, `energy_change` that of the collision (J).

    The bullet is braked by a dashpot for the time dt, and then held fast; only then does the rough region begin, as in the exercise.
    """
    both = m + block
    common = m * v / both
    values = {
        "velocities": (common, common),
        "energy_change": -v * v * m * block / (2 * both),
        "distance": common * common / (2 * mu * g),
        "duration": common / (mu * g),
        "depth": v * (1 - Ball(-FADING).exp()) * dt / FADING,
        "peak_force": FADING * m * block / both * v / dt,
    }
    why = "a dashpot, then constant friction: each moves the bodies in closed form"
    return Evaluated("sticks", values, "piecewise exact", why)


SCENE = by_formulas("a bullet gets stuck in a block that slides to rest", SETTINGS, _evaluated)
