"""Angles in degrees: which numbers of a formula they are, and what they are in radians."""

from __future__ import annotations

from fractions import Fraction

from corollary.formula.ast import (
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    map_children,
    names,
)
from corollary.formula.functions import FUNCTIONS

DEGREE = Quotient(Name("pi"), Number(Fraction(180)))


def degrees(number: Expr) -> Expr:
    """So many degrees, as an angle."""
    return Product((number, DEGREE))


def in_degrees(tree: Expr) -> Expr:
    """The formula with the bare numbers inside sin, cos and tan taken as degrees; letters stand for angles themselves."""
    below = map_children(tree, in_degrees)
    if isinstance(below, Call) and FUNCTIONS[below.function].angle:
        return map_children(below, _angle)
    return below


def _angle(tree: Expr) -> Expr:
    """`30`, `90 - theta`, `(180 - theta)/2`: a part without letters is in degrees, one with pi is in radians already."""
    if not names(tree):
        return degrees(tree)
    match tree:
        case Negative() | Sum():
            return map_children(tree, _angle)
        case Quotient(top, bottom) if not names(bottom):
            return Quotient(_angle(top), bottom)
        case Product(factors) if sum(bool(names(factor)) for factor in factors) == 1:
            return Product(tuple(_angle(factor) if names(factor) else factor for factor in factors))
        case _:
            return tree
