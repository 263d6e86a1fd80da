"""Two ions repel each other with C/r^2 and turn round, head-on or not (section 12.6, test your understanding)."""

from __future__ import annotations

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting
from corollary.scenes.models.certain import Evaluated, by_formulas

SETTINGS = (
    Setting("C", "force constant", "N m^2", 0.0012, above=0.0),
    Setting("mA", "mass of A", "kg", 0.1, above=0.0),
    Setting("mB", "mass of B", "kg", 0.15, above=0.0),
    Setting("v", "relative speed of approach at the distance r0", "m/s", 1.0, above=0.0),
    Setting("r0", "distance at the start", "m", 0.08, above=0.0),
    Setting("s", "impact parameter", "m", 0.0, least=0.0, below_that="r0"),
)


def _evaluated(strength: Ball, ma: Ball, mb: Ball, v: Ball, r0: Ball, s: Ball) -> Evaluated:
    """The closest distance, the largest force, and the relative speed far away, from energy and angular momentum.

    mu v^2/2 + C/r0 = mu (s v)^2/(2 r^2) + C/r at the closest point, a quadratic in 1/r.
    """
    mass = 1 / (1 / ma + 1 / mb)
    energy, spin = mass * v * v / 2 + strength / r0, mass * (s * v) ** 2 / 2
    nearest = (strength + (strength**2 + 4 * spin * energy).sqrt()) / (2 * energy)
    values = {
        "turning_points": (nearest,),
        "peak_force": strength / nearest**2,
        "far_speed": (2 * energy / mass).sqrt(),
        "escapes": Ball(1),
    }
    why = "energy and angular momentum of the pair: the closest distance is the root of a quadratic"
    return Evaluated("escaped", values, "conservation", why)


SCENE = by_formulas("two ions repel each other and turn round", SETTINGS, _evaluated)
