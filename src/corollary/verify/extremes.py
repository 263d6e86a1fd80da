"""Closed forms pushed to the ends of the range: the certified value, a refusal with a reason, and what doubles make of it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction

from corollary.answers.evaluation import as_exact
from corollary.derive.numbered_list import solution_for
from corollary.derive.solution import SceneOutcome, Solution
from corollary.formula.ast import names
from corollary.formula.ball import Certified, RationalPi, Undefined, certified
from corollary.grading.replay import compute
from corollary.problem.given import Given
from corollary.problem.variant import Variant, chapter
from corollary.units.unit import ONE

POWERS = (-150, -12, 12, 150)
NEAR = Fraction(1, 10**12)


@dataclass(frozen=True, slots=True)
class Pushed:
    """One problem at its extremes: how many values were certified, refused, or left unproven.

    `worst` (ulp) is the largest error of a replay in doubles, met at `where`. `lost` counts values for which the replay gave
    none although there is one: the way to it, not the value, left the range. `cancelled` counts values that are exactly zero
    and came out as a remainder.
    """

    code: str
    proven: int
    unproven: int
    refused: Mapping[str, int]
    lost: int
    cancelled: int
    worst: float
    where: str

    @property
    def ok(self) -> bool:
        return not self.unproven


def push(solution: Solution) -> Pushed:
    """Every given of a problem, one after the other, at each of its extremes; all finds that have a closed form."""
    proven = unproven = lost = cancelled = 0
    refused: dict[str, int] = {}
    worst, where = 0.0, ""
    for label, givens in pushed(chapter(solution.problem)):
        try:
            here = solution_for(solution, givens)
        except Undefined as reason:
            refused[str(reason)] = refused.get(str(reason), 0) + 1
            continue
        replayed = replay_in_doubles(here, givens)
        for find in here.unknowns:
            for i, tree in enumerate(find.in_givens or ()):
                try:
                    true = certified(tree, givens)
                except Undefined as reason:
                    refused[str(reason)] = refused.get(str(reason), 0) + 1
                    continue
                if math.isinf(true.value):
                    refused["beyond the doubles"] = refused.get("beyond the doubles", 0) + 1
                    continue
                proven, unproven = proven + true.proven, unproven + (not true.proven)
                near = replayed.get(find.names[i])
                if near is None:
                    lost += 1
                elif true.value == 0.0:
                    cancelled += near != 0.0
                elif (off := ulps(near, true)) > worst:
                    worst, where = off, f"{find.names[i]} at {label}"
    return Pushed(solution.problem.code, proven, unproven, refused, lost, cancelled, worst, where)


def pushed(variant: Variant) -> Iterator[tuple[str, dict[str, RationalPi]]]:
    """The chapter's numbers with one given at an extreme, and what to call that."""
    givens = variant.exact
    for given in variant.problem.givens:
        for label, value in extremes(given, givens[given.symbol]):
            yield label, givens | {given.symbol: value}


def extremes(given: Given, value: RationalPi) -> Iterator[tuple[str, RationalPi]]:
    """Angles within 1e-12 of pi of 0 and 90 degrees, pure numbers 0 and 1, everything else 1e±12 and 1e±150 times itself."""
    if given.unit.pi and given.unit.dimension == ONE:
        yield f"{given.symbol} = 1e-12 pi", RationalPi(NEAR, 1)
        yield f"{given.symbol} = pi/2 - 1e-12 pi", RationalPi(Fraction(1, 2) - NEAR, 1)
    elif given.unit.dimension == ONE:
        yield f"{given.symbol} = 0", RationalPi(Fraction(0))
        yield f"{given.symbol} = 1", RationalPi(Fraction(1))
    else:
        for power in POWERS:
            yield f"{given.symbol} × 1e{power}", RationalPi(value.ratio * Fraction(10) ** power, value.pi)


def replay_in_doubles(solution: Solution, givens: Mapping[str, RationalPi]) -> dict[str, float]:
    """Each find from the rounded earlier ones, as marks are made; those that come from a scene, or need one, are left out."""
    known: dict[str, RationalPi] = dict(givens)
    found: dict[str, float] = {}
    for find in solution.unknowns:
        if isinstance(find.local, SceneOutcome) or any(
            names(tree) - known.keys() - {"pi"} for tree in find.local.trees
        ):
            continue
        try:
            numbers = compute(find.local, known)
            known |= {name: as_exact(number) for name, number in zip(find.names, numbers, strict=True)}
        except Undefined:
            continue
        found |= dict(zip(find.names, numbers, strict=True))
    return found


def ulps(value: float, true: Certified) -> float:
    """How many last places of the true value a value is away from it."""
    return abs(value - true.value) / math.ulp(true.value)
