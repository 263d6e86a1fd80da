"""A chain lifted link by link, a rocket's puffs one after another; and how what is found a second way is handed back."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.definition import Settings, numbers
from corollary.scenes.run import STEPS, Model, Observed, Run, by_relative_errors

ONE_BY_ONE = "momentum at every collision, one after the other"


def second_run(
    observed: Mapping[str, Observed],
    error: float,
    why: str = STEPS,
    model: Model = "integration",
    scales: Mapping[str, float] | None = None,
) -> Run:
    """A run whose values have one relative error, of their size or of `scales` (SI) where these are larger."""
    return by_relative_errors(observed, dict.fromkeys(observed, error), model, why, 0, "released", scales)


def chain(settings: Settings, tolerance: float) -> Run:
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


def rocket(settings: Settings, tolerance: float) -> Run:
    m0, m1, v_rel, v0, puffs = numbers(settings, "m0", "m1", "v_rel", "v0", "N")
    count = round(puffs)
    puff, least, most = (m0 - m1) / count, v0, v0
    for i in range(count):
        before = m0 - puff * i
        least, most = least + v_rel * puff / before, most + v_rel * puff / (before - puff)
    middle = 0.5 * (least + most)
    return second_run(
        {"velocities": (middle,)}, 0.5 * (most - least) / abs(middle), ONE_BY_ONE, "conservation"
    )
