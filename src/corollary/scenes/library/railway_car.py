"""Sand falls into a railway car that is pulled at constant speed, shovel after shovel (example 12.7.1)."""

from __future__ import annotations

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.models.certain import Evaluated, by_formulas

SETTINGS = (
    Setting("v", "speed of the car", "m/s", 4.0),
    Setting("R", "sand per time", "kg/s", 50.0, least=0.0),
    Setting("ux", "horizontal velocity of the sand", "m/s", 0.0),
    Setting("t", "time", "s", 30.0, above=0.0),
    Setting("N", "number of shovels", "1", 1000.0, least=1.0, most=1e6, whole=True),
)


def _evaluated(v: Ball, rate: Ball, u: Ball, t: Ball, _: Ball) -> Evaluated:
    """Mean pull, impulse and work in the time t, and the energy lost as every shovel of sand is brought to the car's speed."""
    sand = rate * t
    values = {
        "mean_force": rate * (v - u),
        "impulse": sand * (v - u),
        "work": sand * (v - u) * v,
        "energy_lost": sand * (v - u) ** 2 / 2,
    }
    why = "every shovel is a perfectly inelastic collision with a car that is held at its speed"
    return Evaluated("sticks", values, "conservation", why)


SCENE = by_formulas("sand falls into a car that is pulled at constant speed", SETTINGS, _evaluated)
