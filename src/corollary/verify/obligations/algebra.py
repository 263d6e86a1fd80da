"""Proofs by algebra: a claim as a quotient of polynomials, whose sign is that of its factors within the bounds of the letters."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from corollary.formula.ast import Call, Expr, Name, Relation
from corollary.formula.ball import Ball, evaluate
from corollary.formula.errors import Undefined
from corollary.polynomials.polynomial import TooLarge
from corollary.polynomials.rational_function import RationalFunction
from corollary.polynomials.signs import Bounds
from corollary.polynomials.translate import Translation, sign_by_factors
from corollary.verify.obligations.box import PI, Box
from corollary.verify.obligations.obligation import Equations

MOST_TERMS = 120  # of a product: factors of more take longer than all other provers together


class Algebra:
    """Relations of one box in one context of letters; those made for sines and roots have what bounds are known."""

    def __init__(self, box: Box, relations: Iterable[Relation], free: Iterable[Expr] = ()) -> None:
        trees: list[Expr] = [*relations, *free]
        known: dict[str, Bounds] = {name: axis.bounds for name, axis in box.axes.items()}
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
                    low, high = (float(Fraction(meaning[1]) * each) for each in axis.bounds)
                    angle = Ball((low + high) / 2, (high - low) / 2 * (1 + 1e-9) + 1e-12)
                    ball = evaluate(Call(meaning[0], (Name("x"),)), {"x": angle}, 64)
                    bounds = _below(ball.lower()), -_below(-ball.upper())
                self.translation.known[name] = self.translation.seen[name] = bounds

    def holds(self, need: Relation) -> bool:
        """Whether the signs of the factors show the relation, for all numbers of the box."""
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


def linear(box: Box, equations: Equations) -> bool:
    """Whether the equations are linear in their unknowns: then the root that algebra finds is the only one."""
    try:
        algebra = Algebra(box, equations.laws, map(Name, equations.unknowns))
        tops = [algebra.gap(each).top for each in equations.laws]
    except (TooLarge, Undefined, KeyError):
        return False
    context, unknowns = algebra.translation.context, set(equations.unknowns)
    for meaning in algebra.translation.meanings:  # a root or a sine of an unknown is not linear in it
        if unknowns & {word for each in meaning for word in re.findall(r"[^\W\d]\w*", str(each))}:
            return False
    places = [place for place, name in enumerate(context.names()) if name in unknowns]
    return all(sum(int(powers[place]) for place in places) <= 1 for top in tops for powers in top.to_dict())


def _below(ball: Any) -> Fraction:
    """A fraction below the ball's value, to nine figures."""
    return Fraction(math.floor(float(ball) * 1e9) - 1, 10**9)
