"""A rocket that throws its fuel out in N equal puffs: momentum at every puff, and a bracket about the steady burn (12.7)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.run import BadSetting, Observed, Run

SETTINGS = (
    Setting("m0", "mass at the start", "kg", 1000.0, above=0.0),
    Setting("m1", "mass at the end", "kg", 400.0, above=0.0),
    Setting("v_rel", "speed of the exhaust relative to the rocket", "m/s", 2500.0, above=0.0),
    Setting("N", "number of puffs", "1", 1000.0, least=1.0, most=1e6, whole=True),
    Setting("v0", "velocity at the start", "m/s", 0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """`velocities` is the final velocity, between the two of `bracket`.

    A puff that leaves with v_rel relative to the rocket after it gives dm v_rel / (mass before), relative to the rocket before it
    dm v_rel / (mass after). A steady burn lies between the two; their mean is off by a share of 1/N^2 only.
    """
    m0, m1, v_rel, v0 = (one(settings, name) for name in ("m0", "m1", "v_rel", "v0"))
    count = round(one(settings, "N"))
    if m1 > m0:
        raise BadSetting(f"rocket: m1 = {m1:g} kg is more than m0 = {m0:g} kg; a rocket gets lighter.")
    puff = (m0 - m1) / count
    masses = [m0 - puff * i for i in range(count)] + [m1]
    least = v0 + v_rel * math.fsum(puff / before for before in masses[:-1])
    most = v0 + v_rel * math.fsum(puff / after for after in masses[1:])
    observed: dict[str, Observed] = {"velocities": (0.5 * (least + most),), "bracket": (least, most)}
    errors = {"velocities": max(0.5 * (most - least) / v_rel, 2e-15), "bracket": 2e-15 * math.sqrt(count)}
    why = "momentum at every puff; exhaust measured before and after it brackets the steady burn"
    return Run(observed, errors, "conservation", why, count, "escaped")


SCENE = SceneDefinition("a rocket that throws out its fuel in N puffs", SETTINGS, play)
