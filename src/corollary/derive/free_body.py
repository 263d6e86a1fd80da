"""Statements of an author on the forces on a body; generic as the other statements are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic

from corollary.derive.statements import Expression, LawT, Statement

if TYPE_CHECKING:  # as in statements
    import sympy


@dataclass(frozen=True, slots=True)
class Acting(Generic[Expression]):
    """A force on a body: the letter of its name, its magnitude, and where it points, in a word or as an angle. Once solved
    that is an angle, and `word` what the author said."""

    letter: str
    magnitude: Expression
    way: str | Expression
    word: str = ""


@dataclass(frozen=True, slots=True)
class Along(Generic[LawT]):
    """A law about the components of forces along a direction."""

    way: str | sympy.Expr
    law: LawT


@dataclass(frozen=True, slots=True)
class Forces(Generic[Expression, LawT]):
    """All forces on a body; along each direction of `balances` they add up to what the law there says. `mistakes` say why others
    do not act, by their letters. Once solved, all is in givens, directions are angles, and `slope` is that of the part."""

    statement: Statement
    forces: tuple[Acting[Expression], ...]
    balances: tuple[Along[LawT], ...]
    mistakes: Mapping[str, str]
    slope: Expression | None = None
