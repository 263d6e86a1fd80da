"""Coefficient of restitution: a wall or a floor gives back the fraction r of the speed, and so r² of the energy."""

import math

from corollary.author import simulate


def scene(m, v0, r, h0, n, g, answer, neglected):
    """A floor with just as much damping as r asks for, met at v0 without weight, and at the speed of the fall without it and with it."""
    loss, touch = -math.log(r), 2e-4
    k = m * (math.pi**2 + loss**2) / touch**2
    damped = {"m": m, "k": k, "q": 1, "g": 0.0, "R": 0.02, "y0": 0.02, "eta": 2 * m * loss / touch}
    fall, rise = math.sqrt(2 * g * h0), math.sqrt(2 * g * answer["c"])
    return [
        simulate(
            "ball_on_floor",
            damped | {"v0": -v0},
            rebound_speed=-answer["a"],
            energy_ratio=1 + answer["b"] / (m * v0 * v0 / 2),
        ),
        simulate("ball_on_floor", damped | {"v0": -fall}, rebound_speed=rise),
        simulate(
            "ball_on_floor",
            damped | {"v0": -fall, "g": g},
            animated=True,
            rebound_speed=rise,
            neglected=neglected["c"] / answer["c"] / 2,
        ),
    ]
