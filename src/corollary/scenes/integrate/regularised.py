"""Collisions of bodies in a row, each touch followed on its own variable, so that a method of high order keeps its order."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

from corollary.scenes.forces.contact import smoothing_power
from corollary.scenes.integrate import both_ways, row_motion
from corollary.scenes.row import (
    Conserved,
    RowOfBodies,
    RowResult,
    guard,
    in_si,
    in_units,
    natural_units,
)
from corollary.scenes.run import GuardFailed, Outcome

# A middle ball 1e-6 as heavy as its neighbours takes 26 000 steps, about a second; the number goes with the root of the masses' ratio.
# Where it would be too large nobody waits for the last of them: so many steps show whether the light ones are caught between the heavy.
MOST_STEPS, MOST_COMPILED, FEW = 100_000, 600_000, 4_000
LIGHTEST = 1.2e-7
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
    return in_si(LaidOut(in_units(line, units), compiled).follow(tolerance), units)


Seen = tuple[int, float, float, int, int, float]
"""What `row_motion.follow` gives."""


class LaidOut:
    """A line in its natural units as a kernel takes it, plain or compiled, once for all runs; with room to work in.

    A run takes `most` steps at most. Raises BadSetting when it is to be `compiled` and numba is missing.
    """

    def __init__(self, line: RowOfBodies, compiled: bool) -> None:
        self.line = line
        start, touching, row = state_of(line)
        deepest, self.room = [0.0] * len(line.gaps), both_ways.room(row_motion.ROOM, len(start), compiled)
        kernel, self.most = row_motion.collide, MOST_STEPS
        if compiled:
            kernel, self.most = both_ways.compiled("row_motion").collide, MOST_COMPILED
            start, touching, deepest, *row = both_ways.arrays(start, touching, deepest, *row)
        if lightest_between(line.masses) < LIGHTEST * (MOST_STEPS / self.most) ** 2:
            self.most = FEW
        self.kernel: Callable[..., tuple[Seen, Conserved, Conserved]] = kernel
        self.start, self.touching, self.row = start, touching, tuple(row)
        self.deepest, self.hardest = deepest, deepest.copy()

    def follow(self, tolerance: float) -> RowResult:
        """The same as `collide` for what is laid out; the result is in natural units, too."""
        y = self.start.copy()
        seen, before, after = self.kernel(
            y, self.touching, self.row, self.deepest, self.hardest, tolerance, self.most, self.room
        )
        state = list(map(float, y))
        end, began, ended, openings, evaluations, strain = seen
        if end == row_motion.TOO_LONG:
            damped = any(c.eta > 0.0 for c in self.line.contacts)
            remedy = "Choose less damping" if damped else "Make the masses less unequal"
            raise GuardFailed(
                f"The collision does not end within {self.most} steps. {remedy} or the balls fewer."
            )
        if end == row_motion.NO_STEP:
            raise GuardFailed(
                "No step is small enough to follow the collision. Make the settings less extreme."
            )
        if not all(map(math.isfinite, state)):
            raise OverflowError("a number of the collision is too large or too small")
        if end != row_motion.STICKS:
            guard(self.line, before, after, 1e3 * tolerance + 1e-15 * evaluations, evaluations)
        return RowResult(
            velocities=tuple(state[::2]),
            duration=ended - began if began < math.inf else 0.0,
            overlaps=tuple(map(float, self.deepest)),
            forces=tuple(map(float, self.hardest)),
            outcome=OUTCOMES[end],
            evaluations=evaluations,
            openings=openings,
            strain=strain,
            left=tuple([-overlap for overlap in state[1::2]]),
        )


def lightest_between(masses: Sequence[float]) -> float:
    """The least that neighbours weigh who stand between two others, as a part of the lighter of these; one where none are lighter."""
    least = 1.0
    for i in range(1, len(masses) - 1):
        heaviest = 0.0
        for j in range(i, len(masses) - 1):
            heaviest = max(heaviest, masses[j])
            if heaviest >= masses[i - 1]:
                break
            least = min(least, heaviest / min(masses[i - 1], masses[j + 1]))
    return least


def state_of(line: RowOfBodies) -> tuple[list[float], list[bool], tuple[Sequence[float], ...]]:
    """A line in natural units as the kernel wants it: its state, what touches, and what does not change (`row_law`)."""
    y = [x for v, gap in zip(line.velocities, (*line.gaps, 0.0), strict=True) for x in (v, -gap)][:-1]
    known = {c.q: smoothing_power(c) for c in set(line.contacts)}
    row = (
        [1.0 / m for m in line.masses],
        [0.0 if m == math.inf else line.weight for m in line.masses],
        [c.k for c in line.contacts],
        [c.q for c in line.contacts],
        [c.eta for c in line.contacts],
        [known[c.q] for c in line.contacts],
    )
    return y, [gap <= 0.0 for gap in line.gaps], row
