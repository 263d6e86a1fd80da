"""Second ways for collisions: springs in steps, a chain link by link, a rocket puff by puff."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import collide
from corollary.scenes.definition import Settings, numbers, row
from corollary.scenes.forces.contact import Contact
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import ROUNDING, STEPS, Model, Observed, Run, by_relative_errors

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
    for left in range(count, 0, -1):
        before, after = m1 + puff * left, m1 + puff * (left - 1)
        least, most = least + v_rel * puff / before, most + v_rel * puff / after
    middle, size = 0.5 * (least + most), max(abs(most), abs(least), v_rel)
    error = 0.5 * (most - least) / size + 1e-16 * count
    return second_run({"velocities": (middle,)}, error, ONE_BY_ONE, "conservation", {"velocities": size})


def wall(settings: Settings, tolerance: float) -> Run:
    m, v0, theta, dt = numbers(settings, "m", "v0", "theta", "dt")
    along, into = v0 * math.cos(theta), v0 * math.sin(theta)
    line = RowOfBodies((math.inf, m), (0.0, -into), (0.0,), (Contact(m * (math.pi / dt) ** 2, 1.0),))
    found = collide(line, tolerance, in_steps=True)
    change = m * (found.result.velocities[1] + into)
    observed: dict[str, Observed] = {
        "velocities": (along, found.result.velocities[1]),
        "momentum_change": (0.0, change),
        "impulse": (0.0, -change),
        "mean_force": (0.0, change / found.result.duration),
        "duration": found.result.duration,
    }
    return second_run(observed, max(found.errors.values()), found.why, found.model)


def cradle(settings: Settings, tolerance: float) -> Run | None:
    """None for more than two balls that are no springs: they are followed in steps in any case."""
    from corollary.scenes.library.cradle import balls_of  # here, since a scene is loaded when it is asked for

    k, q, v0 = numbers(settings, "k", "q", "v0")
    masses, coming = balls_of(settings)
    count = len(masses)
    if count > 2 and q > 1.0:
        return None
    gaps = row(settings, "gaps", count - 1, "gaps")
    if count == 2:  # however far apart, the collision is the same
        gaps = (0.0,)
    velocities = (v0,) * coming + (0.0,) * (count - coming)
    line = RowOfBodies(masses, velocities, gaps, (Contact(k, q),) * (count - 1))
    found = collide(line, tolerance, in_steps=True)
    result = found.result
    values: dict[str, Observed] = {
        "velocities": result.velocities,
        "duration": result.duration,
        "largest_overlap": max(result.overlaps),
        "peak_force": max(result.forces),
    }
    return found.observed(values, {"velocities": v0})


def two_blocks(settings: Settings, tolerance: float) -> Run:
    ma, mb, va, vb, r, k = numbers(settings, "mA", "mB", "vA", "vB", "r", "k")
    log = -math.log(r) if r else math.inf
    share = log / math.hypot(math.pi, log) if r else 1.0 + 1e-9
    eta = 2.0 * share * math.sqrt(k * ma / (ma + mb) * mb)
    found = collide(
        RowOfBodies((ma, mb), (va, vb), (0.0,), (Contact(k, 1.0, eta),)), tolerance, in_steps=True
    )
    a, b = found.result.velocities
    values: dict[str, Observed] = {"velocities": (a, b), "impulse": mb * (b - vb)}
    fastest = max(map(abs, (va, vb, a, b)))
    # Rounding alone moves bodies that never meet.
    errors = dict.fromkeys(values, found.errors.get("velocities", ROUNDING))
    return found.observed(values, {"velocities": fastest, "impulse": mb * fastest}, errors)
