"""Sample points: the numbers at which roots are told apart, and expressions worked out at them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy

from corollary.formula.ast import Expr
from corollary.formula.ball import RationalPi, Undefined, evaluate
from corollary.formula.from_sympy import NoTree, tree
from corollary.laws.substitute import as_expression, put

DIGITS, BITS = 30, 128


@dataclass(frozen=True, slots=True)
class Point:
    """A value for every letter, for sympy and, many times faster, for our own evaluation."""

    values: dict[sympy.Symbol, sympy.Expr]
    balls: dict[str, Any]

    def suppose(self, symbol: sympy.Symbol, ratio: Fraction) -> None:
        """Adds a value that no given has."""
        self.values[symbol] = sympy.Rational(ratio.numerator, ratio.denominator)
        self.balls[symbol.name] = RationalPi(ratio)


def point(givens: Mapping[str, RationalPi], symbols: list[sympy.Symbol]) -> Point:
    """The point of a variant."""
    values = {
        symbol: sympy.Rational(exact.ratio.numerator, exact.ratio.denominator) * sympy.pi**exact.pi
        for symbol in symbols
        for exact in (givens[symbol.name],)
    }
    return Point(values, dict(givens))


def at(expression: object, where: Point) -> Any:
    """The expression's value at a point, to 30 digits; complex, infinite or unsettled as sympy has it where we have none."""
    formula = _tree(as_expression(expression))
    if formula is not None:
        ball = _ball(formula, where, BITS)
        if ball is not None and ball.is_finite() and ball.rel_accuracy_bits() > 100:
            return sympy.Float(ball.str(DIGITS, radius=False), DIGITS)
    return put(as_expression(expression), where.values).evalf(DIGITS)


def learn(where: Point, find: sympy.Symbol, value: sympy.Expr) -> None:
    """Adds the value of a find to a point."""
    where.values[find] = at(value, where)
    formula = _tree(value)
    if formula is not None and (ball := _ball(formula, where, 2 * BITS)) is not None:
        where.balls[find.name] = ball


def _ball(formula: Expr, where: Point, bits: int) -> Any:
    """The value as a ball; None where it has no real value, or a letter has none."""
    try:
        return evaluate(formula, where.balls, bits)
    except (Undefined, KeyError):
        return None


@lru_cache(maxsize=4096)
def _tree(expression: sympy.Expr) -> Expr | None:
    try:
        return tree(expression)
    except NoTree:
        return None
