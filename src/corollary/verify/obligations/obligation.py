"""An obligation: a claim about all numbers a problem can deal, what would show it, and how it was settled."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from corollary.formula.ast import Expr, Relation

Outcome = Literal["proven", "counter-example", "sampled"]
Kind = Literal["laws hold", "value exists", "one root", "not zero", "not created", "one case", "mistake apart", "mistakes differ", "claimed sign", "claimed"]  # fmt: skip
Clause = tuple[Relation, ...]
"""Relations of which one must hold at least."""
OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "=": "!=", "!=": "="}
NO_NUMBERS: Mapping[str, str] = {}


@dataclass(frozen=True, slots=True)
class Equations:
    """Equations in givens and in `unknowns`, of which only the root `meant` may fulfil all (and the conditions `where`);
    `rejected` are roots that the author rejects in words."""

    laws: tuple[Relation, ...]
    unknowns: tuple[str, ...]
    meant: Mapping[str, Expr]
    rejected: tuple[Mapping[str, Expr], ...]
    where: tuple[Relation, ...]


@dataclass(frozen=True, slots=True)
class Obligation:
    """All of `needs` must hold, each where those before it do, for all givens of the grid that keep the problem's conditions.

    `equations`: or these have no other root, which is as good as the needs. `redrawn`: numbers for which it does not hold are
    never dealt. `open` says why nothing can be proven, where no formula states the claim. `line` is that of the solution.
    """

    kind: Kind
    claim: str
    line: int
    needs: tuple[Clause, ...] = ()
    equations: Equations | None = None
    redrawn: bool = False
    open: str = ""


def opposite(relation: Relation) -> Relation:
    """What holds where the relation does not, and both sides have a value."""
    return Relation(OPPOSITE[relation.sign], relation.left, relation.right)


@dataclass(frozen=True, slots=True)
class Settled:
    """How an obligation was settled. `by` is the prover, or what was sampled; a counter-example has its `numbers`, in the
    units of the givens, and the condition that would exclude it. `broken` is the share of draws it fails for, of those tried."""

    kind: Kind
    claim: str
    line: int
    outcome: Outcome
    by: str
    numbers: Mapping[str, str] = field(default_factory=lambda: NO_NUMBERS)
    exclude: str = ""
    broken: float = 0.0
