"""Formulas and equations with numbers in them: the value as a double, and whether both sides agree."""

from __future__ import annotations

import math
from collections.abc import Mapping
from fractions import Fraction

from corollary.formula.ast import Expr, Negative, Product, Quotient, Relation, Sum
from corollary.formula.ball import RationalPi, Undefined, evaluate

BITS = 96  # the double comes out right to its last bit but where more than 40 bits cancel


def number(tree: Expr, values: Mapping[str, RationalPi]) -> float:
    """A formula's value as a double, close to the last bit. Raises Undefined."""
    return _finite(float(evaluate(tree, values, BITS).mid()))


def as_exact(value: float) -> RationalPi:
    """The double itself. Raises Undefined for what is no number."""
    return RationalPi(Fraction(_finite(value)))


def holds_nearly(relation: Relation, values: Mapping[str, RationalPi], tolerance: float) -> bool:
    """Whether both sides agree, to the tolerance of what is added up on them before anything cancels. Raises Undefined."""
    left, right = number(relation.left, values), number(relation.right, values)
    return abs(left - right) <= tolerance * max(_size(relation.left, values), _size(relation.right, values))


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise Undefined("the value is beyond the numbers of this machine")
    return value


def _size(tree: Expr, values: Mapping[str, RationalPi]) -> float:
    """The value with every subtraction made an addition: how large the terms are."""
    match tree:
        case Negative(term):
            return _size(term, values)
        case Sum(terms):
            return sum(_size(term, values) for term in terms)
        case Product(factors):
            return math.prod(_size(factor, values) for factor in factors)
        case Quotient(top, bottom):
            divisor = abs(number(bottom, values))
            if divisor == 0.0:  # not zero itself, which cannot be evaluated, but below the least double
                raise Undefined("a divisor is smaller than the numbers of this machine")
            return _finite(_size(top, values) / divisor)
        case _:
            return abs(number(tree, values))
