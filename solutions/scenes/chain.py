"""A chain lifted from a heap at constant speed: each link is picked up in a perfectly inelastic collision (12.13)."""

from __future__ import annotations

import math

from second_way import ONE_BY_ONE, second_run

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.run import Run

SETTINGS = (
    Setting("N", "number of links", "1", 1000.0, least=1.0, most=1e6, whole=True),
    Setting("m", "mass of the chain", "kg", 2.0, above=0.0),
    Setting("L", "length of the chain", "m", 1.5, above=0.0),
    Setting("v0", "speed of lifting", "m/s", 2.0, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, least=0.0),
    Setting("y", "length lifted where the force is looked at", "m", 0.6, least=0.0, most_that="L"),
)


def _evaluated(_: Ball, m: Ball, length: Ball, v0: Ball, g: Ball, y: Ball) -> Evaluated:
    """Impulse and work of the hand until the last link hangs, energy lost, and the mean force while one link is lifted about y.

    Every link jerks the hand with (m/N) v0, as momentum demands; between jerks the hand carries what hangs. Link i leaves the
    heap when the length (i + 1/2) L/N is lifted, so that on the mean half of the chain hangs.
    """
    impulse = m * v0 + m * g * length / (2 * v0)
    # While one link is lifted about y there is one jerk, at j + 1/2; j links hang before it and one more after it: y/L N on the mean.
    values = {
        "impulse": impulse,
        "mean_force": m / length * v0 * v0 + m * g * y / length,
        "work": impulse * v0,
        "energy_lost": m * v0 * v0 / 2,
    }
    why = "links picked up one by one: momentum at every jerk, weight between; all sums are closed"
    return Evaluated("released", values, "piecewise exact", why)


def second_way(settings: Settings, tolerance: float) -> Run:
    m, length, v0, g, y, links = numbers(settings, "m", "L", "v0", "g", "y", "N")
    count = round(links)
    link, beat = m / count, length / count / v0
    impulse, lost, hanging = 0.0, 0.0, 0.0
    for _ in range(count):
        # Half a link's way with what hangs, the jerk of the next link, and the other half with one more.
        impulse += hanging * g * 0.5 * beat + link * v0 + (hanging + link) * g * 0.5 * beat
        # The hand's work in the jerk, less what the link has of it.
        lost += link * v0 * v0 - 0.5 * link * v0 * v0
        hanging += link
    # While one link is lifted about y there is one jerk, at j + 1/2; j links hang before it and one more after it.
    lifted = y / length * count
    j = math.floor(lifted)
    mean_force = link * v0 / beat + link * g * (j * (j + 1 - lifted) + (j + 1) * (lifted - j))
    return second_run(
        {"impulse": impulse, "work": impulse * v0, "energy_lost": lost, "mean_force": mean_force},
        1e-13 * math.sqrt(count),
        ONE_BY_ONE,
        "conservation",
    )


SCENE = by_formulas(
    "a chain lifted from a heap at constant speed", SETTINGS, _evaluated, second_way=second_way
)
