"""Angles in degrees: which numbers of a formula they are, and what they are in radians."""

from __future__ import annotations

from fractions import Fraction

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
    names,
)
from corollary.formula.functions import ANGLE_IN

DEGREE = Quotient(Name("pi"), Number(Fraction(180)))


def degrees(number: Expr) -> Expr:
    """So many degrees, as an angle."""
    return Product((number, DEGREE))


def in_degrees(tree: Expr) -> Expr:
    """The formula with the bare numbers inside sin, cos and tan taken as degrees; letters stand for angles themselves."""
    match tree:
        case Call(function, arguments):
            inner = tuple(in_degrees(argument) for argument in arguments)
            return Call(function, tuple(map(_angle, inner)) if function in ANGLE_IN else inner)
        case Negative(term):
            return Negative(in_degrees(term))
        case Sum(terms):
            return Sum(tuple(map(in_degrees, terms)))
        case Product(factors):
            return Product(tuple(map(in_degrees, factors)))
        case Quotient(top, bottom):
            return Quotient(in_degrees(top), in_degrees(bottom))
        case Power(base, exponent):
            return Power(in_degrees(base), in_degrees(exponent))
        case Relation(sign, left, right):
            return Relation(sign, in_degrees(left), in_degrees(right))
        case _:
            return tree


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
