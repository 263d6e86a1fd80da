"""Signs of givens as the conditions of their problem imply them; sympy simplifies by them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from corollary.formula.ast import ZERO, Expr, Name, Number
from corollary.problem.problem import Problem

if TYPE_CHECKING:  # a solution that is in the cache is used without it
    import sympy

ABOVE, BELOW = {1: "positive", 0: "nonnegative"}, {1: "negative", 0: "nonpositive"}


def symbol_of(problem: Problem, name: str) -> sympy.Symbol:
    """A given or a variable as a symbol; it is positive (or not negative, …) when the `require:` of the problem say so, `0 < a < b` of both."""
    import sympy  # only here: see above

    known: dict[str, bool] = {}
    pairs = list(_in_order(problem))
    if (strict := _beyond_zero(pairs, name)) is not None:
        known[ABOVE[strict]] = True
    turned = [(more, less, strict) for less, more, strict in pairs]
    if (strict := _beyond_zero(turned, name)) is not None:
        known[BELOW[strict]] = True
    return sympy.Symbol(name, real=True, **known)


def _in_order(problem: Problem) -> Iterator[tuple[Expr, Expr, int]]:
    """The smaller and the larger side of each condition that holds everywhere, and 1 where they are never equal."""
    for each in problem.variables:
        if each.first >= 0 and not each.unit.offset:
            yield ZERO, Name(each.symbol), int(each.above or each.first > 0)
        elif each.last <= 0 and not each.unit.offset:
            yield Name(each.symbol), ZERO, int(each.last < 0)
    for condition in problem.conditions:
        left, right, sign = condition.relation.left, condition.relation.right, condition.relation.sign
        if condition.hard and sign in ("<", "<=", ">", ">="):
            yield (left, right, len(sign) == 1) if sign[0] == "<" else (right, left, len(sign) == 1)


def _beyond_zero(pairs: list[tuple[Expr, Expr, int]], name: str) -> int | None:
    """1 where the letter is on the far side of a chain of conditions that begins at zero, 0 where it may be zero itself."""
    best: dict[str, int] = {}
    for _round in pairs:
        for near, far, strict in pairs:
            match near, far:
                case Number(value), Name(letter) if value == 0:
                    start = 0
                case Name(other), Name(letter) if other in best:
                    start = best[other]
                case _:
                    continue
            best[letter] = max(best.get(letter, 0), start, int(strict))
    return best.get(name)
