"""A formula evaluated in any arithmetic: doubles, whole arrays of them, pairs of doubles, intervals."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, assert_never

import numpy as np

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.double_double import PI, DoubleDouble, root
from corollary.formula.exact import constant

Values = Mapping[str, Any]


class NotAvailable(ArithmeticError):
    """An arithmetic lacks a function of the formula."""


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """Numbers that add, multiply and divide by themselves; `number` makes one of a fraction, `functions` act on them."""

    name: str
    number: Callable[[Fraction], Any]
    pi: Any
    functions: Mapping[str, Callable[..., Any]]


def ready(tree: Expr, arithmetic: Arithmetic) -> Callable[[Values], Any]:
    """The formula as a function of its letters' numbers. Raises NotAvailable."""

    def made(part: Expr) -> Callable[[Values], Any]:
        return ready(part, arithmetic)

    match tree:
        case Number(value):
            number = arithmetic.number(value)
            return lambda at: number
        case Name("pi"):
            return lambda at: at.get("pi", arithmetic.pi)
        case Name(name):
            return lambda at: at[name]
        case Negative(term):
            inner = made(term)
            return lambda at: -inner(at)
        case Sum(terms):
            return _joined([made(term) for term in terms], lambda a, b: a + b)
        case Product(factors):
            return _joined([made(factor) for factor in factors], lambda a, b: a * b)
        case Quotient(top, bottom):
            above, below = made(top), made(bottom)
            return lambda at: above(at) / below(at)
        case Power(base, exponent):
            below, fixed = made(base), constant(exponent)
            if fixed is not None and fixed.denominator == 1:
                whole = fixed.numerator
                return lambda at: below(at) ** whole
            if "power" not in arithmetic.functions:
                raise NotAvailable(f"{arithmetic.name} has no broken powers")
            above, power = made(exponent), arithmetic.functions["power"]
            return lambda at: power(below(at), above(at))
        case Call(function, arguments):
            if function not in arithmetic.functions:
                raise NotAvailable(f"{arithmetic.name} has no {function}")
            apply, inside = arithmetic.functions[function], [made(argument) for argument in arguments]
            return lambda at: apply(*[each(at) for each in inside])
        case Relation():
            raise NotAvailable("a comparison has no number as its value")
        case _:
            assert_never(tree)


def _joined(parts: list[Callable[[Values], Any]], join: Callable[[Any, Any], Any]) -> Callable[[Values], Any]:
    first, *rest = parts

    def run(at: Values) -> Any:
        total = first(at)
        for part in rest:
            total = join(total, part(at))
        return total

    return run


DOUBLES = Arithmetic(
    "float64", float, math.pi,
    {
        "sqrt": math.sqrt, "abs": abs, "sin": math.sin, "cos": math.cos, "tan": math.tan, "asin": math.asin, "acos": math.acos,
        "atan": math.atan, "atan2": math.atan2, "exp": math.exp, "ln": math.log, "log10": math.log10, "min": min, "max": max,
        "power": math.pow,
    },
)  # fmt: skip

ARRAYS = Arithmetic(
    "float64 arrays", float, math.pi,
    {
        "sqrt": np.sqrt, "abs": np.abs, "sin": np.sin, "cos": np.cos, "tan": np.tan, "asin": np.arcsin, "acos": np.arccos,
        "atan": np.arctan, "atan2": np.arctan2, "exp": np.exp, "ln": np.log, "log10": np.log10, "min": np.minimum,
        "max": np.maximum, "power": np.power,
    },
)  # fmt: skip

PAIRS = Arithmetic("double-double", DoubleDouble.of, PI, {"sqrt": root, "abs": abs})


def intervals() -> Arithmetic:
    """Pairs of doubles that hold the value between them; made when asked for, since mpmath takes a while to load."""
    import mpmath

    iv: Any = mpmath.iv
    iv.prec = 53
    return Arithmetic(
        "intervals", lambda value: iv.mpf(value.numerator) / iv.mpf(value.denominator), iv.pi,
        {"sqrt": iv.sqrt, "abs": abs, "sin": iv.sin, "cos": iv.cos, "exp": iv.exp, "ln": iv.log, "power": lambda a, b: a**b},
    )  # fmt: skip
