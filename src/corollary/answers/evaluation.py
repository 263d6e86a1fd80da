"""Formulas and equations with numbers in them: the value as a double, and whether both sides agree."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from fractions import Fraction

from corollary.formula.ast import Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
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
    return finite_double(evaluate(tree, values, BITS))


def numbers(trees: Iterable[Expr], values: Mapping[str, Ball]) -> tuple[float, ...]:
    """As `number`, of several formulas, where the precision is set to BITS already. Raises Undefined."""
    return tuple([_finite(float(ball_at(tree, values).mid())) for tree in trees])


def finite_double(ball: Ball) -> float:
    """The double next to a ball's middle. Raises Undefined for what is no number."""
    return _finite(float(ball.mid()))


def balls(values: Letters) -> dict[str, Ball]:
    """The values ready for many formulas."""
    return in_balls(values, BITS)


def ball_of(value: float) -> Ball:
    """The double itself. Raises Undefined for what is no number."""
    return Ball(_finite(value))


def as_exact(value: float) -> RationalPi:
    """The double itself. Raises Undefined for what is no number."""
    return RationalPi(Fraction(_finite(value)))


def holds_nearly(
    relation: Relation,
    values: Mapping[str, RationalPi],
    tolerance: float,
    sizes: Mapping[str, float] | None = None,
) -> bool:
    """Whether both sides agree, to the tolerance of what is added up on them before anything cancels. Raises Undefined.

    Compared as balls, whose exponents have no bounds: as doubles, tiny numbers would be 0 on both sides and so agree.
    `sizes` are those of letters that stand for formulas; then what is divided by must be larger than the tolerance, too.
    """
    with precision_of(BITS):
        left, right = _ball(relation.left, values), _ball(relation.right, values)
        terms = _Terms(values, sizes or {}, 0.0 if sizes is None else tolerance)
        size = terms.size(relation.left).max(terms.size(relation.right))
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


def size_of(tree: Expr, values: Mapping[str, RationalPi], sizes: Mapping[str, float]) -> float:
    """How large the terms of a formula are, to be handed to `holds_nearly`. Raises Undefined."""
    with precision_of(BITS):
        return _finite(float(_Terms(values, sizes, 0.0).size(tree).mid()))


@dataclass(frozen=True, slots=True)
class _Terms:
    """How large the terms of formulas are at these values."""

    values: Mapping[str, RationalPi]
    sizes: Mapping[str, float]
    smallest: float

    def size(self, tree: Expr) -> Ball:
        """The value with every subtraction made an addition. Raises Undefined."""
        match tree:
            case Name(name) if name in self.sizes:
                return Ball(self.sizes[name])
            case Negative(term):
                return self.size(term)
            case Sum(terms):
                return sum((self.size(term) for term in terms), Ball(0))
            case Product(factors):
                return math.prod((self.size(factor) for factor in factors), start=Ball(1))
            case Quotient(top, bottom):
                divisor = abs(_ball(bottom, self.values))
                size = self.size(top) / divisor
                if not size.is_finite() or (
                    self.smallest and divisor.mid() <= (Ball(self.smallest) * self.size(bottom)).mid()
                ):
                    raise Undefined("a divisor cannot be told from zero")
                return size
            case Power(base, Number(exponent)) if self.smallest and exponent > 0:
                return self.size(base) ** (Ball(exponent.numerator) / exponent.denominator)
            case _:
                return abs(_ball(tree, self.values))
