"""Logarithms as a person writes them: `ln(A/B)` for `ln(A) - ln(B)`, each of which alone would measure something."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from functools import reduce
from typing import Any, cast

import sympy


def logarithms_together(expr: sympy.Expr) -> sympy.Expr:
    """The same where every logarithm in it is real: those added with the same factor are one, of a product or quotient.

    `ln(2^x)` is x ln 2, and `-ln(A/B)` is ln(B/A).
    """
    if not expr.args or not expr.has(sympy.log):
        return expr
    inner: Any = expr.func(*(logarithms_together(cast(sympy.Expr, each)) for each in expr.args))
    match inner:
        case sympy.log(args=(sympy.Pow(base=base, exp=exp),)) if base.is_positive:
            return exp * sympy.log(base)
        case sympy.Add():
            return _added(inner)
        case sympy.Mul() if inner.could_extract_minus_sign():
            return _turned(inner)
        case _:
            return inner


def _added(total: sympy.Add) -> sympy.Expr:
    """Terms with one logarithm each, grouped by what stands beside it but for a rational number."""
    groups: dict[Any, list[tuple[Any, Any]]] = {}
    rest: list[Any] = []
    for term in total.args:
        factors: tuple[Any, ...] = sympy.Mul.make_args(term)
        logs = [each for each in factors if isinstance(each, sympy.log)]
        if len(logs) == 1:
            number, beside = sympy.Mul(*(each for each in factors if each is not logs[0])).as_coeff_Mul()
            if number.is_Rational:
                groups.setdefault(beside, []).append((number, logs[0].args[0]))
                continue
        rest.append(term)
    if all(len(group) == 1 for group in groups.values()):
        return total
    return sympy.Add(*rest, *(beside * _one(group) for beside, group in groups.items()))


def _one(group: list[tuple[Any, Any]]) -> sympy.Expr:
    """The sum of numbers times logarithms as one logarithm; a number before it where all have it."""
    common = reduce(sympy.gcd, (abs(number) for number, _argument in group))
    product = sympy.Mul(*(argument ** (number / common) for number, argument in group))
    return _turned(common * sympy.log(product))


def _turned(product: Any) -> Any:
    """A minus before the logarithm of a quotient, put into it."""
    logs = [each for each in sympy.Mul.make_args(product) if isinstance(each, sympy.log)]
    if len(logs) != 1 or not product.could_extract_minus_sign():
        return product
    argument: Any = logs[0].args[0]
    if sympy.fraction(argument)[1].is_number:
        return product
    return -product.xreplace({logs[0]: sympy.log(1 / argument)})
