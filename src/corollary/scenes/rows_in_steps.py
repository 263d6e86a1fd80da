"""Collisions on a line found a second way: every contact followed in steps, springs too, whatever else could be done."""

from __future__ import annotations

import math

from corollary.scenes.collision import ROUNDING, collide
from corollary.scenes.collisions_in_turn import second_run
from corollary.scenes.definition import Settings, numbers, row
from corollary.scenes.forces.contact import Contact
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import Observed, Run, by_relative_errors


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
    result, errors = found.result, found.errors
    observed: dict[str, Observed] = {
        "velocities": result.velocities,
        "duration": result.duration,
        "largest_overlap": max(result.overlaps),
        "peak_force": max(result.forces),
    }
    seen = {"largest_overlap": "overlaps", "peak_force": "forces"}
    relative = {name: errors[seen.get(name, name)] for name in observed}
    scales, outcome = {"velocities": v0}, result.outcome
    return by_relative_errors(
        observed, relative, found.model, found.why, found.spent, outcome, scales, found.warnings
    )


def two_blocks(settings: Settings, tolerance: float) -> Run:
    ma, mb, va, vb, r, k = numbers(settings, "mA", "mB", "vA", "vB", "r", "k")
    log = -math.log(r) if r else math.inf
    share = log / math.hypot(math.pi, log) if r else 1.0 + 1e-9
    eta = 2.0 * share * math.sqrt(k * ma / (ma + mb) * mb)
    found = collide(
        RowOfBodies((ma, mb), (va, vb), (0.0,), (Contact(k, 1.0, eta),)), tolerance, in_steps=True
    )
    a, b = found.result.velocities
    observed: dict[str, Observed] = {"velocities": (a, b), "impulse": mb * (b - vb)}
    fastest = max(map(abs, (va, vb, a, b)))
    scales = {"velocities": fastest, "impulse": mb * fastest}
    # Rounding alone moves bodies that never meet.
    errors = dict.fromkeys(observed, found.errors.get("velocities", ROUNDING))
    return by_relative_errors(
        observed, errors, found.model, found.why, found.spent, found.result.outcome, scales, found.warnings
    )
