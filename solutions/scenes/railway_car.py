"""Sand falls into a railway car that is pulled at constant speed, shovel after shovel (example 12.7.1)."""

from __future__ import annotations

import math

from second_way import second_run, state_after

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.forces.bonds import FADING, Spring
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.run import (
    Observed,
    Run,
)
from corollary.scenes.scene import Body

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


def second_way(settings: Settings, tolerance: float) -> Run:
    v, rate, u, t = numbers(settings, "v", "R", "ux", "t")
    count = 1000
    shovel, dt = rate * t / count, t / count
    if shovel == 0.0:
        return second_run(dict.fromkeys(("mean_force", "impulse", "work", "energy_lost"), 0.0), 0.0)
    # One shovel that a dashpot brings to the speed of a car that nothing slows down.
    sand, car = Body(shovel, (0.0,), (u,)), Body(math.inf, (10.0 * (abs(u) + abs(v)) * dt + 1.0,), (v,))
    dashpot = Spring((0, 1), 0.0, damping=FADING * shovel / dt)
    (after, _), _, error = state_after((sand, car), (dashpot,), dt, tolerance)
    impulse = count * shovel * (after - u)
    lost = impulse * v - count * 0.5 * shovel * (after - u) * (after + u)
    observed: dict[str, Observed] = {
        "mean_force": impulse / t,
        "impulse": impulse,
        "work": impulse * v,
        "energy_lost": lost,
    }
    fast, mass = max(abs(u), abs(v)), count * shovel
    thrown, hot = mass * fast, mass * fast**2
    scales = {"impulse": thrown, "mean_force": mass * fast / t, "work": hot, "energy_lost": hot}
    return second_run(observed, 4.0 * error, scales=scales)


SCENE = by_formulas(
    "sand falls into a car that is pulled at constant speed", SETTINGS, _evaluated, second_way=second_way
)
