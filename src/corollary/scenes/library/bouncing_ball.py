"""A ball dropped on a floor that gives back a share r of its speed, bounce after bounce (section 12.5, Fig. 12.11)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.run import Observed, Run

SETTINGS = (
    Setting("h0", "drop height", "m", 2.0, above=0.0),
    Setting("r", "coefficient of restitution", "1", 0.8, least=0.0, most=1.0),
    Setting("n", "number of bounces", "1", 3.0, least=1.0, most=1000.0, whole=True),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Heights after each bounce, the speed after the last, and the time until then: free fall and a hard floor in turn.

    A ball with r < 1 bounces infinitely often in the time sqrt(2 h0/g) (1 + r)/(1 - r), `rests_after`.
    """
    h0, r, g = (one(settings, name) for name in ("h0", "r", "g"))
    speed = math.sqrt(2.0 * g * h0)
    time = speed / g
    heights: list[float] = []
    for bounce in range(round(one(settings, "n"))):
        time += 2.0 * speed / g if bounce else 0.0
        speed *= r
        heights.append(speed * speed / (2.0 * g))
    observed: dict[str, Observed] = {
        "heights": tuple(heights),
        "rebound_speed": speed,
        "duration": time,
        "rests_after": math.sqrt(2.0 * h0 / g) * (1.0 + r) / (1.0 - r) if r < 1.0 else math.inf,
    }
    why = "free fall from bounce to bounce is known exactly"
    errors = dict.fromkeys(observed, ROUNDING * len(heights))
    return Run(observed, errors, "piecewise exact", why, 0, "sticks" if r == 0.0 else "released")


SCENE = SceneDefinition("a ball bounces on a floor with a coefficient of restitution", SETTINGS, play)
