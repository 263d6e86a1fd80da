"""Two ions repel each other with C/r^2 and turn round, head-on or not (section 12.6, test your understanding)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.run import BadSetting, Observed, Run

SETTINGS = (
    Setting("C", "force constant", "N m^2", 0.0012, above=0.0),
    Setting("mA", "mass of A", "kg", 0.1, above=0.0),
    Setting("mB", "mass of B", "kg", 0.15, above=0.0),
    Setting("v", "relative speed of approach at the distance r0", "m/s", 1.0, above=0.0),
    Setting("r0", "distance at the start", "m", 0.08, above=0.0),
    Setting("s", "impact parameter", "m", 0.0, least=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """The closest distance, the largest force, and the relative speed far away, from energy and angular momentum.

    mu v^2/2 + C/r0 = mu (s v)^2/(2 r^2) + C/r at the closest point, a quadratic in 1/r.
    """
    strength, ma, mb, v, r0, s = (one(settings, name) for name in ("C", "mA", "mB", "v", "r0", "s"))
    if s >= r0:
        raise BadSetting(f"ions: s = {s:g} m must be less than r0 = {r0:g} m, for the ions come nearer.")
    mu = ma / (ma + mb) * mb
    energy, spin = 0.5 * mu * v * v + strength / r0, 0.5 * mu * (s * v) ** 2
    nearest = (strength + math.sqrt(strength**2 + 4.0 * spin * energy)) / (2.0 * energy)
    observed: dict[str, Observed] = {
        "turning_points": (nearest,),
        "peak_force": strength / nearest**2,
        "far_speed": math.sqrt(2.0 * energy / mu),
        "escapes": 1.0,
    }
    why = "energy and angular momentum of the pair: the closest distance is the root of a quadratic"
    return Run(observed, dict.fromkeys(observed, 4.0 * ROUNDING), "conservation", why, 0, "escaped")


SCENE = SceneDefinition("two ions repel each other and turn round", SETTINGS, play)
