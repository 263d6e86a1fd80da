"""Formulas and equations with numbers in them: the value as a double, and whether both sides agree."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from fractions import Fraction

from corollary.formula.ast import Expr, Negative, Product, Quotient, Relation, Sum
from corollary.formula.ball import (
    Ball,
    RationalPi,
    Undefined,
    ball_at,
    evaluate,
    in_balls,
    precision_of,
)

Letters = Mapping[str, RationalPi] | Mapping[str, Ball]
BITS = 96  # the double comes out right to its last bit but where more than 40 bits cancel


def number(tree: Expr, values: Letters) -> float:
    """A formula's value as a double, close to the last bit. Raises Undefined."""
    return _finite(float(evaluate(tree, values, BITS).mid()))


def numbers(trees: Iterable[Expr], values: Mapping[str, Ball]) -> tuple[float, ...]:
    """As `number`, of several formulas, where the precision is set to BITS already. Raises Undefined."""
    return tuple([_finite(float(ball_at(tree, values).mid())) for tree in trees])


def balls(values: Letters) -> dict[str, Ball]:
    """The values ready for many formulas."""
    return in_balls(values, BITS)


def ball_of(value: float) -> Ball:
    """The double itself. Raises Undefined for what is no number."""
    return Ball(_finite(value))


def as_exact(value: float) -> RationalPi:
    """The double itself. Raises Undefined for what is no number."""
    return RationalPi(Fraction(_finite(value)))


def holds_nearly(relation: Relation, values: Mapping[str, RationalPi], tolerance: float) -> bool:
    """Whether both sides agree, to the tolerance of what is added up on them before anything cancels. Raises Undefined.

    Compared as balls, whose exponents have no bounds: as doubles, tiny numbers would be 0 on both sides and so agree.
    """
    with precision_of(BITS):
        left, right = _ball(relation.left, values), _ball(relation.right, values)
        size = _size(relation.left, values).max(_size(relation.right, values))
        return bool(abs(left.mid() - right.mid()).mid() <= (Ball(tolerance) * size).mid())


def _finite(value: float) -> float:
    if not math.isfinite(value):
        raise Undefined("the value is beyond the numbers of this machine")
    return value


def _ball(tree: Expr, values: Mapping[str, RationalPi]) -> Ball:
    ball = evaluate(tree, values, BITS)
    if not ball.is_finite():
        raise Undefined("no value could be worked out: too large, or at a point where it jumps")
    return ball


def _size(tree: Expr, values: Mapping[str, RationalPi]) -> Ball:
    """The value with every subtraction made an addition: how large the terms are."""
    match tree:
        case Negative(term):
            return _size(term, values)
        case Sum(terms):
            return sum((_size(term, values) for term in terms), Ball(0))
        case Product(factors):
            return math.prod((_size(factor, values) for factor in factors), start=Ball(1))
        case Quotient(top, bottom):
            size = _size(top, values) / abs(_ball(bottom, values))
            if not size.is_finite():
                raise Undefined("a divisor cannot be told from zero")
            return size
        case _:
            return abs(_ball(tree, values))
