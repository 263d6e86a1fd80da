"""A chain lifted from a heap at constant speed: each link is picked up in a perfectly inelastic collision (12.13)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.run import BadSetting, Observed, Run

SETTINGS = (
    Setting("N", "number of links", "1", 1000.0, least=1.0, most=1e6, whole=True),
    Setting("m", "mass of the chain", "kg", 2.0, above=0.0),
    Setting("L", "length of the chain", "m", 1.5, above=0.0),
    Setting("v0", "speed of lifting", "m/s", 2.0, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, least=0.0),
    Setting("y", "length lifted where the force is looked at", "m", 0.6, least=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Impulse and work of the hand until the last link hangs, energy lost, and the mean force while one link is lifted about y.

    Every link jerks the hand with (m/N) v0, as momentum demands; between jerks the hand carries what hangs. Link i leaves the
    heap when the length (i + 1/2) L/N is lifted.
    """
    m, length, v0, g, y = (one(settings, name) for name in ("m", "L", "v0", "g", "y"))
    count = round(one(settings, "N"))
    if y > length:
        raise BadSetting(f"chain: y = {y:g} m is more than the chain is long ({length:g} m).")
    link, beat = m / count, length / count / v0
    jerks: list[float] = []
    carried: list[float] = []
    lost: list[float] = []
    hanging = 0.0
    for _ in range(count):
        carried.append(hanging * g * 0.5 * beat)
        jerks.append(link * v0)
        lost.append(0.5 * link * v0 * v0)
        hanging += link
        carried.append(hanging * g * 0.5 * beat)
    impulse = math.fsum(jerks) + math.fsum(carried)
    # While one link is lifted about y there is one jerk, at j + 1/2; j links hang before it and one more after it.
    lifted = y / length * count
    j = math.floor(lifted)
    mean_force = link * v0 / beat + link * g * (j * (j + 1 - lifted) + (j + 1) * (lifted - j))
    observed: dict[str, Observed] = {
        "impulse": impulse,
        "mean_force": mean_force,
        "work": impulse * v0,
        "energy_lost": math.fsum(lost),
    }
    errors = dict.fromkeys(observed, ROUNDING * math.sqrt(count))
    why = "links picked up one by one: momentum at every jerk, weight between; all sums are closed"
    return Run(observed, errors, "piecewise exact", why, count, "released")


SCENE = SceneDefinition("a chain lifted from a heap at constant speed", SETTINGS, play)
