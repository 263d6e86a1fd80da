"""A formula worked out by hand: every intermediate result is written down rounded, and what follows goes on from that."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import assert_never

from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import (
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    children,
    names,
)
from corollary.formula.exact import constant
from corollary.formula.functions import FUNCTIONS

ByHand = Callable[[Sequence[float]], float]


def by_operations(tree: Expr, places: Mapping[str, int], rounded: Callable[[float], float]) -> ByHand:
    """The formula as a function of its letters' doubles, each at its place, with everything below its last operation rounded.

    What has no letter is exact, and so are the letters themselves; a sum or a product is one operation, however many terms it
    has. The function raises ValueError, ZeroDivisionError or OverflowError where the formula has no value.
    """
    if _exact(tree):
        number = float(ready(tree, DOUBLES)({}))
        return lambda at: number
    match tree:
        case Name(name):
            place = places[name]
            return lambda at: at[place]
        case Negative(term):
            inner = by_operations(term, places, rounded)
            return lambda at: -inner(at)
        case Sum(terms):
            added = [_below(term, places, rounded) for term in terms]
            return lambda at: math.fsum([term(at) for term in added])
        case Product(factors):
            multiplied = [_below(factor, places, rounded) for factor in factors]
            return lambda at: math.prod([factor(at) for factor in multiplied])
        case Quotient(top, bottom):
            above, below = (_below(each, places, rounded) for each in (top, bottom))
            return lambda at: above(at) / below(at)
        case Power(base, exponent):
            return _power(_below(base, places, rounded), exponent, places, rounded)
        case Call(function, arguments):
            apply = FUNCTIONS[function].double
            inside = [_below(argument, places, rounded) for argument in arguments]
            return lambda at: apply(*[each(at) for each in inside])
        case Number() | Relation():
            raise ValueError("a comparison has no number as its value")
        case _:
            assert_never(tree)


def _below(tree: Expr, places: Mapping[str, int], rounded: Callable[[float], float]) -> ByHand:
    """An operand, rounded where it is worked out at all."""
    if isinstance(tree, Negative):
        inner = _below(tree.term, places, rounded)
        return lambda at: -inner(at)
    step = by_operations(tree, places, rounded)
    return (lambda at: rounded(step(at))) if children(tree) and not _exact(tree) else step


def _power(
    base: ByHand, exponent: Expr, places: Mapping[str, int], rounded: Callable[[float], float]
) -> ByHand:
    fixed = constant(exponent)
    if fixed is not None and fixed.denominator == 1:
        whole = fixed.numerator
        return lambda at: base(at) ** whole
    above = _below(exponent, places, rounded)
    return lambda at: math.pow(base(at), above(at))


def _exact(tree: Expr) -> bool:
    return not names(tree) - {"pi"}
