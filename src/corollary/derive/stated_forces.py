"""The words in which an author states the forces on a body."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from corollary.derive.free_body import Acting, Along, Forces
from corollary.derive.spoken import line_of_word
from corollary.derive.statements import Statement
from corollary.formula.authored import as_expression
from corollary.laws.law import Law, only_laws

if TYPE_CHECKING:
    import sympy


def forces(
    part: str,
    because: str,
    *acting: Acting[sympy.Expr],
    laws: Sequence[Along[Law]],
    mistakes: Mapping[str, str] | None = None,
) -> Forces[sympy.Expr, Law]:
    """All forces on a body, held against the laws that mention it; `mistakes` say why other options do not act on it."""
    return Forces(Statement(part, because, line_of_word()), acting, tuple(laws), mistakes or {})


def force(option: str, magnitude: object, way: object) -> Acting[sympy.Expr]:
    """A force by the letter of its option; it points `way`: "down", "up the slope", or an angle from the right.

    A negative magnitude turns it round, and with none it does not act.
    """
    return Acting(option, as_expression(magnitude), way if isinstance(way, str) else as_expression(way))


def along(way: object, law: Law) -> Along[Law]:
    """A law about the components of the forces along a direction."""
    (stated,) = only_laws((law,))
    return Along(way if isinstance(way, str) else as_expression(way), stated)
