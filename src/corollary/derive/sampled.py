"""Equality of two formulas: by algebra, or at sample points in ball arithmetic."""

# pyright: reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false, reportArgumentType=false, reportAttributeAccessIssue=false, reportAssignmentType=false, reportReturnType=false, reportGeneralTypeIssues=false, reportIndexIssue=false, reportCallIssue=false, reportOperatorIssue=false

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import chain, cycle
from typing import Any, Literal

import sympy

from corollary.derive.assumptions import Known, Point, at, vanishes
from corollary.formula.ast import Expr
from corollary.formula.ball import Ball, RationalPi, Undefined, evaluate, precision_of
from corollary.formula.from_sympy import NoTree, tree

RESIDUAL = sympy.Float("1e-20")  # of the terms of an equation, each known to 30 digits
FREE = (sympy.Rational(3, 7), sympy.Rational(8, 5), sympy.Rational(11, 13), sympy.Rational(17, 9))
"""Numbers for letters that have none yet."""
SHARES = (sympy.Rational(1, 3), sympy.Integer(1))
SHORT = 40  # operations: what sympy simplifies quickly
PRECISIONS = (128, 1024)  # bits: nearly all that differs does so at the first
ALIKE = 256  # bits to which two sides agree that the last precision does not tell apart
LEAST_FIGURES = 6  # figures of a side that differs; more where these are the same
NO_NUMBERS: Mapping[str, str] = {}

How = Literal["algebra", "points", "differ", "undecided"]


@dataclass(frozen=True, slots=True)
class Equality:
    """How two formulas compare: the same by algebra, the same at `count` points, different at the numbers `at`, or not decided.

    `sides` are their values there, in SI.
    """

    how: How
    count: int = 0
    at: Mapping[str, str] = field(default_factory=lambda: NO_NUMBERS)
    sides: tuple[str, str] = ("", "")

    @property
    def holds(self) -> bool:
        """Whether they are the same, as far as was seen."""
        return self.how in ("algebra", "points")

    def at_numbers(self, left: str = "the left side", right: str = "the right side") -> str:
        """The numbers at which they differ, and both values."""
        numbers = ", ".join(f"{name} = {value}" for name, value in self.at.items())
        return (
            f"{f'at {numbers} ' if numbers else ''}{left} is {self.sides[0]} and {right} {self.sides[1]} (SI)"
        )


def compared(one: object, other: object, known: Known) -> Equality:
    """Two formulas in givens (and what was found), with all that was found put in.

    Numbers come first: what differs at one point needs no algebra, and algebra is believed only where no point contradicts it.
    """
    return identical(*(known.with_asides(sympy.sympify(each)) for each in (one, other)), known)


def identical(
    left: sympy.Expr, right: sympy.Expr, known: Known, letters: Collection[sympy.Symbol] = ()
) -> Equality:
    """The same of two formulas as they stand; `letters` may have any value, and are given numbers of their own."""
    if left == right:
        return Equality("algebra")
    count = 0
    try:
        trees = tuple(tuple(map(tree, sympy.Add.make_args(side))) for side in (left, right))
    except NoTree:
        trees = ()
    for point in _with_numbers(known.points, letters) if trees else ():
        found = _at_point(trees, point)
        if isinstance(found, tuple):
            return Equality("differ", 1, point.written, found)
        count += found
    if vanishes(left - right):
        return Equality("algebra")
    return Equality("points", count) if count else Equality("undecided")


def _with_numbers(points: Sequence[Point], letters: Collection[sympy.Symbol]) -> Iterator[Point]:
    """The points, each with numbers for letters that may be anything."""
    if not letters:
        yield from points
        return
    names = sorted(letter.name for letter in letters)
    for point in points:
        for share in SHARES:
            numbers = {name: share * number for name, number in zip(names, cycle(FREE), strict=False)}
            balls = {name: RationalPi(Fraction(int(each.p), int(each.q))) for name, each in numbers.items()}
            labels = {name: str(each) for name, each in numbers.items()}
            yield replace(point, balls={**point.balls, **balls}, written={**point.written, **labels})


def _at_point(trees: tuple[tuple[Expr, ...], ...], point: Point) -> bool | tuple[str, str]:
    """Whether the two sums of terms are the same at a point; False where this is not to be seen, both values where they differ."""
    size: Any = None
    for bits in PRECISIONS:
        try:
            terms = [[evaluate(each, point.balls, bits) for each in side] for side in trees]
        except (Undefined, KeyError):
            return False
        with precision_of(bits):
            left, right = (sum(side, Ball(0)) for side in terms)
            # at the first precision, at which a term that is zero has still a width
            if size is None:
                size = sum((abs(each) for side in terms for each in side), Ball(0)).upper()
            if not left.is_finite() or not right.is_finite():
                continue
            if not (left - right).contains(0):
                return _both_values(left, right)
            if bits == PRECISIONS[-1]:
                return bool((left - right).rad() <= size * Ball(2) ** -ALIKE)
    return False


def _both_values(left: Any, right: Any) -> tuple[str, str]:
    """Both values with as many figures as it takes to tell them apart."""
    figures = LEAST_FIGURES
    while (texts := (_text(left, figures), _text(right, figures)))[0] == texts[1]:
        figures += 1
    return texts


def _text(value: Any, figures: int) -> str:
    return "0" if value.contains(0) else value.str(figures, radius=False)


def holds(
    residual: sympy.Expr,
    known: Known,
    letters: Collection[sympy.Symbol] = (),
    places: Sequence[sympy.Expr] = (),
) -> bool:
    """Whether an expression vanishes: by algebra, or at the sample points, its terms certified to 30 digits.

    `letters` are those of functions: they are tried at the `places` where the laws take these, and at a third of them.
    """
    in_givens = known.in_givens(residual)
    if sympy.expand(in_givens) == 0 or (sympy.count_ops(in_givens) < SHORT and vanishes(in_givens)):
        return True
    terms = sympy.Add.make_args(sympy.expand(in_givens, deep=False))
    moments = [known.in_givens(place) for place in places if place != 0][:3] or [FREE[0]]
    for point in known.points:
        for moment in moments:
            for share in SHARES:
                now = {letter: share * numbered(moment, point) for letter in letters}
                numbers = [at(numbered(term.xreplace(now), point), point) for term in terms]
                if not abs(sum(numbers)) <= RESIDUAL * sum(map(abs, numbers)):
                    return False
    return True


def numbered(expression: sympy.Expr, point: Point) -> sympy.Expr:
    """The expression with a number for each letter that has none at a point."""
    missing = sorted(expression.free_symbols - point.values.keys(), key=str)
    return expression.xreplace(dict(zip(missing, chain(FREE, FREE), strict=False)))
