"""Proofs by algebra: a claim as a quotient of polynomials, whose sign is that of its factors within the bounds of the letters."""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from corollary.formula.ast import Call, Expr, Name, Relation
from corollary.formula.ball import evaluate
from corollary.formula.errors import Undefined
from corollary.formula.rational_pi import RationalPi
from corollary.polynomials.polynomial import RationalFunction, TooLarge
from corollary.polynomials.polynomial_signs import Bounds
from corollary.polynomials.translate import POSITIVE, Translation, sign_by_factors
from corollary.verify.obligations.box import PI, Box

MOST_TERMS = 120  # of a product: factors of more take longer than all other provers together


class Algebra:
    """Relations of one box in one context of letters; those made for sines and roots have what bounds are known."""

    def __init__(self, box: Box, relations: Iterable[Relation], free: Iterable[Expr] = ()) -> None:
        trees: list[Expr] = [*relations, *free]
        known: dict[str, Bounds] = {name: axis.bounds for name, axis in box.axes.items()}
        known |= dict.fromkeys(box.above_zero, POSITIVE)
        self.translation = Translation(trees, known)
        self.translation.known["pi"] = self.translation.seen["pi"] = PI
        self.box = box

    def gap(self, need: Relation) -> RationalFunction:
        """Left side less right side. Raises TooLarge, and Undefined where something is divided by zero."""
        found = self.translation.fraction(need.left) - self.translation.fraction(need.right)
        self._bound_angles()
        return found

    def _bound_angles(self) -> None:
        for meaning, letter in self.translation.meanings.items():
            name = str(letter.top)
            if meaning[0] in ("sin", "cos") and self.translation.known[name] == (None, None):
                bounds = Fraction(-1), Fraction(1)
                if (axis := self.box.axes.get(meaning[2])) is not None:
                    ends = [Fraction(meaning[1]) * each for each in axis.bounds]
                    low, high = (evaluate(Name("x"), {"x": RationalPi(each)}, 64) for each in ends)
                    ball = evaluate(Call(meaning[0], (Name("x"),)), {"x": low.union(high)}, 64)
                    bounds = _below(ball.lower()), -_below(-ball.upper())
                self.translation.known[name] = self.translation.seen[name] = bounds

    def holds(self, need: Relation) -> bool:
        """Whether the signs of the factors show the relation, for all numbers of the box for which both sides have a value: a factor that
        cancels is not seen."""
        try:
            gap = self.gap(need)
        except (TooLarge, Undefined, KeyError):
            return False
        if gap.top.is_zero():
            return need.sign in ("=", "<=", ">=")
        sign = self.sign(gap.top) * self.sign(gap.bottom)
        return {"<": sign < 0, "<=": sign < 0, ">": sign > 0, ">=": sign > 0, "!=": sign != 0, "=": False}[
            need.sign
        ]

    def sign(self, polynomial: Any) -> int:
        return sign_by_factors(polynomial, self.translation.known) if len(polynomial) <= MOST_TERMS else 0


def _below(ball: Any) -> Fraction:
    """A fraction below the ball's value, to nine figures."""
    return Fraction(math.floor(float(ball) * 1e9) - 1, 10**9)
