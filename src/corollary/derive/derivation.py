"""A derivation: all that an author states of a problem, in order."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from corollary.derive.free_body import Forces
from corollary.derive.statements import (
    Choice,
    Code,
    Confirm,
    Example,
    Explain,
    Neglected,
    Optimum,
    Plot,
    Printed,
    Proof,
    Simulated,
    StatedChoice,
    StatedExample,
    StatedNeglected,
    StatedProof,
    Statement,
    Step,
)

if TYPE_CHECKING:  # as in statements
    import sympy
    from sympy.logic.boolalg import Boolean

    from corollary.laws.law import Law  # noqa: F401  (named in a text below)


@dataclass(frozen=True, slots=True)
class Limit:
    """What something found comes to when a given goes to its limit."""

    statement: Statement
    of: sympy.Expr
    letter: sympy.Symbol
    to: sympy.Expr
    equals: sympy.Expr


@dataclass(frozen=True, slots=True)
class Special:
    """What is found in a special case: values of givens and, with these, of unknowns, by their letters."""

    statement: Statement
    values: Mapping[str, sympy.Expr]


@dataclass(frozen=True, slots=True)
class Always:
    """What the statement says in words of every variant, as a condition on what is given and found."""

    statement: Statement
    condition: Boolean | bool | str


StatedForces = Forces["sympy.Expr", "Law"]
Asserted = Limit | Special | Confirm
Solved = (
    Step | Optimum | Simulated | StatedChoice | StatedForces | StatedExample | StatedProof | StatedNeglected
)
Entry = Solved | Code | Plot | Explain | Printed | Asserted | Always
ENTRIES = (Step, Optimum, Simulated, Choice, Forces, Example, Proof, Neglected, Code, Plot, Explain, Printed, Limit, Special, Confirm, Always)  # fmt: skip


@dataclass(frozen=True, slots=True)
class Derivation:
    """The entries in the order in which they are found."""

    entries: tuple[Entry, ...]
