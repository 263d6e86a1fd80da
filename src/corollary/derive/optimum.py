"""The best value of one letter between bounds: where the slope vanishes, or at an end."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence

import sympy

from corollary.derive.known import Point, at
from corollary.derive.roots import NoRoot
from corollary.formula.from_sympy import tree
from corollary.formula.latex import latex
from corollary.laws.law import substitute


def best(
    goal: sympy.Expr,
    over: sympy.Symbol,
    between: tuple[sympy.Expr, sympy.Expr],
    largest: bool,
    points: Sequence[Point],
) -> tuple[sympy.Expr, str]:
    """The place of the extremum and a line on how it was found. Raises NoRoot when it differs from point to point."""
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
    where = (
        "the slope vanishes there"
        if place in slope
        else "it is an end of the range, where the slope does not vanish"
    )
    inside = ", ".join(f"${latex(tree(each))}$" for each in slope) or "none"
    size = "largest" if largest else "smallest"
    return place, (
        f"Of the places where the slope vanishes ({inside}) and the ends ${latex(tree(low))}$ and ${latex(tree(high))}$, "
        f"this one gives the {size} value: {where}."
    )


def _between(place: sympy.Expr, between: tuple[sympy.Expr, sympy.Expr], point: Point) -> bool:
    value, low, high = (at(x, point) for x in (place, *between))
    return bool(value.is_real) and low <= value <= high
