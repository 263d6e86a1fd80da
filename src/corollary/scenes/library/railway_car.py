"""Sand falls into a railway car that is pulled at constant speed, shovel after shovel (example 12.7.1)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.run import Observed, Run

SETTINGS = (
    Setting("v", "speed of the car", "m/s", 4.0),
    Setting("R", "sand per time", "kg/s", 50.0, least=0.0),
    Setting("ux", "horizontal velocity of the sand", "m/s", 0.0),
    Setting("t", "time", "s", 30.0, above=0.0),
    Setting("N", "number of shovels", "1", 1000.0, least=1.0, most=1e6, whole=True),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Mean pull, impulse and work in the time t, and the energy lost as every shovel of sand is brought to the car's speed."""
    v, rate, u, t = (one(settings, name) for name in ("v", "R", "ux", "t"))
    count = round(one(settings, "N"))
    shovel = rate * t / count
    impulse = math.fsum(shovel * (v - u) for _ in range(count))
    gained = math.fsum(0.5 * shovel * (v * v - u * u) for _ in range(count))
    observed: dict[str, Observed] = {
        "mean_force": impulse / t,
        "impulse": impulse,
        "work": impulse * v,
        "energy_lost": impulse * v - gained,
    }
    why = "every shovel is a perfectly inelastic collision with a car that is held at its speed"
    return Run(
        observed, dict.fromkeys(observed, ROUNDING * math.sqrt(count)), "conservation", why, count, "sticks"
    )


SCENE = SceneDefinition("sand falls into a car that is pulled at constant speed", SETTINGS, play)
