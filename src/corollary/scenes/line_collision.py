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
    caught_between,
    conserved,
    in_si,
    in_units,
    natural_units,
    reduced_mass,
)
from corollary.scenes.run import (
    ILL,
    ROUNDING,
    GuardFailed,
    Model,
    Observed,
    Run,
    by_relative_errors,
    two_runs,
)

# Two runs may agree by chance: so many times their difference holds in all but one value of a thousand (benchmarks/calibration.py).
SAFE = 10.0
# One number's difference may pass through zero between two tolerances, where those of the others do not: this share of theirs is its own.
SHARED = 0.2
# So many times what is too shallow to be seen is missed of the overlaps of a row of springs.
SEVERAL = 3.0
# So much of the strain of slow touches counts.
STRAINED = 0.5
# The last digit of a double.
DIGIT = 2.0**-52
# In longer rows of springs a sum of normal modes costs more than steps.
MOST_FOR_NORMAL_MODES = 20
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
def collide(line: RowOfBodies, tolerance: float, *, in_steps: bool = False) -> Collided:
    """What the line comes to; found once and kept. `in_steps` follows it whatever else could be done.

    Raises GuardFailed when no run keeps momentum and energy, BadSetting when compiled steps are asked for and numba is missing.
    """
    if not in_steps and _springs(line) and len(line.masses) <= MOST_FOR_NORMAL_MODES:
        return _by_normal_modes(line)
    return _integrated(line, tolerance)


def _springs(line: RowOfBodies) -> bool:
    return line.weight == 0.0 and all(c.q == 1.0 and c.eta == 0.0 for c in line.contacts)


def _by_normal_modes(line: RowOfBodies) -> Collided:
    from corollary.scenes.models import modal  # here, since it brings numpy, which most scenes never need

    try:
        result, otherwise = modal.collide(line), modal.collide(line, otherwise=True)
    except (ArithmeticError, ValueError) as lost:
        why = str(lost).rstrip(".")
        raise GuardFailed(f"These masses are too unequal for normal modes in doubles: {why}.") from lost
    # Every opening or closing hands its rounding on to what follows, and a light body is thrown to and fro: each time, too.
    thrown = math.sqrt(max(1.0, caught_between(line.masses)))
    rounded = ROUNDING * len(line.masses) * max(result.openings, 1) * thrown
    # Rows that are struck again and again amplify it, nobody knows how much: a run that is rounded otherwise shows it.
    apart = {
        name: SAFE * _apart(a, b) / (max(map(abs, a)) or 1.0)
        for name, a, b in (
            ("velocities", result.velocities, otherwise.velocities),
            ("overlaps", result.overlaps, otherwise.overlaps),
            ("duration", (result.duration,), (otherwise.duration,)),
        )
    }
    sure = max(rounded, apart["overlaps"], SHARED * apart["velocities"])
    fastest = max(map(abs, line.velocities))
    slow, late = _too_shallow(line, result, modal.NOISE)
    errors = {
        # A rounding of momentum is much of the speed of a light body.
        "velocities": max(
            rounded * thrown**2, apart["velocities"], _energy_lost(line, result), slow / fastest
        ),
        "overlaps": sure,
        "forces": sure,
        "duration": max(
            (30.0 + 3.0 * result.strain) * sure, apart["duration"], late / (result.duration or 1.0)
        ),
    }
    off = errors["velocities"] * fastest
    doubts = _doubts(line, (otherwise, result), off, "")
    if (grown := apart["velocities"] / SAFE / DIGIT) > ILL:
        doubts += (
            f"What is rounded in the sixteenth digit comes out {grown:.0e} times larger in the velocities (chaos).",
        )
    why = "springs: from one opening to the next the motion is a sum of swings"
    return Collided(result, errors, "piecewise exact", why, 0, doubts)


def _too_shallow(line: RowOfBodies, result: RowResult, noise: float) -> tuple[float, float]:
    """What an overlap that is too shallow to be seen, a share `noise` of the deepest, does to a light body: how fast (m/s) it may swing with it,
    and how much later (s) its contact may open."""
    units = natural_units(line)
    if units is None:
        return 0.0, 0.0
    shallow = SEVERAL * noise * units.overlap
    slow = late = 0.0
    met = zip(pairwise(line.masses), line.contacts, result.overlaps, pairwise(result.velocities), strict=True)
    for (a, b), contact, deep, (v, w) in met:
        swing = math.sqrt(reduced_mass(a, b) / contact.k)
        slow = max(slow, shallow / swing)
        if deep:  # it opens as slowly as it goes on
            late = max(late, min(math.pi * swing, shallow / (abs(w - v) or deep / swing)))
    return slow, late


def _energy_lost(line: RowOfBodies, result: RowResult) -> float:
    """What rounding made of the energy, as a velocity: the lightest body's, were it all in there and the energy shared out."""
    before, _, _ = conserved(line, [-gap for gap in line.gaps], line.velocities)
    after, _, _ = conserved(line, [0.0] * len(line.gaps), result.velocities)
    masses = [m for m in line.masses if not math.isinf(m)]
    return abs(after - before) / before * math.sqrt(max(masses) / min(masses)) if before else 0.0


def _integrated(line: RowOfBodies, tolerance: float) -> Collided:
    """The error is the difference from a coarser run, which is the coarser one's: the finer one's is smaller."""
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


def _doubts(
    line: RowOfBodies,
    runs: tuple[RowResult, ...],
    error: float,
    remedy: str = "; ask for a smaller tolerance",
) -> tuple[str, ...]:
    """What is not decided of touches; the last of the runs, and the `error` of its velocities, are in the same units."""
    counts, found = [run.openings for run in runs], runs[-1]
    if math.isinf(found.duration) or line.weight or not counts[-1]:
        return ()
    doubts: list[str] = []
    if len(set(counts)) > 1:
        doubts.append(
            f"Two runs count {' and '.join(map(str, counts))} touches: the duration is not decided{remedy}."
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
    if _springs(line):
        return f"{len(line.masses)} springs in a row: steps cost less than a sum of so many swings"
    return f"{len(line.masses)} bodies touch at once: momentum and energy are two equations for {len(line.masses)} velocities"


def _apart(a: tuple[float, ...], b: tuple[float, ...]) -> float:
    return max(map(abs, map(sub, a, b)))
