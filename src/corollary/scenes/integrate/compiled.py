"""The regularised collision of a row as one compiled loop: the same steps as `regularised`, for rows without damping and weight.

It needs numba, and ten seconds or twenty the first time it runs on a machine; it is never imported unless it is asked for.
"""

from __future__ import annotations

import math

import numpy as np

from corollary.scenes.integrate import compiled_loop
from corollary.scenes.integrate.compiled_loop import MOST_STEPS, NO_STEP, RELEASED, TOO_LONG
from corollary.scenes.integrate.time_variable import smoothing_powers
from corollary.scenes.row import Row, RowResult
from corollary.scenes.run import GuardFailed


def collide(line: Row, tolerance: float = 1e-13) -> RowResult:
    """The same as `regularised.collide`, for a line without damping and weight.

    Raises GuardFailed as it does, OverflowError when a number leaves the range of a computer.
    """
    masses, velocities, gaps = np.array(line.masses), np.array(line.velocities), np.array(line.gaps)
    terms = np.array(
        [(c.k, c.q, power) for c, power in zip(line.contacts, smoothing_powers(line), strict=True)]
    )
    end, duration, openings, evaluations, gained, shift = compiled_loop.collide(
        masses, velocities, gaps, terms, tolerance
    )
    if not math.isfinite(gained):
        raise OverflowError("a number of the collision is too large or too small")
    if end == TOO_LONG:
        raise GuardFailed(
            f"The collision did not end within {MOST_STEPS} steps. Make the masses less unequal or the balls fewer."
        )
    if end == NO_STEP:
        raise GuardFailed("No step is small enough to follow the collision. Make the settings less extreme.")
    allowed = 1e3 * tolerance + 1e-15 * evaluations
    if abs(gained) > allowed or abs(shift) > 1e-12:
        raise GuardFailed(
            f"The run changed the energy by {gained:.1e} and the momentum by {shift:.1e} of itself; {allowed:.1e} and 1e-12 are "
            "allowed. Ask for less."
        )
    overlaps, met = tuple(gaps.tolist()), end == RELEASED
    return RowResult(
        velocities=tuple(velocities.tolist()),
        duration=duration if met else 0.0,
        overlaps=overlaps,
        forces=tuple(c.k * d**c.q for c, d in zip(line.contacts, overlaps, strict=True)),
        outcome="released" if met else "missed",
        evaluations=evaluations,
        openings=openings,
    )
