"""A derivation once solved: formulas that can be replayed on any numbers, with no algebra left to do."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property, wraps
from typing import Any, Concatenate, ParamSpec, TypeVar

from corollary.derive.statements import (
    Choice,
    Code,
    Example,
    Explain,
    Forces,
    Mistake,
    Neglected,
    Plot,
    Printed,
    Proof,
    Route,
    Sentence,
    Statement,
    Supposed,
)
from corollary.formula.ast import Expr, Relation, names
from corollary.formula.ball import RationalPi, Undefined, holds
from corollary.problem.problem import Problem
from corollary.units.dimensional_analysis import Dimension

P = ParamSpec("P")
R = TypeVar("R")


@dataclass(frozen=True, slots=True)
class Numbering:
    """The whole numbers from `low` to `high` by their letter; these are formulas of givens and earlier unknowns, `ends` the same in
    givens alone (None: simulated)."""

    letter: str
    low: Expr
    high: Expr
    ends: tuple[Expr, Expr] | None


@dataclass(frozen=True, slots=True)
class ClosedForms:
    """Unknowns as formulas, one for each component, of givens and earlier unknowns.

    Of a list with an entry for each whole number of a range, `form` has the letter of its `numbering` in it, and `trees` are the
    entries for the numbers at hand; for others the list may be longer or shorter.
    """

    trees: tuple[Expr, ...]
    form: Expr | None = None
    numbering: Numbering | None = None


@dataclass(frozen=True, slots=True)
class SceneOutcome:
    """Unknowns as the outcome of a ready-made scene; the settings are formulas of givens and earlier unknowns.

    The scene is one of the bank in the folder `bank`, or of the chapter's.
    `runs` are what runs gave, by the values of the settings, for where no scene can be run (None: they are not kept).
    """

    scene: str
    settings: Mapping[str, Expr]
    observe: str
    runs: dict[tuple[float, ...], tuple[float, ...]] | None = None
    bank: str = ""


Rule = ClosedForms | SceneOutcome


@dataclass(frozen=True, slots=True)
class AppliedLaw:
    """A law as the textbook has it, and in the letters of the problem (`here`: one equation for each component)."""

    name: str
    source: str
    holds: str
    textbook: Relation
    vectors: frozenset[str]
    here: tuple[Relation, ...]


@dataclass(frozen=True, slots=True)
class SolvedRoute:
    """Another way to an unknown, and the rule it leads to."""

    stated: Route[AppliedLaw]
    rule: Rule


@dataclass(frozen=True, slots=True)
class SolvedFunction:
    """A function that the laws of a step fix, such as v(t): its formula in its own letter, in givens and in earlier unknowns.

    `form` is the kind of differential equation it solves ("": none); `dimensions` those of the function and of its letter, where known;
    `printed` is the formula as a worked solution prints it.
    """

    name: str
    letter: str
    formula: Expr
    form: str
    dimensions: Mapping[str, Dimension]
    printed: Expr | None = None


@dataclass(frozen=True, slots=True)
class OtherRoot:
    """A root of a step's laws that is not meant, in givens, by the letters found (`values`; empty where it is not real, or no
    formula), and whether the author rejects it in words (`worded`) rather than by a condition."""

    values: Mapping[str, Expr]
    worded: bool


@dataclass(frozen=True, slots=True)
class Unknown:
    """Something found (one name for each component). `local` computes it from givens and earlier unknowns.

    `in_givens` computes it from givens alone (None: simulated); `rejected` says why each other root is not meant; `note` how an
    extremum was found. `where` are the conditions on the root that is meant (None: not relations), `others` the roots that are
    not, `aside` what the laws needed besides, in givens. `printed` and `printed_in_givens` are the formulas as a worked solution prints
    them (empty: not chosen). `slope` is the derivative that vanishes at an extremum, as it is written and worked out.
    Of a list with an entry for each whole number of a range, `numbering` is that range, and
    `entries` are its entries for the numbers at hand (none: its formulas have the range's letter in them).
    """

    statement: Statement
    names: tuple[str, ...]
    laws: tuple[AppliedLaw, ...]
    local: Rule
    in_givens: tuple[Expr, ...] | None
    routes: tuple[SolvedRoute, ...]
    mistakes: tuple[Mistake[Rule], ...]
    rejected: tuple[Sentence, ...]
    dimensions: tuple[Dimension, ...]
    scale: Expr | None
    note: Sentence | None
    functions: tuple[SolvedFunction, ...] = ()
    where: tuple[Relation, ...] | None = ()
    others: tuple[OtherRoot, ...] = ()
    aside: Mapping[str, Expr] = field(default_factory=dict[str, Expr])
    printed: tuple[Expr, ...] = ()
    printed_in_givens: tuple[Expr, ...] | None = None
    numbering: Numbering | None = None
    entries: tuple[Unknown, ...] = ()
    slope: tuple[Expr, Expr] | None = None

    @property
    def part(self) -> str:
        """The part it answers; "" for one that nobody asks about."""
        return self.statement.part


@dataclass(frozen=True, slots=True)
class SupposedValue:
    """A supposed value in SI."""

    stated: Supposed
    ratio: Fraction
    dimension: Dimension


Ways = tuple[tuple[Relation, ...], ...]
"""A condition as the ways in which it can hold, of which no two hold for the same numbers: the relations of each. None: it never
holds; one without relations: it always does."""
SolvedChoice = Choice[Ways]
SolvedForces = Forces[Expr, AppliedLaw]
SolvedExample = Example[str, Expr, AppliedLaw]
SolvedProof = Proof[AppliedLaw]
SolvedNeglected = Neglected[Unknown, SupposedValue]
Unsolved = Code | Plot | Explain | Printed  # entries that are used as they stand


@dataclass(frozen=True, slots=True)
class Way:
    """A way to a part that the author did not take: its components in givens and the letters of the `earlier` parts."""

    earlier: tuple[str, ...]
    trees: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Regime:
    """What is true in one case: `text` names it, `conditions` on the givens say when, at `line` of the solution. A case that can hold in
    several ways has a regime for each; `place` is that of the case among the cases."""

    text: str
    conditions: tuple[Relation, ...]
    line: int
    solution: Solution
    place: int


@dataclass(frozen=True, slots=True)
class ClaimedCondition:
    """What holds for all numbers, as the statement has it in words; the claim is at `line` of the solution. Of each condition, on
    givens, one relation holds at least."""

    words: str
    conditions: tuple[tuple[Relation, ...], ...]
    line: int


@dataclass(frozen=True)
class Solution:
    """All that is true of a problem; `unknowns` in the order in which they are found, choices and the like by part.

    `paths` are the ways to each part from the student's own answers to those asked before it. Where there are `regimes`, it is
    the first of them; `case` is the text of the one it is, `conditions` are those under which it holds, and `decided_by` the
    same as stated. `meanings` say what letters stand for, where the author does. Where a list has a length that depends on the
    numbers, `template` has its formulas in the letter of its range, and there is a regime for each length that was met.
    """

    problem: Problem
    unknowns: tuple[Unknown, ...]
    choices: Mapping[str, SolvedChoice]
    examples: Mapping[str, SolvedExample]
    proofs: Mapping[str, SolvedProof]
    entries: tuple[Unsolved, ...]
    neglected: tuple[SolvedNeglected, ...] = ()
    paths: Mapping[str, tuple[Way, ...]] = field(default_factory=dict[str, tuple[Way, ...]])
    regimes: tuple[Regime, ...] = ()
    case: str = ""
    forces: Mapping[str, SolvedForces] = field(default_factory=dict[str, SolvedForces])
    always: tuple[ClaimedCondition, ...] = ()
    meanings: Mapping[str, str] = field(default_factory=dict[str, str])
    conditions: tuple[Relation, ...] = ()
    template: Solution | None = None
    decided_by: tuple[Relation, ...] = ()

    @cached_property
    def results(self) -> dict[Hashable, Any]:
        """What functions made `once` gave for it."""
        return {}

    def regimes_at(self, givens: Mapping[str, RationalPi]) -> list[Regime]:
        """The regimes whose conditions hold for these numbers."""
        return [each for each in self.regimes if all(holds(one, givens) for one in each.conditions)]

    def at(self, givens: Mapping[str, RationalPi]) -> Solution:
        """What is true for these numbers in their case. Raises Undefined when it is not exactly one of the regimes that holds."""
        if not self.regimes:
            return self
        found = self.regimes_at(givens)
        if len(found) != 1:
            which = f" ({', '.join(each.text for each in found)})" if found else ""
            raise Undefined(f"{len(found) or 'none'} of the cases hold{which}; exactly one must")
        return found[0].solution

    def answer(self, part: str) -> Unknown | None:
        """What answers a part."""
        return next((find for find in self.unknowns if find.part == part), None)


def dependent(solution: Solution) -> set[str]:
    """The unknowns that are numbered, or depend on a variable, and those made of them."""
    variables = {each.symbol for each in solution.problem.variables}
    found: set[str] = set()
    for find in solution.unknowns:
        local = names(*find.local.trees) if isinstance(find.local, ClosedForms) else set[str]()
        if find.numbering or (local | names(*(find.in_givens or ()))) & (variables | found):
            found |= {*find.names}
    return found


def once(work: Callable[Concatenate[Solution, P], R]) -> Callable[Concatenate[Solution, P], R]:
    """A function of a solution, and of what can be hashed, whose results are kept with the solution and go when it goes."""

    @wraps(work)
    def recalled(solution: Solution, /, *arguments: P.args, **named: P.kwargs) -> R:
        key = work, arguments, *named.items()
        if key not in solution.results:
            solution.results[key] = work(solution, *arguments, **named)
        return solution.results[key]

    return recalled
