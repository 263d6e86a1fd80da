"""Rounding residue of an answer that is exactly zero: how large a number may be that stands for it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from fractions import Fraction

from corollary.answers.evaluation import number
from corollary.answers.expected import Values
from corollary.answers.tolerance import ROUNDING_NOISE
from corollary.derive.solution import ClosedForms, Unknown
from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Sum
from corollary.formula.ball import RationalPi, Undefined
from corollary.formula.functions import FUNCTIONS
from corollary.problem.given import Given
from corollary.problem.problem import Problem
from corollary.units.unit import Unit

BELOW_A_ROOT = Number(
    Fraction(100)
)  # times a residue: the root of 1e-16, in parts of ROUNDING_NOISE, and some more
SMALLER = 1e-3  # of the smallest given of the dimension: a residue is far below whatever the problem is about


def residue_of(
    problem: Problem, find: Unknown, units: Sequence[Unit], known: Mapping[str, RationalPi]
) -> Values:
    """For each component (absolute, SI) what calculators and doubles may leave of it where its terms cancel.

    A share of the terms, or of the largest given of the dimension where there are none; and always far below its smallest.
    """
    letters = dict(known)
    for each in problem.givens:
        if each.symbol in known and not known[each.symbol].ratio:
            letters[each.symbol] = _usual_size(each)
    trees = find.in_givens or (find.local.trees if isinstance(find.local, ClosedForms) else ())
    found: list[float] = []
    for place, unit in enumerate(units):
        alike = [
            abs(float(known[each.symbol]))
            for each in problem.givens
            if not each.words and each.unit.dimension == unit.dimension
        ]
        terms = _terms(trees[place], letters) if len(trees) == len(units) else 0.0
        size = max(terms or max(alike, default=0.0), abs(float(unit.offset)))
        smallest = min(filter(None, alike), default=math.inf)
        found.append(min(ROUNDING_NOISE * size, SMALLER * smallest))
    return tuple(found)


def _terms(tree: Expr, known: Mapping[str, RationalPi]) -> float:
    """What is added up before anything cancels; 0 where it has no value."""
    sizes = {_size(name): RationalPi(abs(value.ratio), value.pi) for name, value in known.items()}
    try:
        return abs(number(_added(tree), {**known, **sizes}))
    except Undefined:
        return 0.0


def _size(name: str) -> str:
    return f"|{name}|"


def _added(tree: Expr) -> Expr:
    """The formula with every subtraction above the line made an addition, and 1 for what takes plain numbers: doubles make no
    exact 0 of `cos(90°)`. Below a root a residue of 1e-16 is one of 1e-8."""
    match tree:
        case Name(name):
            return tree if name == "pi" else Name(_size(name))
        case Number(value):
            return Number(abs(value))
        case Negative(term):
            return _added(term)
        case Sum(terms):
            return Sum(tuple(map(_added, terms)))
        case Product(factors):
            return Product(tuple(map(_added, factors)))
        case Quotient(top, bottom):
            return Quotient(_added(top), bottom)
        case Power(base, Number(exponent)) if exponent > 0:
            whole = Power(_added(base), Number(exponent))
            return whole if exponent >= 1 else Product((BELOW_A_ROOT, whole))
        case Call("abs", (argument,)):
            return _added(argument)
        case Call("sqrt", (argument,)):
            return Product((BELOW_A_ROOT, Call("sqrt", (_added(argument),))))
        case Call("acos" | "asin"):
            return BELOW_A_ROOT
        case Call(function) if function in FUNCTIONS and FUNCTIONS[function].dimension is None:
            return Number(Fraction(1))
        case _:
            return tree


def _usual_size(given: Given) -> RationalPi:
    """The largest value that a given may have, in SI."""
    ends = (RationalPi(*given.unit.to_si(value)) for value in (given.grid.first, given.grid.last))
    return max(ends, key=lambda end: abs(end.ratio))
