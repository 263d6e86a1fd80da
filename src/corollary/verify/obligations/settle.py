"""Obligations settled: by points that break them, by algebra, by subdivision, by z3, or not at all."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from corollary.derive.solution import Solution
from corollary.formula.ast import Expr, Relation, names, opposite
from corollary.formula.plain_text import text
from corollary.formula.rational_pi import RationalPi
from corollary.problem.axes import row_by_row, tables
from corollary.problem.problem import Problem
from corollary.problem.sampling import sample
from corollary.problem.variant import Variant, number
from corollary.verify.obligations.algebra import Algebra
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.claims import (
    NOT_FOUND,
    always_so,
    apart,
    differing,
    existing,
    laws_hold,
    needed,
    not_created,
    not_zero,
    of_claimed_sign,
    off_steps,
    one_case,
    only_roots,
)
from corollary.verify.obligations.nonlinear import STEPS, installed, no_exception, only_root
from corollary.verify.obligations.obligation import REDRAWN, Clause, Obligation, Settled
from corollary.verify.obligations.subdivision import (
    MOST_BOXES,
    any_holds,
    has_value,
    subdivide,
    surely_fails,
    verdict,
)
from corollary.verify.obligations.uniqueness import another_root, fulfils, leading

POINTS = 256  # tried first: most of what does not hold fails there, and no prover has to find it
FEW_BOXES = 3_000  # before z3 is asked, which takes longer
REDRAWN_STEPS = 100_000  # of z3: what cannot be proven of these is never dealt anyway
SEED = 12


def obligations(solution: Solution) -> Iterator[Obligation]:
    """All that a solved derivation must fulfil."""
    yield from one_case(solution)
    yield from laws_hold(solution)
    yield from existing(solution)
    yield from off_steps(solution)
    yield from only_roots(solution)
    yield from not_created(solution)
    yield from not_zero(solution)
    yield from of_claimed_sign(solution)
    yield from always_so(solution)
    yield from apart(solution)
    yield from differing(solution)


def settled(solution: Solution, variants: int) -> Iterator[Settled]:
    """Each obligation settled; what is not proven is tried with so many variants. In a derivation with cases, each within its own."""
    if not solution.regimes:
        yield from _of_one(solution, (), variants)
        return
    yield from _of_one(solution, (), variants, one_case)
    for each in solution.regimes:
        yield from _of_one(each.solution, each.conditions, variants)


def _excluding(need: Clause) -> str:
    """The condition that would exclude the numbers of a counter-example; "" where it says nothing of the givens."""
    about = [each for each in need if names(each)]
    return " or ".join(map(text, about))


def _of_one(
    solution: Solution,
    conditions: tuple[Relation, ...],
    variants: int,
    claims: Callable[[Solution], Iterator[Obligation]] = obligations,
) -> Iterator[Settled]:
    case = solution.case if conditions else ""
    try:
        settling = Settling(Box(solution.problem, conditions), variants)
        rows = RowByRow(solution.problem, conditions, variants) if tables(solution.problem) else None
    except ValueError as error:
        for each in claims(solution):
            yield Settled(each.kind, each.claim, each.line, "undecided", str(error), case=case)
        return
    for each in claims(solution):
        found = settling.settle(each) if rows is None else rows.settle(each, settling)
        yield replace(found, case=case)


@dataclass(frozen=True, slots=True)
class Refutation:
    """A grid point that keeps the conditions, and the clause that does not hold there: a claim, or what it needs to have a value."""

    point: Mapping[str, int]
    need: Clause


class Settling:
    """The provers, on one box."""

    def __init__(self, box: Box, variants: int = 100, vacuous: bool = False) -> None:
        """`vacuous`: that no numbers keep the conditions says nothing, for others do."""
        self.box, self.variants, self.vacuous = box, variants, vacuous
        self.found: dict[tuple[Clause, bool, bool], str | Refutation] = {}

    @cached_property
    def points(self) -> dict[str, np.ndarray]:
        """Points of the grid that keep the conditions."""
        places = self.box.random_points(np.random.default_rng(SEED), POINTS)
        admissible = self.box.keeping(self.box.conditions, places) if places else None
        return {name: at[admissible] for name, at in places.items()}

    @cached_property
    def samples(self) -> list[Variant]:
        """Variants that keep the conditions."""
        drawn = sample(self.box.problem, self.variants)
        return [each for each in drawn if all(verdict((one,), each.exact) for one in self.box.conditions)]

    @cached_property
    def empty(self) -> bool:
        """Whether no numbers are known that keep the conditions: of these everything could be proven."""
        return not any(map(len, self.points.values())) and not self.samples

    def settle(self, each: Obligation) -> Settled:
        """The first prover that decides."""
        if self.box.conditions and self.empty and not self.vacuous:
            return Settled(each.kind, each.claim, each.line, "undecided", "no numbers keep the conditions")
        if each.somewhere:
            return self._differ(each)
        if each.open and not each.needs and not each.partial:
            return self._open(each)
        ways = list[str]()
        for need in each.needs:
            if (failed := self._settle_need(each, need, ways)) is not None:
                return failed
        if each.kind == "one root" and (failed := self._settle_root(each, ways)) is not None:
            return failed
        if each.open:
            return self._open(each)
        return Settled(each.kind, each.claim, each.line, "proven", hardest(ways))

    def _settle_need(self, each: Obligation, need: Clause, ways: list[str]) -> Settled | None:
        """How the obligation is settled where this need is not proven."""
        found = self.prove(need, each.redrawn)
        if isinstance(found, Refutation) and not (
            each.kind == "value exists" and self._has_values(each, found)
        ):
            return self._broken(each, found)
        if isinstance(found, Refutation) or not found:
            return self._unsettled(each)
        ways.append(found)
        return None

    def _has_values(self, each: Obligation, refutation: Refutation) -> bool:
        """Whether all formulas have a value though what is needed in general fails: a cube of a negative number whose exponent is given."""
        values = self.box.exact(dict.fromkeys(self.box.axes, 0) | dict(refutation.point))
        return all(has_value(tree, values) is not False for tree in each.formulas)

    def _settle_root(self, each: Obligation, ways: list[str]) -> Settled | None:
        """How it is settled where another root may fulfil laws and conditions; None where there is none."""
        for place, need in enumerate(each.partial):
            found = self.prove(need, partial=True)
            if isinstance(found, Refutation) and each.equations is not None:
                values = self._values(found.point)
                laws = (*each.equations.laws, *each.equations.where)
                if values is not None and fulfils(laws, each.equations.others[place], values):
                    return self._broken(each, found)
        equations = each.equations
        if equations is None:
            return None
        clauses = leading(self.box, equations)
        proven = [self.prove(need, partial=True) for need in clauses or ()]
        for found in proven:
            if isinstance(found, Refutation) and (values := self._values(found.point)) is not None:
                other = another_root(equations, values)
                if other is not None:
                    return self._broken(each, found)
        proven += [self.prove(need, partial=True) for need in each.partial]
        if clauses is not None and all(isinstance(found, str) and found for found in proven):
            ways += [found for found in proven if isinstance(found, str)]
            return None
        trees = [tree for root in (equations.meant, *equations.rejected) for tree in root.values()]
        if installed() and only_root(self.box, equations) and self._have_values(trees):
            ways.append("z3")
            return None
        return self._unsettled(each, NOT_FOUND)

    def _values(self, point: Mapping[str, int]) -> dict[str, RationalPi] | None:
        """All givens at an admissible point with these places; None where none is found."""
        fixed = {name: self.box.axes[name].exact[place] for name, place in point.items()}
        for each in (
            *(variant.exact for variant in self.samples),
            self.box.exact(dict.fromkeys(self.box.axes, 0)),
        ):
            values = {**each, **fixed}
            if all(verdict((one,), values) for one in self.box.conditions):
                return values
        return None

    def prove(self, need: Clause, redrawn: bool = False, partial: bool = False) -> str | Refutation:
        """The prover that shows the clause for all numbers of the box; where it fails; or "" where nothing decides. `partial`: the clause
        may have no value, and then says nothing."""
        key = need, redrawn, partial
        if key not in self.found:
            self.found[key] = self._prove(need, redrawn, partial)
        return self.found[key]

    def _prove(self, need: Clause, redrawn: bool, partial: bool) -> str | Refutation:
        algebra = Algebra(self.box, need)
        if any(algebra.holds(each) and (partial or self._has_value((each,))) for each in need):
            return "algebra"
        letters, _ = self.box.tied(need)
        if letters and len(self.points[letters[0]]):
            places = {name: self.points[name] for name in letters}
            failing = surely_fails(need, self.box, places)
            if failing.any():
                first = int(np.argmax(failing))
                return Refutation({name: int(at[first]) for name, at in places.items()}, need)
        if not partial and not redrawn and len(need) == 1 and (missing := self._no_value(need)) is not None:
            return missing
        for most in (FEW_BOXES, MOST_BOXES):
            divided = subdivide(self.box, need, most, partial)
            if divided is not None:
                if not divided.proven:
                    return Refutation(divided.failing or {}, need)
                return "enumeration" if divided.points else "subdivision"
            if most == FEW_BOXES and installed():
                found = no_exception(self.box, need, REDRAWN_STEPS if redrawn else STEPS)
                if found is True and (partial or self._has_value(need)):
                    return "z3"
                if isinstance(found, dict) and self._fails(need, found, partial):
                    return Refutation(found, need)
            if redrawn:
                break
        return ""

    def _has_value(self, need: Clause) -> bool:
        return self._have_values([side for each in need for side in (each.left, each.right)])

    def _have_values(self, trees: Iterable[Expr]) -> bool:
        """Whether it is proven that the formulas have values: nothing is divided by zero, not even where it cancels."""
        return all(
            isinstance(self.prove((each,)), str) and self.prove((each,))
            for tree in trees
            for each in needed(tree)
        )

    def _no_value(self, need: Clause) -> Refutation | None:
        """Where a relation is known to have no value."""
        (relation,) = need
        for each in (one for side in (relation.left, relation.right) for one in needed(side)):
            found = self.prove((each,))
            if isinstance(found, Refutation):
                values = self.box.exact(dict.fromkeys(self.box.axes, 0) | dict(found.point))
                if False in (has_value(relation.left, values), has_value(relation.right, values)):
                    return found
        return None

    def _fails(self, need: Clause, point: dict[str, int], partial: bool) -> bool:
        """Whether the grid point keeps the conditions, and breaks the claim."""
        _, conditions = self.box.tied(need)
        values = self.box.exact(point)
        return (
            all(verdict((each,), values) for each in conditions) and verdict(need, values, partial) is False
        )

    def _broken(self, each: Obligation, refutation: Refutation) -> Settled:
        point, need = refutation.point, refutation.need
        letters = list(point)
        admissible = {name: self.points[name] for name in letters}
        share = (
            1.0 - float(np.mean(any_holds(need, self.box, admissible)))
            if letters and len(admissible[letters[0]])
            else 1.0
        )
        numbers = self.box.written(point) if point else self._any_numbers()
        if each.redrawn:
            by = redrawn_share(share) if share else REDRAWN
            return Settled(each.kind, each.claim, each.line, "sampled", by, numbers, "", share)
        exclude = _excluding(need) if point else ""
        return Settled(each.kind, each.claim, each.line, "counter-example", "grid", numbers, exclude, share)

    def _any_numbers(self) -> dict[str, str]:
        """Some numbers that keep the conditions, for what fails for all."""
        if not any(map(len, self.points.values())):
            return {}
        return self.box.written({name: int(at[0]) for name, at in self.points.items()})

    def _open(self, each: Obligation) -> Settled:
        if each.redrawn:
            return Settled(each.kind, each.claim, each.line, "sampled", REDRAWN)
        return Settled(each.kind, each.claim, each.line, "sampled" if each.tried else "undecided", each.open)

    def _unsettled(self, each: Obligation, why: str = "") -> Settled:
        """What no prover decides: sampled where it holds for the variants that are tried, and else undecided."""
        if each.redrawn:
            return Settled(each.kind, each.claim, each.line, "sampled", REDRAWN)
        if each.kind == "value exists":
            return self._tried(each)
        for variant in self.samples:
            for needs, partial in ((each.needs, False), (each.partial, True)):
                held = [verdict(need, variant.exact, partial) for need in needs]
                if False in held:
                    numbers = {
                        name: number(self.box.problem.given(name), value)
                        for name, value in variant.values.items()
                    } | {
                        each.symbol: f"{each.unit.from_si(float(variant.exact[each.symbol])):.6g}"
                        for each in self.box.problem.variables
                    }
                    if not partial:
                        exclude = _excluding(needs[held.index(False)])
                        return Settled(
                            each.kind, each.claim, each.line, "counter-example", "a variant", numbers, exclude
                        )
                if not all(held):
                    return Settled(
                        each.kind,
                        each.claim,
                        each.line,
                        "undecided",
                        why or "no prover decides, nor do numbers",
                    )
        if not self.samples:
            return Settled(each.kind, each.claim, each.line, "undecided", why or "no prover decides")
        tried = f"{len(self.samples)} variants"
        return Settled(each.kind, each.claim, each.line, "sampled", f"{tried}; {why}" if why else tried)

    def _tried(self, each: Obligation) -> Settled:
        """Whether formulas have values, where what they need in general is not shown."""
        exist = [has_value(tree, variant.exact) for variant in self.samples for tree in each.formulas]
        if not exist or not all(exist):
            return Settled(each.kind, each.claim, each.line, "undecided", "no prover decides")
        return Settled(each.kind, each.claim, each.line, "sampled", f"{len(self.samples)} variants")

    def _differ(self, each: Obligation) -> Settled:
        """One point at which two formulas differ shows that they are not the same."""
        (need,) = each.needs
        letters = [name for name in self.points if len(self.points[name])]
        places = {name: self.points[name] for name in letters}
        if letters and any_holds(need, self.box, places).any():
            return Settled(each.kind, each.claim, each.line, "proven", "a point")
        algebra = Algebra(self.box, need)
        if all(algebra.holds(opposite(one)) for one in need):
            return Settled(
                each.kind, each.claim, each.line, "counter-example", "algebra", self._any_numbers()
            )
        if not letters:
            return Settled(each.kind, each.claim, each.line, "undecided", "no point was found to try")
        return Settled(
            each.kind, each.claim, each.line, "sampled", f"the same at {len(places[letters[0]])} points"
        )


class RowByRow:
    """Claims about a problem with tables: what does not hold for all values of the columns at once is settled for each row by itself."""

    def __init__(self, problem: Problem, conditions: tuple[Relation, ...], variants: int) -> None:
        self.rows = [Settling(Box(row, conditions), variants, vacuous=True) for row in row_by_row(problem)]

    def settle(self, each: Obligation, together: Settling) -> Settled:
        """Proven where it is for every row; `together` takes each column by itself, which leaves out no row but has others, too."""
        found = together.settle(each)
        if found.outcome == "proven" or each.somewhere or together.empty:
            return found
        outcomes = list[Settled]()
        for row in self.rows:
            outcomes.append(row.settle(each))
            if outcomes[-1].outcome == "counter-example":
                break
        worst = min(outcomes, key=lambda one: (WORST.index(one.outcome), -one.broken))
        share = sum(one.broken for one in outcomes) / len(outcomes)
        if worst.outcome == "sampled" and each.redrawn and share:
            return replace(worst, by=redrawn_share(share), broken=share)
        return (
            worst if worst.outcome != "proven" else replace(worst, by=hardest(each.by for each in outcomes))
        )


WORST = ("counter-example", "undecided", "sampled", "proven")


def hardest(ways: Iterable[str]) -> str:
    """Of several provers the one to name: what was found by algebra alone needed no other."""
    used = set(ways)
    return next((way for way in ("enumeration", "z3", "subdivision") if way in used), "algebra")


def redrawn_share(share: float) -> str:
    return f"{REDRAWN} ({100 * share:.1f} % of the draws at most)"
