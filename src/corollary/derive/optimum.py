"""The best value of one letter between bounds: where the slope vanishes, or at an end."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy

from corollary.derive.assumptions import Point, at
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
            there = substitute(free, {letter: place})
            value = at(there, point)
            if not value.is_real:
                raise NoRoot(
                    _unreal(
                        f"what is to be {'largest' if largest else 'smallest'}, at {over} = {place},",
                        free,
                        point,
                        {letter: place},
                    )
                )
            return value

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
    for end, formula in ((low, between[0]), (high, between[1])):
        if not end.is_extended_real:
            raise NoRoot(_unreal(f"the end {formula} of the range", formula, point, {}))
    return bool(value.is_real) and bool(low <= value <= high)


def _unreal(what: str, formula: sympy.Expr, point: Point, there: Mapping[sympy.Basic, sympy.Expr]) -> str:
    """The sentence for a formula without a real value at a point: what stands under a root or in a logarithm there."""
    numbers = ", ".join(f"{name} = {value}" for name, value in point.written.items())
    for node in sympy.postorder_traversal(formula):
        part: Any = node
        root = isinstance(part, sympy.Pow) and not part.exp.is_integer
        if root or isinstance(part, sympy.log):
            inside = substitute(part.args[0], there)
            value: Any = at(inside, point)
            if value.is_real and (value < 0 or (value == 0 and not root)):
                where = "under a root" if root else "in a logarithm"
                found = sympy.N(value, 3)
                return f"{what} has no real value for {numbers}: {inside} {where} is {found}; correct its sign, or narrow the range"
    return f"{what} has no real value for {numbers}; correct it, or narrow the range"
