"""A collision on a line, by the least model that answers."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from operator import sub

from corollary.scenes.integrate import both_ways, regularised
from corollary.scenes.progress import tell
from corollary.scenes.row import (
    RowOfBodies,
    RowResult,
    in_si,
    in_units,
    natural_units,
)
from corollary.scenes.run import (
    ROUNDING,
    GuardFailed,
    Model,
    Observed,
    Run,
    by_relative_errors,
    two_runs,
)

# Two runs may agree by chance: so many times their difference holds in all but one value of a thousand.
SAFE = 10.0
# One number's difference may pass through zero between two tolerances, where those of the others do not: this share of theirs is its own.
SHARED = 0.2
# So much of the strain of slow touches counts.
STRAINED = 0.5
SEEN_AS = {"duration": "duration", "largest_overlap": "overlaps", "peak_force": "forces"}
"""Which error is that of an observable; the others are worked out from the velocities."""


@dataclass(frozen=True, slots=True)
class Collided:
    """A result with the error of each thing seen in it (in natural units), and the model that found it.

    `warnings` are sentences about touches that are not decided.
    """

    result: RowResult
    errors: dict[str, float]
    model: Model
    why: str
    spent: int
    warnings: tuple[str, ...] = ()

    def observed(
        self,
        values: Mapping[str, Observed],
        scales: Mapping[str, float],
        errors: Mapping[str, float] | None = None,
    ) -> Run:
        """What is observed (SI), each with the error of what it is, or was worked out from; or with these `errors`, relative to `scales`."""
        off = errors or {name: self.errors.get(SEEN_AS.get(name, "velocities"), 0.0) for name in values}
        return by_relative_errors(
            values, off, self.model, self.why, self.spent, self.result.outcome, scales, self.warnings
        )


@lru_cache(maxsize=1024)
def collide(line: RowOfBodies, tolerance: float) -> Collided:
    """What the line comes to; found once and kept. The error is the difference from a coarser run, which is the coarser one's: the finer
    one's is smaller.

    Raises GuardFailed when no run keeps momentum and energy, BadSetting when compiled steps are asked for and numba is missing.
    """
    compiled, units, allowed = both_ways.wanted(), natural_units(line), two_runs(tolerance)
    if units is None:
        return Collided(regularised.collide(line), {}, "conservation", "nothing moves toward anything", 0)
    laid = regularised.LaidOut(in_units(line, units), compiled)
    tell(0.0)
    fine = laid.follow(allowed[1])  # first, for it may need too many steps
    tell(0.6)
    coarse = laid.follow(allowed[0])
    tell(1.0)
    if coarse.outcome != fine.outcome:
        raise GuardFailed(
            f"One run ends {coarse.outcome!r}, a finer one {fine.outcome!r}. Move the settings off that edge."
        )
    ends = not math.isinf(fine.duration)
    apart = abs(coarse.duration - fine.duration) / max(1.0, fine.duration) if ends else 0.0
    error = {
        "velocities": _apart(coarse.velocities, fine.velocities),
        "duration": apart,
        "overlaps": _apart(coarse.overlaps, fine.overlaps),
        "forces": _apart(coarse.forces, fine.forces),
    }
    if ends:
        # The moment of a slow touch hangs that much on speeds.
        strained = STRAINED * fine.strain * error["velocities"] / max(1.0, fine.duration)
        error["duration"] = max(error["duration"], strained)
    together = SHARED * max(error["velocities"], error["overlaps"], error["forces"], apart)
    errors = {name: max(SAFE * max(e, together), ROUNDING) for name, e in error.items()}
    spent = coarse.evaluations + fine.evaluations
    doubts = _doubts(line, (coarse, fine), errors["velocities"])
    return Collided(in_si(fine, units), errors, "integration", _reason(line), spent, doubts)


def _doubts(line: RowOfBodies, runs: tuple[RowResult, ...], error: float) -> tuple[str, ...]:
    """What is not decided of touches; the last of the runs, and the `error` of its velocities, are in the same units."""
    counts, found = [run.openings for run in runs], runs[-1]
    if math.isinf(found.duration) or line.weight or not counts[-1]:
        return ()
    doubts: list[str] = []
    if len(set(counts)) > 1:
        doubts.append(
            f"Two runs count {' and '.join(map(str, counts))} touches: the duration is not decided; ask for a smaller tolerance."
        )
    slow = [
        f"{i} and {i + 1}" for i, (a, b) in enumerate(pairwise(found.velocities), 1) if abs(b - a) <= error
    ]
    if slow:
        which = ", ".join(slow[:3]) + (" and others" if slow[3:] else "")
        doubts.append(
            f"Bodies {which} are left with no relative velocity that is known: a later touch, as slow, would not be in the duration, nor in the largest overlap and force."
        )
    return tuple(doubts)


def _reason(line: RowOfBodies) -> str:
    if any(c.eta > 0.0 for c in line.contacts):
        return "damping takes energy at every moment of the contact: no integral of motion is left"
    return f"{len(line.masses)} bodies touch at once: momentum and energy are two equations for {len(line.masses)} velocities"


def _apart(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    return max(map(abs, map(sub, a, b)))
