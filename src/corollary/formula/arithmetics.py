"""One fold over formula trees, with the arithmetic as argument: doubles, arrays of them, exact fractions, balls."""

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
    unsigned,
)
from corollary.formula.errors import NotAvailable
from corollary.formula.functions import FUNCTIONS, Function
from corollary.formula.rational_pi import PI, Irrational, RationalPi

__all__ = [
    "DOUBLES",
    "EXACT",
    "Arithmetic",
    "NotAvailable",
    "arrays",
    "as_formula",
    "constant",
    "exactly",
    "ready",
]

Values = Mapping[str, Any]
Evaluation = Callable[[Values], Any]


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """Numbers that add, subtract, multiply and divide by themselves.

    `number` makes one of a fraction, `column` gives its form of a function (None where it has none), `power` raises one
    number to another that is not whole. `rounded` is given each evaluation whose result another operation goes on from, and
    gives the one to go on from instead (None: results are taken as they are).

    The last three make evaluations where an arithmetic has rules of its own: of a fraction, of a quotient, of a power, whose
    exponent `made` makes an evaluation of.
    """

    name: str
    number: Callable[[Fraction], Any]
    pi: Any
    column: Callable[[Function], Callable[..., Any] | None]
    power: Callable[[Any, Any], Any] | None = None
    rounded: Callable[[Evaluation], Evaluation] | None = None
    literal: Callable[[Fraction], Evaluation] | None = None
    quotient: Callable[[Evaluation, Evaluation], Evaluation] | None = None
    raised: Callable[[Evaluation, Expr, Callable[[Expr], Evaluation]], Evaluation] | None = None


def ready(tree: Expr, arithmetic: Arithmetic) -> Evaluation:
    """The formula as a function of its letters' numbers. Raises NotAvailable.

    Its parts are made ready in the order in which they are evaluated. Rounded is what an operation on letters gives; a sum or
    a product is one, however many terms it has, and a change of sign is none.
    """

    def result(tree: Expr) -> Evaluation:
        match tree:
            case Number(value):
                if arithmetic.literal is not None:
                    return arithmetic.literal(value)
                number = arithmetic.number(value)
                return lambda at: number
            case Name("pi"):
                return lambda at: at.get("pi", arithmetic.pi)
            case Name(name):
                return lambda at: at[name]
            case Negative(term):
                inner = result(term)
                return lambda at: -inner(at)
            case Sum(terms):
                first, *others = terms
                added = [(isinstance(each, Negative), unsigned(each)) for each in others]
                return _total(operand(first), [(minus, operand(each)) for minus, each in added])
            case Product(factors):
                return _multiplied([operand(factor) for factor in factors])
            case Quotient(top, bottom):
                above, below = operand(top), operand(bottom)
                if arithmetic.quotient is not None:
                    return arithmetic.quotient(above, below)
                return lambda at: above(at) / below(at)
            case Power(base, exponent):
                if arithmetic.raised is not None:
                    return arithmetic.raised(operand(base), exponent, operand)
                below, fixed = operand(base), constant(exponent)
                if fixed is not None and fixed.denominator == 1:
                    whole = fixed.numerator
                    return lambda at: below(at) ** whole
                power = arithmetic.power
                if power is None:
                    raise NotAvailable(f"{arithmetic.name} has no fractional powers")
                above = operand(exponent)
                return lambda at: power(below(at), above(at))
            case Call(function, arguments):
                apply = arithmetic.column(FUNCTIONS[function])
                if apply is None:
                    raise NotAvailable(f"{arithmetic.name} has no {function}")
                inside = [operand(argument) for argument in arguments]
                if len(inside) == 1:
                    (only,) = inside
                    return lambda at: apply(only(at))
                return lambda at: apply(*[each(at) for each in inside])
            case Relation():
                raise NotAvailable("a comparison has no number as its value")
            case _:
                assert_never(tree)

    def written_down(part: Expr) -> Evaluation:
        """What another operation goes on from, rounded."""
        if isinstance(part, Negative):
            inner = written_down(part.term)
            return lambda at: -inner(at)
        if rounded is None or isinstance(part, Name) or names(part) <= {"pi"}:
            return result(part)
        return rounded(result(part))

    rounded = arithmetic.rounded
    operand = result if rounded is None else written_down
    return result(tree)


# Two parts are written out: most sums and products have no more, and formulas are evaluated by the million. Nothing is added in
# place: the numbers may be arrays, of which others hold the same.
def _total(first: Evaluation, others: list[tuple[bool, Evaluation]]) -> Evaluation:
    """The sum of a first term and others, of which those with True are subtracted."""
    if len(others) == 1:
        ((minus, second),) = others
        return (lambda at: first(at) - second(at)) if minus else (lambda at: first(at) + second(at))

    def run(at: Values) -> Any:
        total = first(at)
        for minus, term in others:
            total = total - term(at) if minus else total + term(at)
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


def _exact_power(base: Evaluation, exponent: Expr, made: Callable[[Expr], Evaluation]) -> Evaluation:
    """The exponent is evaluated as any other part is."""
    above = made(exponent)
    return lambda at: base(at) ** above(at)


def _exact(row: Function) -> Callable[..., RationalPi]:
    def apply(*numbers: RationalPi) -> RationalPi:
        found = row.exact(*numbers)
        if found is None:
            raise Irrational
        return found

    return apply


EXACT = Arithmetic("fractions times powers of pi", RationalPi, PI, _exact, raised=_exact_power)


def exactly(tree: Expr, values: Mapping[str, object]) -> RationalPi | None:
    """The value in Q times a power of pi; None where it is not one, is not defined, or has too many digits."""
    known = {name: value for name, value in values.items() if isinstance(value, RationalPi)}
    try:
        return ready(tree, EXACT)(known)
    except (NotAvailable, Irrational, KeyError):
        return None


def as_formula(value: RationalPi) -> Expr:
    """The number as a formula: a fraction, times a power of pi where it has one."""
    number, pi = Number(value.ratio), Name("pi")
    if not value.pi:
        return number
    return Product((number, pi if value.pi == 1 else Power(pi, Number(Fraction(value.pi)))))


def constant(tree: Expr) -> Fraction | None:
    """The value of a formula without letters, where it is a fraction."""
    match tree:  # the usual ones at once: every power of a formula is asked for
        case Number(value):
            return value
        case Name():
            return None
        case _:
            found = exactly(tree, {})
            return found.ratio if found is not None and found.pi == 0 else None
