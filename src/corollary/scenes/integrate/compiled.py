"""The regularised collision of a row as one compiled loop: the same steps as `regularised`, for rows without damping and weight.

It needs numba, and ten seconds or twenty the first time it runs on a machine; it is never imported unless it is asked for.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit  # pyright: ignore[reportMissingImports]

from corollary.scenes.integrate.compiled_loop import MOST_STEPS, NO_STEP, RELEASED, STILL, TOO_LONG, follow
from corollary.scenes.integrate.time_variable import smoothing_powers
from corollary.scenes.row import RowOfBodies, RowResult
from corollary.scenes.run import GuardFailed


def collide(line: RowOfBodies, tolerance: float = 1e-13) -> RowResult:
    """The same as `regularised.collide`, for a line without damping and weight.

    Raises GuardFailed as it does, OverflowError when a number leaves the range of a computer.
    """
    masses, velocities, gaps = np.array(line.masses), np.array(line.velocities), np.array(line.gaps)
    terms = np.array(
        [(c.k, c.q, power) for c, power in zip(line.contacts, smoothing_powers(line), strict=True)]
    )
    end, duration, openings, evaluations, gained, shift = _collide(masses, velocities, gaps, terms, tolerance)
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


@njit(cache=True, error_model="numpy")
def _energy(state, inverse, terms):
    total, count = 0.0, len(terms)
    for i in range(count + 1):
        if inverse[i] > 0.0:
            total += 0.5 * state[count + 1 + i] ** 2 / inverse[i]
    for j in range(count):
        if state[1 + j] > 0.0:
            total += terms[j, 0] * state[1 + j] ** (terms[j, 1] + 1.0) / (terms[j, 1] + 1.0)
    return total


@njit(cache=True, error_model="numpy")
def _collide(masses, velocities, gaps, terms, tolerance):
    """The whole collision, SI in and SI out, as `regularised.collide` does it.

    `velocities` become those after, `gaps` the largest overlaps; `terms` is changed, too. Gives how it ended, the duration, the
    openings, the evaluations, and by how much of itself energy and momentum have changed.
    """
    count, inverse = len(gaps), 1.0 / masses
    mass = speed = size = 0.0
    for j in range(count):
        mass = max(mass, 1.0 / (inverse[j] + inverse[j + 1]))
    for j in range(count):
        q, squeezed = terms[j, 1], max(-gaps[j], 0.0)
        stored = 2.0 * terms[j, 0] * squeezed ** (q + 1.0) / (q + 1.0) / mass
        speed = max(speed, abs(velocities[j] - velocities[j + 1]), math.sqrt(stored))
    if speed == 0.0:
        gaps[:] = 0.0
        return STILL, 0.0, 0, 0, 0.0, 0.0
    for j in range(count):
        size = max(size, (mass * speed**2 / terms[j, 0]) ** (1.0 / (terms[j, 1] + 1.0)))
    if not 0.0 < size < math.inf:
        return NO_STEP, 0.0, 0, 0, math.nan, 0.0
    inverse *= mass
    terms[:, 0] *= size ** terms[:, 1] * size / (mass * speed**2)
    state = np.zeros(2 * count + 2)
    state[1 : count + 1], state[count + 1 :] = -gaps / size, velocities / speed
    gaps[:] = np.maximum(state[1 : count + 1], 0.0)
    before = _energy(state, inverse, terms)
    end, began, ended, openings, evaluations = follow(state, inverse, terms, gaps, tolerance)
    gained = (_energy(state, inverse, terms) - before) / max(1.0, before)
    shift = moved = 0.0
    for i in range(count + 1):
        if inverse[i] == 0.0:
            shift = moved = 0.0  # a wall takes momentum
            break
        old, new = velocities[i] / speed / inverse[i], state[count + 1 + i] / inverse[i]
        shift, moved = shift + (new - old), moved + abs(old) + abs(new)
    velocities[:] = state[count + 1 :] * speed
    gaps *= size
    return (
        end,
        (ended - began) * size / speed,
        openings,
        evaluations,
        gained,
        shift / moved if moved > 0.0 else 0.0,
    )
