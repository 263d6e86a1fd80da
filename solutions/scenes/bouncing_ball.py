"""A ball dropped on a floor that gives back a share r of its speed, bounce after bounce (section 12.5, Fig. 12.11)."""

from __future__ import annotations

import math

from falls_and_swings import EXACT, flight, free_fall, until

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers, one
from corollary.scenes.film import Film, film
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.models.certain import Balls, Evaluated, by_formulas
from corollary.scenes.run import STEPS, Observed, Outcome, Run, by_relative_errors
from corollary.scenes.scene import Body

MOST_FLIGHTS = 300  # as many are followed to know when a ball rests

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


def second_way(settings: Settings, tolerance: float) -> Run:
    """Flight after flight; when it rests is known where the flights that still count are few enough."""
    h0, r, n, g = numbers(settings, "h0", "r", "n", "g")
    count = round(n)
    # In units of the height and of the weight.
    down, (_, arrives) = until(free_fall, (1.0, 0.0), lambda y: y[0], 1e-13)
    tops, lasts = list[float](), list[float]()
    velocity, rebound = -arrives, 0.0
    # So many bounces until nothing is left that counts.
    all_of_them = math.log(EXACT * (1.0 - r)) / math.log(r) if 0.0 < r < 1.0 else 0.0
    few = r < 1.0 and all_of_them <= max(count, MOST_FLIGHTS)
    for _ in range(max(count, math.ceil(all_of_them) if few else 0)):
        velocity *= r
        top, flown, back = flight(velocity) if velocity > 0.0 else (0.0, 0.0, 0.0)
        rebound = velocity if len(tops) < count else rebound
        tops.append(top)
        lasts.append(flown)
        velocity = back
    time = math.sqrt(h0 / g)
    observed: dict[str, Observed] = {
        "heights": tuple(h0 * top for top in tops[:count]),
        "rebound_speed": g * time * rebound,
        "duration": time * (down + math.fsum(lasts[: count - 1])),
    }
    if few:
        observed["rests_after"] = time * (down + math.fsum(lasts))
    error = EXACT * (len(lasts) + 1.0)
    outcome: Outcome = "sticks" if r == 0.0 else "released"
    scales = {"heights": h0, "rebound_speed": g * time}
    return by_relative_errors(
        observed, dict.fromkeys(observed, error), "integration", STEPS, 0, outcome, scales
    )


def filmed(settings: Settings) -> Film:
    h0, r, g = numbers(settings, "h0", "r", "g")
    fall = math.sqrt(2.0 * h0 / g)
    until = fall * (1.0 + 2.0 * math.fsum(r**i for i in range(1, round(one(settings, "n")) + 1)))
    forces = Weight(g), HardWall((1.0,), restitution=r)
    ball, radius = Body(1.0, (h0,), (0.0,), name="A"), 0.04 * h0
    ground = ((-h0, -radius), (h0, -radius))
    return film((ball,), [(forces, until)], radii=(radius,), upright=True, lines=(ground,))


SCENE = by_formulas(
    "a ball bounces on a floor with a coefficient of restitution",
    SETTINGS,
    _evaluated,
    second_way=second_way,
    film=filmed,
)
