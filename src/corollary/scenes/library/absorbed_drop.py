"""A body takes up a small drop, perhaps while a force pushes it (section 12.7)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.models.flow import faded_time
from corollary.scenes.run import Observed, Run

SETTINGS = (
    Setting("m", "mass of the body", "kg", 2.0, above=0.0),
    Setting("dm", "mass of the drop", "kg", 0.4, above=0.0),
    Setting("v", "velocity of the body before", "m/s", 6.0),
    Setting("u", "velocity of the drop before", "m/s", -3.0),
    Setting("F", "force on the body from outside", "N", 0.0),
    Setting("t", "time for which they are watched, from the first touch on", "s", 1.0, above=0.0),
    Setting("dt", "time the drop takes to get caught", "s", 1e-9, above=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Velocities (body, drop) after the time t, the change of their total momentum, and the largest pull between them.

    The drop is dragged along by a dashpot. The relative velocity w obeys w' = F/m - (grip/mu) w, so it fades to F mu/(m grip): the
    force goes on to act on the body alone, and the drop lags behind by that much. The centre of mass gains F t/(m + dm).
    """
    m, dm, v, u, force, t, dt = (one(settings, name) for name in ("m", "dm", "v", "u", "F", "t", "dt"))
    total = m + dm
    mu = m / total * dm
    grip = faded_time(m, dm, 1.0) / dt
    lag = force * mu / (m * grip)
    left = lag + (v - u - lag) * math.exp(-grip / mu * t)
    centre = m / total * v + dm / total * u + force / total * t
    body, drop = centre + dm / total * left, centre - m / total * left
    # The relative velocity only goes from the one to the other: the pull is largest at an end.
    pulls = grip * abs(v - u), grip * abs(left)
    observed: dict[str, Observed] = {
        "velocities": (body, drop),
        "momentum_change": m * (body - v) + dm * (drop - u),
        "peak_force": max(pulls),
    }
    fastest = max(abs(body), abs(drop), abs(v), abs(u)) or 1.0
    caught = 4.0 * ROUNDING + abs(left) / fastest
    # A difference of momenta: rounding counts in units of the impulse, or of the momenta where there is none.
    impulse = abs(force) * t
    rounding = 4.0 * ROUNDING * (total * fastest / impulse if impulse else 1.0)
    errors = {"velocities": caught, "momentum_change": rounding, "peak_force": 4.0 * ROUNDING}
    why = "a dashpot under a constant force moves both in closed form"
    return Run(observed, errors, "piecewise exact", why, 0, "sticks")


SCENE = SceneDefinition("a body takes up a small drop", SETTINGS, play)
