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
    children,
    names,
    rebuilt,
)
from corollary.formula.functions import FUNCTIONS

DEGREE = Quotient(Name("pi"), Number(Fraction(180)))


def degrees(number: Expr) -> Expr:
    """So many degrees, as an angle."""
    return Product((number, DEGREE))


def in_degrees(tree: Expr) -> Expr:
    """The formula with the bare numbers inside sin, cos and tan taken as degrees; letters stand for angles themselves."""
    below = tuple(map(in_degrees, children(tree)))
    if isinstance(tree, Call) and FUNCTIONS[tree.function].angle:
        return Call(tree.function, tuple(map(_angle, below)))
    return rebuilt(tree, below)


def _angle(tree: Expr) -> Expr:
    """`30`, `90 - theta`, `(180 - theta)/2`: a part without letters is in degrees, one with pi is in radians already."""
    if not names(tree):
        return degrees(tree)
    match tree:
        case Negative(term):
            return Negative(_angle(term))
        case Sum(terms):
            return Sum(tuple(map(_angle, terms)))
        case Quotient(top, bottom) if not names(bottom):
            return Quotient(_angle(top), bottom)
        case Product(factors) if sum(bool(names(factor)) for factor in factors) == 1:
            return Product(tuple(_angle(factor) if names(factor) else factor for factor in factors))
        case _:
            return tree
