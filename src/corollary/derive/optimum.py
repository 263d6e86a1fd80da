"""The best value of one letter between bounds: where the slope vanishes, or at an end."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence

import sympy

from corollary.derive.known import Point, at
from corollary.derive.roots import NoRoot
from corollary.derive.statements import Sentence
from corollary.formula.from_sympy import tree
from corollary.formula.latex import latex
from corollary.laws.law import substitute
from corollary.messages import N_

# By whether the value is the largest, and where it is taken.
FOUND = {
    (True, "inside"): N_(
        "Of the places where the slope vanishes ({flat}) and the ends {low} and {high} this gives the largest value: the slope vanishes there."
    ),
    (True, "end"): N_(
        "Of the places where the slope vanishes ({flat}) and the ends {low} and {high} this gives the largest value: an end of the range, where the slope does not vanish."
    ),
    (True, "no slope"): N_(
        "The slope vanishes nowhere; of the ends {low} and {high}, this gives the largest value."
    ),
    (False, "inside"): N_(
        "Of the places where the slope vanishes ({flat}) and the ends {low} and {high} this gives the smallest value: the slope vanishes there."
    ),
    (False, "end"): N_(
        "Of the places where the slope vanishes ({flat}) and the ends {low} and {high} this gives the smallest value: an end of the range, where the slope does not vanish."
    ),
    (False, "no slope"): N_(
        "The slope vanishes nowhere; of the ends {low} and {high}, this gives the smallest value."
    ),
}


def best(
    goal: sympy.Expr,
    over: sympy.Symbol,
    between: tuple[sympy.Expr, sympy.Expr],
    largest: bool,
    points: Sequence[Point],
) -> tuple[sympy.Expr, Sentence]:
    """The place of the extremum and a sentence on how it was found. Raises NoRoot when it differs from point to point."""
    known = {over, *(letter for point in points for letter in point.values)}
    if strange := {letter for formula in (goal, *between) for letter in formula.free_symbols} - known:
        raise NoRoot(f"the extremum over {over}: {', '.join(sorted(map(str, strange)))} has no value here")
    letter = sympy.Dummy("x", real=True)
    free = substitute(goal, {over: letter})
    low, high = between
    try:
        slope = sympy.solve(sympy.diff(free, letter), letter)
    except NotImplementedError:
        raise NoRoot(
            f"where the slope over {over} vanishes cannot be put in a formula; use simulated(…)"
        ) from None
    winners: set[sympy.Expr] = set()
    for point in points:

        def height(place: sympy.Expr, point: Point = point) -> sympy.Expr:
            return at(substitute(free, {letter: place}), point)

        inside = [place for place in slope if _between(place, between, point)]
        candidates = list(dict.fromkeys([*inside, low, high]))
        winners.add((max if largest else min)(candidates, key=height))
    if len(winners) != 1:
        raise NoRoot(
            f"the extremum over {over} moves from {' to '.join(map(str, winners))} within the range of the givens"
        )
    place = winners.pop()
    flat = ", ".join(f"${latex(tree(each))}$" for each in slope)
    holes = (("flat", flat), ("low", f"${latex(tree(low))}$"), ("high", f"${latex(tree(high))}$"))
    where = "inside" if place in slope else "end" if slope else "no slope"
    return place, Sentence(FOUND[largest, where], holes)


def _between(place: sympy.Expr, between: tuple[sympy.Expr, sympy.Expr], point: Point) -> bool:
    value, low, high = (at(x, point) for x in (place, *between))
    return bool(value.is_real) and low <= value <= high
