"""A derivation once solved: plain formulas, replayable on any numbers, with no algebra left to do."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from corollary.derive.statements import Entry
from corollary.formula.ast import Expr, Relation
from corollary.problem.problem import Problem
from corollary.units.dimensions import Dimension


@dataclass(frozen=True, slots=True)
class ClosedForms:
    """A find as formulas, one for each component, of givens and earlier finds."""

    trees: tuple[Expr, ...]


@dataclass(frozen=True, slots=True)
class Measured:
    """A find as the outcome of a scene; the settings are formulas of givens and earlier finds."""

    scene: str
    settings: Mapping[str, Expr]
    observe: str


Rule = ClosedForms | Measured


@dataclass(frozen=True, slots=True)
class WrongRule:
    """How a mistake computes the find, and what the student is told."""

    text: str
    rule: Rule


@dataclass(frozen=True, slots=True)
class LawShown:
    """A law as the worked solution shows it: the textbook's form, and in the letters of the problem (one for each component)."""

    name: str
    source: str
    holds: str
    textbook: Relation
    vectors: frozenset[str]
    here: tuple[Relation, ...]


@dataclass(frozen=True, slots=True)
class RouteShown:
    because: str
    laws: tuple[LawShown, ...]


@dataclass(frozen=True, slots=True)
class SolvedUnknown:
    """One thing found. `local` and `routes` compute it from givens and earlier finds, `closed` from givens alone (None: simulated)."""

    names: tuple[str, ...]
    answers: str
    because: str
    laws: tuple[LawShown, ...]
    local: Rule
    closed: tuple[Expr, ...] | None
    routes: tuple[Rule, ...]
    routes_shown: tuple[RouteShown, ...]
    mistakes: tuple[WrongRule, ...]
    rejected: tuple[str, ...]
    dimensions: tuple[Dimension, ...]
    scale: Expr | None
    check: str
    note: str


@dataclass(frozen=True, slots=True)
class ChoiceTruth:
    options: Mapping[str, Relation | bool]
    because: str
    mistakes: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class ExampleTruth:
    """Laws that a good example keeps, the values it must not be, and one good example (None when none was found)."""

    names: tuple[str, ...]
    laws: tuple[LawShown, ...]
    apart: tuple[tuple[tuple[Expr, ...], str], ...]
    scale: Expr
    because: str
    free: int
    instance: tuple[Expr, ...] | None


@dataclass(frozen=True, slots=True)
class ProofTruth:
    """True equations to start from, the one to arrive at, and wrong equations a student may write, all in finds and givens."""

    laws: tuple[LawShown, ...]
    target: Relation
    lines: tuple[str, ...]
    wrong: tuple[tuple[Relation, str], ...]
    because: str


@dataclass(frozen=True, slots=True)
class SupposedValue:
    """A value the problem does not give: in SI, and as the author wrote it."""

    name: str
    ratio: Fraction
    dimension: Dimension
    text: str
    why: str


@dataclass(frozen=True, slots=True)
class LeftOut:
    """What an answer neglects, and how to find the most it can change; `bound` answers the part whose answer it is about."""

    what: str
    bound: SolvedUnknown
    supposing: tuple[SupposedValue, ...]
    asked: bool


@dataclass(frozen=True, slots=True)
class Solution:
    """All that is true of a problem. `entries` are those that need no solving: code, plot, explain, printed."""

    problem: Problem
    finds: tuple[SolvedUnknown, ...]
    choices: Mapping[str, ChoiceTruth]
    examples: Mapping[str, ExampleTruth]
    proofs: Mapping[str, ProofTruth]
    entries: tuple[Entry, ...]
    neglected: tuple[LeftOut, ...] = ()

    def answer(self, part: str) -> SolvedUnknown | None:
        """The find that answers a part."""
        return next((find for find in self.finds if find.answers == part), None)
