"""A rocket that throws its fuel out in N equal puffs: momentum at every puff, and a bracket about the steady burn (12.7)."""

from __future__ import annotations

from dataclasses import replace

from second_way import ONE_BY_ONE, second_run

from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers, one
from corollary.scenes.models.certain import Evaluated, balls, found
from corollary.scenes.run import Run, components

SETTINGS = (
    Setting("m0", "mass at the start", "kg", 1000.0, above=0.0),
    Setting("m1", "mass at the end", "kg", 400.0, above=0.0, most_that="m0"),
    Setting("v_rel", "speed of the exhaust relative to the rocket", "m/s", 2500.0, above=0.0),
    Setting("N", "number of puffs", "1", 1000.0, least=1.0, most=1e6, whole=True),
    Setting("v0", "velocity at the start", "m/s", 0.0),
)


def play(settings: Settings, tolerance: float) -> Run:
    """`velocities` is the final velocity of a steady burn, somewhere between the two of `bracket`, which are its proven bounds.

    A puff that leaves with v_rel relative to the rocket after it gives dm v_rel / (mass before), relative to the rocket before it
    dm v_rel / (mass after). A steady burn lies between the two; their mean is off by a share of 1/N^2 only.
    """
    run = found(lambda: _evaluated(settings))
    if "bracket" not in run.measured:
        return run
    bracket, middle = run.measured["bracket"], run.measured["velocities"]
    least, most = components(bracket.value)
    (value,) = components(middle.value)
    widest = max(most - value, value - least) + 2.0 * sum(components(bracket.error))
    size = max(middle.size, one(settings, "v_rel"))
    return replace(run, measured=run.measured | {"velocities": replace(middle, error=(widest,), size=size)})


def _evaluated(settings: Settings) -> Evaluated:
    m0, m1, v_rel, v0, count = balls(settings, "m0", "m1", "v_rel", "v0", "N")
    puff = (m0 - m1) / count
    if puff.is_zero():
        least = most = v0
    else:
        # The sums of 1/(a - i) over all puffs are differences of digamma functions.
        least = v0 + v_rel * ((m0 / puff + 1).digamma() - (m1 / puff + 1).digamma())
        most = v0 + v_rel * ((m0 / puff).digamma() - (m1 / puff).digamma())
    why = "momentum at every puff; exhaust measured before and after it brackets the steady burn"
    return Evaluated(
        "escaped", {"velocities": ((least + most) / 2,), "bracket": (least, most)}, "conservation", why
    )


def second_way(settings: Settings, tolerance: float) -> Run:
    m0, m1, v_rel, v0, puffs = numbers(settings, "m0", "m1", "v_rel", "v0", "N")
    count = round(puffs)
    puff, least, most = (m0 - m1) / count, v0, v0
    for left in range(count, 0, -1):
        before, after = m1 + puff * left, m1 + puff * (left - 1)
        least, most = least + v_rel * puff / before, most + v_rel * puff / after
    middle, size = 0.5 * (least + most), max(abs(most), abs(least), v_rel)
    error = 0.5 * (most - least) / size + 1e-16 * count
    return second_run({"velocities": (middle,)}, error, ONE_BY_ONE, "conservation", {"velocities": size})


SCENE = SceneDefinition("a rocket that throws out its fuel in N puffs", SETTINGS, play, second_way=second_way)
