"""Obligations settled: by points that break them, by algebra, by subdivision, by z3, or not at all."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property

import numpy as np

from corollary.derive.solution import Solution
from corollary.formula.ast import Relation
from corollary.formula.text import text
from corollary.verify.obligations.algebra import Algebra, linear
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.created import not_created
from corollary.verify.obligations.mistakes import apart, differing
from corollary.verify.obligations.nonlinear import installed, no_exception, only_root
from corollary.verify.obligations.obligation import Clause, Obligation, Settled, opposite
from corollary.verify.obligations.regimes import one_case
from corollary.verify.obligations.roots import only_roots
from corollary.verify.obligations.signs import always_so, of_claimed_sign
from corollary.verify.obligations.subdivision import (
    MOST_BOXES,
    any_holds,
    none_holds,
    subdivide,
    surely_fails,
)
from corollary.verify.obligations.values import existing, not_zero

POINTS = 256  # tried first: most of what does not hold fails there, and no prover has to find it
FEW_BOXES = 3_000  # before z3 is asked, which takes longer
REDRAWN_STEPS = 100_000  # of z3: what cannot be proven of these is never dealt anyway
SEED = 12


def obligations(solution: Solution) -> Iterator[Obligation]:
    """All that a solved derivation must fulfil, but for its laws."""
    yield from one_case(solution)
    yield from existing(solution)
    yield from only_roots(solution)
    yield from not_created(solution)
    yield from not_zero(solution)
    yield from of_claimed_sign(solution)
    yield from always_so(solution)
    yield from apart(solution)
    yield from differing(solution)


def settled(solution: Solution, sampled: str) -> Iterator[Settled]:
    """Each obligation settled; `sampled` says what was tried besides. In a derivation with cases, each within its own."""
    if not solution.regimes:
        yield from _of_one(solution, (), sampled)
        return
    yield from _of_one(solution, (), sampled, one_case)
    for each in solution.regimes:
        yield from _of_one(each.solution, each.conditions, sampled)


def _of_one(
    solution: Solution,
    conditions: tuple[Relation, ...],
    sampled: str,
    claims: Callable[[Solution], Iterator[Obligation]] = obligations,
) -> Iterator[Settled]:
    try:
        settling = Settling(Box(solution.problem, conditions), sampled)
    except ValueError:
        for each in claims(solution):
            yield Settled(each.kind, each.claim, each.line, "sampled", sampled)
        return
    yield from map(settling.settle, claims(solution))


class Settling:
    """The provers, on one box."""

    def __init__(self, box: Box, sampled: str) -> None:
        self.box, self.sampled = box, sampled
        self.proven: dict[Clause, str] = {}

    @cached_property
    def points(self) -> dict[str, np.ndarray]:
        """Points of the grid that keep the conditions."""
        random = np.random.default_rng(SEED)
        places = {name: random.integers(0, axis.count, POINTS) for name, axis in self.box.axes.items()}
        admissible = self.box.keeping(self.box.conditions, places) if places else None
        return {name: at[admissible] for name, at in places.items()}

    def settle(self, each: Obligation) -> Settled:
        """The first prover that decides."""
        if each.kind == "mistakes differ":
            return self._differ(each)
        if each.equations is not None and not each.open and linear(self.box, each.equations):
            each = Obligation(each.kind, each.claim, each.line, each.needs)
        elif each.equations is not None and installed() and only_root(self.box, each.equations):
            each = Obligation(each.kind, each.claim, each.line, each.needs)
            self.proven[()] = "z3"
            return self._needs(each, ["z3"])
        return self._needs(each, [])

    def _needs(self, each: Obligation, ways: list[str]) -> Settled:
        if each.open and not each.needs:
            return self._unsettled(each, each.open)
        for need in each.needs:
            if need not in self.proven:
                found = self._prove(need, each.redrawn)
                if isinstance(found, dict):
                    return self._broken(each, need, found)
                if not found:
                    return self._unsettled(each, self.sampled)
                self.proven[need] = found
            ways.append(self.proven[need])
        if each.open:
            return self._unsettled(each, each.open)
        order = ("enumeration", "z3", "subdivision", "algebra")
        return Settled(
            each.kind, each.claim, each.line, "proven", next((way for way in order if way in ways), "algebra")
        )

    def _prove(self, need: Clause, redrawn: bool) -> str | dict[str, int]:
        """The prover; a point at which it fails; or "" where nothing decides."""
        algebra = Algebra(self.box, need)
        if any(map(algebra.holds, need)):
            return "algebra"
        letters, _ = self.box.tied(need)
        if letters and len(self.points[letters[0]]):
            places = {name: self.points[name] for name in letters}
            failing = surely_fails(need, self.box, places)
            if failing.any():
                first = int(np.argmax(failing))
                return {name: int(at[first]) for name, at in places.items()}
        for most in (FEW_BOXES, MOST_BOXES):
            divided = subdivide(self.box, need, most)
            if divided is not None:
                return (
                    (divided.failing or {})
                    if not divided.proven
                    else "enumeration"
                    if divided.points
                    else "subdivision"
                )
            if most == FEW_BOXES and installed():
                found = (
                    no_exception(self.box, need, REDRAWN_STEPS) if redrawn else no_exception(self.box, need)
                )
                if found is True:
                    return "z3"
                if isinstance(found, dict) and self._fails(need, found):
                    return found
            if redrawn:
                break
        return ""

    def _fails(self, need: Clause, point: dict[str, int]) -> bool:
        """Whether the grid point keeps the conditions, and breaks the claim."""
        places = {name: np.array([place]) for name, place in point.items()}
        _, conditions = self.box.tied(need)
        return bool(self.box.keeping(conditions, places)[0] and none_holds(need, self.box, places)[0])

    def _broken(self, each: Obligation, need: Clause, point: dict[str, int]) -> Settled:
        names = list(point)
        admissible = {name: self.points[name] for name in names}
        share = (
            float(np.mean(surely_fails(need, self.box, admissible)))
            if names and len(admissible[names[0]])
            else 1.0
        )
        numbers = self.box.written(point)
        if each.redrawn:
            by = f"redrawn otherwise ({share:.1%} of the draws at most)" if share else "redrawn otherwise"
            return Settled(each.kind, each.claim, each.line, "proven", by, numbers, "", share)
        exclude = " or ".join(map(text, need))
        return Settled(each.kind, each.claim, each.line, "counter-example", "grid", numbers, exclude, share)

    def _unsettled(self, each: Obligation, why: str) -> Settled:
        if each.redrawn:
            return Settled(each.kind, each.claim, each.line, "proven", "redrawn otherwise")
        return Settled(each.kind, each.claim, each.line, "sampled", why)

    def _differ(self, each: Obligation) -> Settled:
        """One point at which two formulas differ shows that they are not the same."""
        (need,) = each.needs
        letters = [name for name in self.points if len(self.points[name])]
        places = {name: self.points[name] for name in letters}
        if letters and any_holds(need, self.box, places).any():
            return Settled(each.kind, each.claim, each.line, "proven", "a point")
        algebra = Algebra(self.box, need)
        if all(algebra.holds(opposite(one)) for one in need):
            return Settled(each.kind, each.claim, each.line, "counter-example", "algebra")
        return Settled(each.kind, each.claim, each.line, "sampled", f"the same at {POINTS} points")
