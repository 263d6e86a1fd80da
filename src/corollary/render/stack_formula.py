"""Formulas as STACK reads them, which has Maxima compare them."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from corollary.formula.ast import Call, Expr, Number, Relation, children, names, rebuilt, walk
from corollary.formula.text import text

FUNCTIONS: Final = {
    **{name: name for name in ("sqrt", "abs", "sin", "cos", "tan", "asin", "acos", "atan", "exp", "ln")},
    "log10": "lg",
}
"""What STACK calls the functions that it has."""
CONSTANTS: Final = frozenset({"e", "i", "%e", "%i", "%pi", "inf", "infinity"})
"""Letters that are numbers there."""


class NotInStack(ValueError):
    """STACK cannot hold the formula; the sentence says why."""


def stack_formula(tree: Expr) -> str:
    """In Maxima's words, numbers as fractions. Raises NotInStack."""
    for node in walk(tree):
        if isinstance(node, Relation):
            raise NotInStack("the answer is an equation")
        if isinstance(node, Call) and node.function not in FUNCTIONS:
            raise NotInStack(f"STACK has no function {node.function}")
    if letters := sorted(names(tree) & CONSTANTS):
        raise NotInStack(f"STACK takes the letter {', '.join(letters)} for a number")
    return text(_renamed(tree))


def _renamed(tree: Expr) -> Expr:
    below = tuple(map(_renamed, children(tree)))
    match tree:
        case Call(function):
            return Call(FUNCTIONS[function], below)
        case Number():
            return replace(tree, figures=0)
        case _:
            return rebuilt(tree, below)
