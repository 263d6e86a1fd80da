"""Collisions of bodies in a row, each touch followed on its own variable, so that a method of high order keeps its order."""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.scenes.forces.contact import smoothing_power
from corollary.scenes.integrate import both_ways, row_motion
from corollary.scenes.row import (
    RowOfBodies,
    RowResult,
    caught_between,
    energy,
    guard,
    in_si,
    in_units,
    natural_units,
)
from corollary.scenes.run import GuardFailed, Outcome

# A middle ball 1e-6 as heavy as its neighbours takes 26 000 steps.
MOST_STEPS, MOST_COMPILED = 400_000, 600_000
# Where a ball may be thrown to and fro (`caught_between`) a run that is not over after so many steps, or a few more than balls that all
# move need at least, goes on only if so many rough ones lead to its end: together they take less than a second.
THROWN, FIRST_STEPS, OF_ALL, MOST_ROUGH = 1e3, 1000, 20_000, 40_000
OUTCOMES: dict[int, Outcome] = {
    row_motion.RELEASED: "released",
    row_motion.MISSED: "missed",
    row_motion.STICKS: "sticks",
}


def collide(line: RowOfBodies, tolerance: float = 1e-13, *, compiled: bool = False) -> RowResult:
    """Follow the line from its start to the last opening; `tolerance` is the error allowed to a single step, in natural units.

    Raises GuardFailed when momentum or energy is lost or the end is not reached, OverflowError when a number leaves the range of a
    computer, BadSetting when it is to be `compiled` and numba is missing.
    """
    units = natural_units(line)
    if units is None:
        still = (0.0,) * len(line.gaps)
        return RowResult(line.velocities, 0.0, still, still, "missed", 0)
    return in_si(follow(in_units(line, units), tolerance, compiled), units)


def follow(line: RowOfBodies, tolerance: float, compiled: bool) -> RowResult:
    """The same for a line in its natural units, in which the result is, too."""
    most = MOST_COMPILED if compiled else MOST_STEPS
    first = min(FIRST_STEPS, OF_ALL // len(line.masses)) if _may_throw(line) else most
    state, deepest, hardest, seen = _steps(line, tolerance, first, compiled)
    if seen[0] == row_motion.TOO_LONG and first < most and _ends(line):
        state, deepest, hardest, seen = _steps(line, tolerance, most, compiled)
    end, began, ended, openings, evaluations = seen
    if end == row_motion.TOO_LONG:
        raise GuardFailed(
            f"The collision does not end within {most} steps. Make the masses less unequal or the balls fewer."
        )
    if end == row_motion.NO_STEP:
        raise GuardFailed("No step is small enough to follow the collision. Make the settings less extreme.")
    if not all(map(math.isfinite, state)):
        raise OverflowError("a number of the collision is too large or too small")
    velocities = tuple(state[::2])
    if end != row_motion.STICKS:
        lost = 1e3 * tolerance + 1e-15 * evaluations
        guard(line, energy(line, state[1::2], velocities), velocities, lost)
    return RowResult(
        velocities=velocities,
        duration=ended - began if began < math.inf else 0.0,
        overlaps=tuple(deepest),
        forces=tuple(hardest),
        outcome=OUTCOMES[end],
        evaluations=evaluations,
        openings=openings,
    )


def _may_throw(line: RowOfBodies) -> bool:
    """Whether a ball may be thrown to and fro for long; what is damped or weighed is not foreseen."""
    free = line.weight == 0.0 and all(c.eta == 0.0 for c in line.contacts)
    return free and caught_between(line.masses) > THROWN


def _ends(line: RowOfBodies) -> bool:
    from corollary.scenes.integrate.outlook import rough_steps  # here, since it brings numpy

    return rough_steps(line, MOST_ROUGH) < MOST_ROUGH


Followed = tuple[list[float], list[float], list[float], tuple[int, float, float, int, int]]
"""The state, the largest overlaps and forces, and what the kernel gives."""


def _steps(line: RowOfBodies, tolerance: float, most: int, compiled: bool) -> Followed:
    count, (y, touching, row) = len(line.gaps), state_of(line)
    deepest, hardest = [0.0] * count, [0.0] * count
    room = [[0.0] * len(y) for _ in range(row_motion.ROOM)]
    if not compiled:
        given = row_motion.follow(y, touching, row, deepest, hardest, tolerance, most, room)
        return y, deepest, hardest, given
    array = both_ways.array
    state, overlaps, forces = map(array, (y, deepest, hardest))
    given = both_ways.compiled("row_motion").follow(
        state, array(touching), tuple(map(array, row)), overlaps, forces, tolerance, most, array(room)
    )
    return state.tolist(), overlaps.tolist(), forces.tolist(), given


def state_of(line: RowOfBodies) -> tuple[list[float], list[bool], tuple[Sequence[float], ...]]:
    """A line in natural units as the kernel wants it: its state, what touches, and what does not change (`row_law`)."""
    y = [x for v, gap in zip(line.velocities, (*line.gaps, 0.0), strict=True) for x in (v, -gap)][:-1]
    contacts = line.contacts
    known = {contact: smoothing_power(contact) for contact in set(contacts)}
    row = (
        [1.0 / m for m in line.masses],
        [0.0 if math.isinf(m) else line.weight for m in line.masses],
        [c.k for c in contacts],
        [c.q for c in contacts],
        [c.eta for c in contacts],
        [known[c] for c in contacts],
    )
    return y, [gap <= 0.0 for gap in line.gaps], row
