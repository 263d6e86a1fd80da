"""Collisions of bodies in a row, each touch followed on its own variable, so that a method of high order keeps its order."""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.scenes.forces.contact import smoothing_power
from corollary.scenes.integrate import both_ways, row_motion
from corollary.scenes.row import RowOfBodies, RowResult, energy, guard, in_si, in_units, natural_units
from corollary.scenes.run import GuardFailed, Outcome

# A middle ball 1e-6 as heavy as its neighbours takes 45 000 steps; 1e-7 as heavy would take 150 000: beyond, a run in plain Python
# would take minutes. In compiled steps the former is a tenth of a second.
MOST_STEPS, MOST_STEPS_OF_A_LONG_ROW, MOST_COMPILED = 50_000, 20_000, 600_000
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
    if not all(map(math.isfinite, (units.mass, units.speed, units.overlap, units.time, units.force))):
        raise OverflowError("a number of the collision is too large or too small")
    return in_si(_follow(in_units(line, units), tolerance, compiled), units)


def _follow(line: RowOfBodies, tolerance: float, compiled: bool) -> RowResult:
    count, (y, touching, row) = len(line.gaps), state_of(line)
    deepest, hardest = [0.0] * count, [0.0] * count
    room = [[0.0] * len(y) for _ in range(row_motion.ROOM)]
    if compiled:
        most, follow = MOST_COMPILED, both_ways.compiled("row_motion").follow
        y, deepest, hardest, room = map(both_ways.array, (y, deepest, hardest, room))
        touching, row = both_ways.array(touching), tuple(map(both_ways.array, row))
    else:
        follow = row_motion.follow
        most = MOST_STEPS if count + 1 < row_motion.LONG else MOST_STEPS_OF_A_LONG_ROW
    end, began, ended, openings, evaluations = follow(
        y, touching, row, deepest, hardest, tolerance, most, room
    )
    if end == row_motion.TOO_LONG:
        raise GuardFailed(
            f"The collision does not end within {most} steps. Make the masses less unequal or the balls fewer."
        )
    if end == row_motion.NO_STEP:
        raise GuardFailed("No step is small enough to follow the collision. Make the settings less extreme.")
    state = list(map(float, y))
    if not all(map(math.isfinite, state)):
        raise OverflowError("a number of the collision is too large or too small")
    velocities = tuple(state[::2])
    if end != row_motion.STICKS:
        lost = 1e3 * tolerance + 1e-15 * evaluations
        guard(line, energy(line, state[1::2], velocities), velocities, lost)
    return RowResult(
        velocities=velocities,
        duration=ended - began if began < math.inf else 0.0,
        overlaps=tuple(map(float, deepest)),
        forces=tuple(map(float, hardest)),
        outcome=OUTCOMES[end],
        evaluations=evaluations,
        openings=openings,
    )


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
