"""A chain lifted from a heap at constant speed: each link is picked up in a perfectly inelastic collision (12.13)."""

from __future__ import annotations

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.models.certain import Evaluated, by_formulas

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


SCENE = by_formulas("a chain lifted from a heap at constant speed", SETTINGS, _evaluated)
