"""A body takes up a small drop, perhaps while a force pushes it (section 12.7)."""

from __future__ import annotations

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.forces.spring import FADING
from corollary.scenes.models.certain import Evaluated, by_formulas

SETTINGS = (
    Setting("m", "mass of the body", "kg", 2.0, above=0.0),
    Setting("dm", "mass of the drop", "kg", 0.4, above=0.0),
    Setting("v", "velocity of the body before", "m/s", 6.0),
    Setting("u", "velocity of the drop before", "m/s", -3.0),
    Setting("F", "force on the body from outside", "N", 0.0),
    Setting("t", "time for which they are watched, from the first touch on", "s", 1.0, above=0.0),
    Setting("dt", "time the drop takes to get caught", "s", 1e-9, above=0.0),
)


def _evaluated(m: Ball, dm: Ball, v: Ball, u: Ball, force: Ball, t: Ball, dt: Ball) -> Evaluated:
    """Velocities (body, drop) after the time t, the change of their total momentum, and the largest pull between them.

    The drop is dragged along by a dashpot. The relative velocity w obeys w' = F/m - (grip/mu) w, so it fades to F mu/(m grip): the
    force goes on to act on the body alone, and the drop lags behind by that much. The centre of mass gains F t/(m + dm).
    """
    total, rate = m + dm, FADING / dt
    lag = force / (m * rate)
    left = lag + (v - u - lag) * (-rate * t).exp()
    centre = (m * v + dm * u + force * t) / total
    grip = rate * m * dm / total
    values = {
        "velocities": (centre + dm / total * left, centre - m / total * left),
        "momentum_change": force * t,
        # The relative velocity only goes from the one to the other: the pull is largest at an end.
        "peak_force": grip * abs(v - u).max(abs(left)),
    }
    why = "a dashpot under a constant force moves both in closed form"
    return Evaluated("sticks", values, "piecewise exact", why)


SCENE = by_formulas("a body takes up a small drop", SETTINGS, _evaluated)
