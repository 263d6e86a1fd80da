"""An obligation: a claim about all numbers a problem can deal, what would show it, and how it was settled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from corollary.formula.ast import Expr, Relation

Outcome = Literal["proven", "counter-example", "sampled", "undecided"]
Kind = Literal[
    "laws hold", "value exists", "no step", "one root", "not zero", "not created", "one case", "mistake apart", "mistakes differ",
    "claimed sign", "claimed",
]  # fmt: skip
Clause = tuple[Relation, ...]
"""Relations of which one must hold at least."""
REDRAWN = "redrawn otherwise"  # how what is checked whenever numbers are dealt is settled
NO_NUMBERS: Mapping[str, str] = {}


@dataclass(frozen=True, slots=True)
class Equations:
    """Equations in givens and in `unknowns`, of which only the root `meant` may fulfil all (and the conditions `where`);
    `rejected` are roots that the author rejects in words, `others` those that break a condition."""

    laws: tuple[Relation, ...]
    unknowns: tuple[str, ...]
    meant: Mapping[str, Expr]
    rejected: tuple[Mapping[str, Expr], ...]
    where: tuple[Relation, ...]
    others: tuple[Mapping[str, Expr], ...] = ()


@dataclass(frozen=True, slots=True)
class Obligation:
    """All of `needs` must hold for all givens of the grid that keep the problem's conditions; a need without a value does not hold.

    `equations`: and these have no other root. `partial`: of each of their `others` what must hold wherever it has a value.
    `formulas`: what has no value where a need fails. `redrawn`:
    numbers for which it does not hold are never dealt. `somewhere`: one point where it holds is enough, for formulas differ
    if they do at one. `open` says why nothing can be proven, where no formula states the claim, and
    `tried` whether numbers were put in all the same. `line` is that of the solution.
    """

    kind: Kind
    claim: str
    line: int
    needs: tuple[Clause, ...] = ()
    equations: Equations | None = None
    partial: tuple[Clause, ...] = ()
    formulas: tuple[Expr, ...] = ()
    redrawn: bool = False
    open: str = ""
    tried: bool = True
    somewhere: bool = False


@dataclass(frozen=True, slots=True)
class Settled:
    """How an obligation was settled: proven by a prover, refuted by numbers, sampled at some, or not decided. `by` is the prover, or what
    was sampled; a counter-example has its `numbers`, in the units of the givens, and the condition that would exclude it. `broken` is the
    share of draws it fails for, of those tried; `case` is the one it is claimed in, where there are several."""

    kind: Kind
    claim: str
    line: int
    outcome: Outcome
    by: str
    numbers: Mapping[str, str] = field(default_factory=lambda: NO_NUMBERS)
    exclude: str = ""
    broken: float = 0.0
    case: str = ""
