"""A ball dropped on a floor that gives back a share r of its speed, bounce after bounce (section 12.5, Fig. 12.11)."""

from __future__ import annotations

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.models.certain import Balls, Evaluated, by_formulas

SETTINGS = (
    Setting("h0", "drop height", "m", 2.0, above=0.0),
    Setting("r", "coefficient of restitution", "1", 0.8, least=0.0, most=1.0),
    Setting("n", "number of bounces", "1", 3.0, least=1.0, most=1000.0, whole=True),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
)


def _evaluated(h0: Ball, r: Ball, n: Ball, g: Ball) -> Evaluated:
    """Heights after each bounce, the speed after the last, and the time until then: free fall and a hard floor in turn.

    A ball with r < 1 bounces infinitely often in the time sqrt(2 h0/g) (1 + r)/(1 - r), `rests_after`.
    """
    fall, rebound, up = (2 * h0 / g).sqrt(), Ball(1), Ball(0)
    heights: list[Ball] = []
    for bounce in range(round(float(n))):
        up += 2 * rebound if bounce else 0
        rebound *= r
        heights.append(h0 * rebound * rebound)
    values: dict[str, Balls] = {
        "heights": tuple(heights),
        "rebound_speed": (2 * g * h0).sqrt() * rebound,
        "duration": fall * (1 + up),
    }
    if r < 1:
        values["rests_after"] = fall * (1 + r) / (1 - r)
    warnings = () if r < 1 else ("A ball that gives back all of its speed never comes to rest.",)
    why = "free fall from bounce to bounce is known exactly"
    return Evaluated(
        "sticks" if r.is_zero() else "released", values, "piecewise exact", why, warnings=warnings
    )


SCENE = by_formulas("a ball bounces on a floor with a coefficient of restitution", SETTINGS, _evaluated)
