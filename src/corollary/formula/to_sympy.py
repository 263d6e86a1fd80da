"""From a formula as written to sympy, letter by letter."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Mapping
from typing import assert_never

import sympy

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.functions import FUNCTIONS


def expression(tree: Expr, meaning: Mapping[str, sympy.Expr]) -> sympy.Expr:
    """The tree in sympy, with `meaning` for its letters; derivatives and integrals are left as they stand.

    Raises KeyError for a letter without meaning.
    """
    match tree:
        case Number(value):
            return sympy.Rational(value.numerator, value.denominator)
        case Name("pi"):
            return sympy.pi
        case Name(name):
            return meaning[name]
        case Negative(term):
            return -expression(term, meaning)
        case Sum(terms):
            return sympy.Add(*(expression(term, meaning) for term in terms))
        case Product(factors):
            return sympy.Mul(*(expression(factor, meaning) for factor in factors))
        case Quotient(top, bottom):
            return expression(top, meaning) / expression(bottom, meaning)
        case Power(base, exponent):
            return expression(base, meaning) ** expression(exponent, meaning)
        case Call("derivative", (of, by, order)):
            return sympy.Derivative(
                expression(of, meaning), expression(by, meaning), int(expression(order, meaning))
            )
        case Call("integral", (of, *over)):
            by, low, high = (expression(each, meaning) for each in over)
            return sympy.Integral(expression(of, meaning), (by, low, high))
        case Call("infinity", _):
            return sympy.oo
        case Call("value", (of, at)):
            return expression(of, meaning).func(expression(at, meaning))
        case Call(function, arguments):
            named = FUNCTIONS[function].sympy or function
            apply = getattr(sympy, named) if isinstance(named, str) else named
            return apply(*(expression(argument, meaning) for argument in arguments))
        case Relation():
            raise TypeError("a relation is not an expression; take its sides")
        case _:
            assert_never(tree)
