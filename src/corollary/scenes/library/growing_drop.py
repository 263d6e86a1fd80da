"""A drop falls and takes up vapour on its way (section 12.7, test your understanding)."""

from __future__ import annotations

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.models.certain import Evaluated, by_formulas

SETTINGS = (
    Setting("m", "mass of the drop at the start", "kg", 2.0, above=0.0),
    Setting("v", "velocity of the drop at the start, downwards", "m/s", 6.0),
    Setting("R", "vapour taken up per time", "kg/s", 0.4, least=0.0),
    Setting("u", "velocity of the vapour, downwards", "m/s", 0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, least=0.0),
    Setting("t", "time of the fall", "s", 1.5, above=0.0),
)


def _evaluated(m: Ball, v: Ball, rate: Ball, u: Ball, g: Ball, t: Ball) -> Evaluated:
    """Velocity and way (both downwards) after the time t, and the mass then.

    Momentum is what the drop had, what the vapour brought, and the push of a growing weight; the way is the integral of
    v = u + g (m + R t)/(2 R) + c/(m + R t).
    """
    mass = m + rate * t
    velocity = (m * v + rate * t * u + g * t * (m + mass) / 2) / mass
    if rate.is_zero():
        way = v * t + g * t * t / 2
    else:
        c = m * (v - u) - g * m * m / (2 * rate)
        way = u * t + g * t * (m + mass) / (4 * rate) + c / rate * (rate * t / m).log1p()
    values = {"velocities": (velocity,), "way": way, "mass": mass}
    why = "momentum gives the velocity of a drop whose mass is known, and its integral is a logarithm"
    return Evaluated("bound", values, "piecewise exact", why)


SCENE = by_formulas("a drop takes up vapour as it falls", SETTINGS, _evaluated)
