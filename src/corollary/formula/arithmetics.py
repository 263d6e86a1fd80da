"""A formula evaluated in any arithmetic: doubles, whole arrays of them, pairs of doubles, intervals."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, assert_never

from corollary.formula.ast import (
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Relation,
    Sum,
    names,
)
from corollary.formula.double_double import PI, DoubleDouble
from corollary.formula.errors import NotAvailable
from corollary.formula.exact import constant
from corollary.formula.functions import FUNCTIONS, Function

__all__ = ["DOUBLES", "PAIRS", "Arithmetic", "NotAvailable", "arrays", "intervals", "ready"]

Values = Mapping[str, Any]
Evaluation = Callable[[Values], Any]


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """Numbers that add, multiply and divide by themselves.

    `number` makes one of a fraction, `column` gives its form of a function (None where it has none), `power` raises one
    number to another that is not whole. `rounded` is given each evaluation whose result another operation goes on from, and
    gives the one to go on from instead (None: results are taken as they are).
    """

    name: str
    number: Callable[[Fraction], Any]
    pi: Any
    column: Callable[[Function], Callable[..., Any] | None]
    power: Callable[[Any, Any], Any] | None = None
    rounded: Callable[[Evaluation], Evaluation] | None = None


def ready(tree: Expr, arithmetic: Arithmetic) -> Evaluation:
    """The formula as a function of its letters' numbers. Raises NotAvailable.

    Its parts are made ready in the order in which they are evaluated. Rounded is what an operation on letters gives; a sum or
    a product is one, however many terms it has, and a change of sign is none.
    """
    rounded = arithmetic.rounded

    def made(part: Expr) -> Evaluation:
        if rounded is None or isinstance(part, Number | Name):
            return ready(part, arithmetic)
        if isinstance(part, Negative):
            inner = made(part.term)
            return lambda at: -inner(at)
        return ready(part, arithmetic) if names(part) <= {"pi"} else rounded(ready(part, arithmetic))

    match tree:
        case Number(value):
            number = arithmetic.number(value)
            return lambda at: number
        case Name("pi"):
            return lambda at: at.get("pi", arithmetic.pi)
        case Name(name):
            return lambda at: at[name]
        case Negative(term):
            inner = ready(term, arithmetic)
            return lambda at: -inner(at)
        case Sum(terms):
            return _total([made(term) for term in terms])
        case Product(factors):
            return _multiplied([made(factor) for factor in factors])
        case Quotient(top, bottom):
            above, below = made(top), made(bottom)
            return lambda at: above(at) / below(at)
        case Power(base, exponent):
            below, fixed = made(base), constant(exponent)
            if fixed is not None and fixed.denominator == 1:
                whole = fixed.numerator
                return lambda at: below(at) ** whole
            power = arithmetic.power
            if power is None:
                raise NotAvailable(f"{arithmetic.name} has no broken powers")
            above = made(exponent)
            return lambda at: power(below(at), above(at))
        case Call(function, arguments):
            apply, inside = arithmetic.column(FUNCTIONS[function]), [made(argument) for argument in arguments]
            if apply is None:
                raise NotAvailable(f"{arithmetic.name} has no {function}")
            return lambda at: apply(*[each(at) for each in inside])
        case Relation():
            raise NotAvailable("a comparison has no number as its value")
        case _:
            assert_never(tree)


# Two parts are written out: most sums and products have no more, and formulas are evaluated by the million. Nothing is added in
# place: the numbers may be arrays, of which others hold the same.
def _total(parts: list[Evaluation]) -> Evaluation:
    first, *rest = parts
    if len(rest) == 1:
        second = rest[0]
        return lambda at: first(at) + second(at)

    def run(at: Values) -> Any:
        total = first(at)
        for part in rest:
            total = total + part(at)
        return total

    return run


def _multiplied(parts: list[Evaluation]) -> Evaluation:
    first, *rest = parts
    if len(rest) == 1:
        second = rest[0]
        return lambda at: first(at) * second(at)

    def run(at: Values) -> Any:
        product = first(at)
        for part in rest:
            product = product * part(at)
        return product

    return run


DOUBLES = Arithmetic("float64", float, math.pi, lambda row: row.double, math.pow)
PAIRS = Arithmetic("double-double", DoubleDouble.of, PI, lambda row: row.double_double)


def arrays() -> Arithmetic:
    """Arrays of doubles, NaN where there is no value; made when asked for, since what reads answers needs Python alone.

    A function that numpy lacks is worked out element by element.
    """
    import numpy as np

    def column(row: Function) -> Callable[..., Any]:
        def each(*arguments: float) -> float:
            try:
                return row.double(*arguments)
            except (ValueError, ZeroDivisionError, OverflowError):
                return math.nan

        return getattr(np, row.array or row.name, None) or np.vectorize(each, otypes=[float])

    return Arithmetic("float64 arrays", float, math.pi, column, np.power)


def intervals() -> Arithmetic:
    """Pairs of doubles that hold the value between them; made when asked for, since mpmath takes a while to load."""
    import mpmath

    iv: Any = mpmath.iv
    iv.prec = 53
    return Arithmetic(
        "intervals",
        lambda value: iv.mpf(value.numerator) / iv.mpf(value.denominator),
        iv.pi,
        lambda row: getattr(iv, row.interval or row.name, None),
        lambda a, b: a**b,
    )
