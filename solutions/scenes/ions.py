"""Two ions repel each other with C/r^2 and turn round, head-on or not (section 12.6, test your understanding)."""

from __future__ import annotations

import math

from second_way import followed, second_run

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.film import Film, film
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.run import (
    GuardFailed,
    Observable,
    Run,
    components,
)
from corollary.scenes.scene import Body, Scene

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


def second_way(settings: Settings, tolerance: float) -> Run:
    strength, ma, mb, v, r0, s = numbers(settings, "C", "mA", "mB", "v", "r0", "s")
    # Seen from where both meet in the end if nothing acts: each turns there as the other does, at distances that add up.
    far, share, rest = math.sqrt((r0 - s) * (r0 + s)), mb / (ma + mb), ma / (ma + mb)
    a = Body(ma, (-share * far, -share * s), (share * v, 0.0))
    b = Body(mb, (rest * far, rest * s), (-rest * v, 0.0))
    runs = [
        followed(
            Scene(bodies, (InverseSquare((0, 1), -strength),), until=4.0 * r0 / v),
            {Observable.TURNING_POINTS},
            tolerance,
        )
        for bodies in ((a, b), (b, a))
    ]
    turned = [components(run.observed["turning_points"]) for run in runs]
    if not all(turned):
        raise GuardFailed(
            f"ions: whether they near each other before they part is not told from {r0:g} m; begin farther away."
        )
    nearest = math.fsum(distances[0] for distances in turned)
    error = max(run.relative_error("turning_points") for run in runs) * max(
        1.0, *(run.measured["turning_points"].size / nearest for run in runs)
    )
    return second_run({"turning_points": (nearest,), "peak_force": strength / nearest**2}, 2.0 * error)


def filmed(settings: Settings) -> Film:
    strength, ma, mb, v, r0, s = numbers(settings, "C", "mA", "mB", "v", "r0", "s")
    away, total = math.sqrt((r0 - s) * (r0 + s)), ma + mb
    a = Body(ma, (-mb / total * away, -mb / total * s), (mb / total * v, 0.0), name="A")
    b = Body(mb, (ma / total * away, ma / total * s), (-ma / total * v, 0.0), name="B")
    return film((a, b), [((InverseSquare((0, 1), -strength),), 2.4 * r0 / v)], radii=(0.05 * r0, 0.05 * r0))


SCENE = by_formulas(
    "two ions repel each other and turn round", SETTINGS, _evaluated, second_way=second_way, film=filmed
)
