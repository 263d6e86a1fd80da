"""From sympy to a formula tree, in the form a person would write."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from fractions import Fraction
from typing import cast

import sympy
from sympy.core.function import AppliedUndef
from sympy.logic.boolalg import Boolean

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.authored import NotTyped, typed
from corollary.formula.functions import FUNCTIONS, Function

SIGNS = {sympy.Eq: "=", sympy.Ne: "!=", sympy.Lt: "<", sympy.Le: "<=", sympy.Gt: ">", sympy.Ge: ">="}

COFUNCTIONS = {"cot": (sympy.cos, sympy.sin), "sec": (None, sympy.cos), "csc": (None, sympy.sin)}
"""What sympy makes of 1/tan and its like, by the functions that a person writes: above and below."""


class NoTree(ValueError):
    """The expression holds something no formula of ours can say."""


def as_typed(value: object) -> str:
    """A formula of sympy's as an author types it, for a message: `m*v^2`."""
    return str(value).replace("**", "^")


def tree(expr: sympy.Expr) -> Expr:
    """The expression as a formula. Raises NoTree for what has no place in one (integrals, piecewise, complex numbers)."""
    if isinstance(expr, sympy.Float):
        try:
            expr = typed(expr)
        except NotTyped as error:
            raise NoTree(str(error)) from None
    if expr.is_Rational:
        value = Fraction(int(expr.p), int(expr.q))  # type: ignore[attr-defined]
        return _rational(value)
    if expr is sympy.pi:
        return Name("pi")
    if expr is sympy.E:
        return Call("exp", (Number(Fraction(1)),))
    if isinstance(expr, sympy.Symbol):
        return Name(expr.name)
    if isinstance(expr, sympy.Add):
        return Sum(tuple(_signed(term) for term in _in_order(expr)))
    if isinstance(expr, sympy.Mul):
        return _product(expr)
    if isinstance(expr, sympy.Pow):
        return _power(expr.base, expr.exp)
    if isinstance(expr, sympy.core.function.Application) and not isinstance(expr, AppliedUndef):
        called = type(expr).__name__
        row = next((row for row in FUNCTIONS.values() if (row.sympy or row.name) == called), None)
        if row is not None:
            return _call(row, [tree(cast(sympy.Expr, argument)) for argument in expr.args])
        if called in COFUNCTIONS:
            above, below = COFUNCTIONS[called]
            (argument,) = expr.args
            return Quotient(tree(above(argument)) if above else Number(Fraction(1)), tree(below(argument)))
    if expr in (sympy.zoo, sympy.nan):
        raise NoTree("it divides by zero for every value of the givens; correct the law")
    raise NoTree(f"{expr} cannot be written as a formula ({type(expr).__name__})")


def relation(condition: Boolean) -> Relation:
    """A relational as a tree. Raises NoTree for anything else."""
    for kind, sign in SIGNS.items():
        if isinstance(condition, kind):
            return Relation(sign, tree(condition.lhs), tree(condition.rhs))  # type: ignore[attr-defined]
    raise NoTree(f"{condition} is not a relation")


def _call(row: Function, arguments: list[Expr]) -> Expr:
    """The function of its arguments; sympy's Min and Max take any number of them, ours two."""
    call = Call(row.name, tuple(arguments[: row.arity]))
    for argument in arguments[row.arity :]:
        call = Call(row.name, (call, argument))
    return call


def _rational(value: Fraction) -> Expr:
    if value < 0:
        return Negative(_rational(-value))
    if value.denominator == 1:
        return Number(value)
    return Quotient(Number(Fraction(value.numerator)), Number(Fraction(value.denominator)))


def _in_order(expr: sympy.Add) -> list[sympy.Expr]:
    """The terms, a positive one first where there is one."""
    terms = cast(list[sympy.Expr], expr.as_ordered_terms())
    first = next((i for i, term in enumerate(terms) if not term.could_extract_minus_sign()), 0)
    return [terms[first], *terms[:first], *terms[first + 1 :]]


def _signed(term: sympy.Expr) -> Expr:
    if term.could_extract_minus_sign():
        return Negative(tree(-term))
    return tree(term)


def _product(expr: sympy.Mul) -> Expr:
    if expr.could_extract_minus_sign() and not isinstance(-expr, sympy.Add):
        return Negative(tree(cast(sympy.Expr, -expr)))
    top, bottom = sympy.fraction(expr, exact=True)
    if below := [factor for factor in sympy.Mul.make_args(top) if _belongs_below(factor)]:
        top, bottom = top / sympy.Mul(*below), bottom / sympy.Mul(*below)
    root, cofactor = _roots_together(top, bottom)
    if root is not None:
        return root if cofactor == 1 else _with_root(cofactor, root)
    if bottom != 1:
        return Quotient(tree(top), tree(bottom))
    coefficient, rest = expr.as_coeff_Mul()
    factors = list(rest.as_ordered_factors())
    factors.sort(key=lambda factor: (isinstance(factor, sympy.Function), isinstance(factor, sympy.Add)))
    if coefficient != 1:
        factors.insert(0, coefficient)
    if len(factors) == 1:
        return tree(factors[0])
    return Product(tuple(tree(factor) for factor in factors))


def _belongs_below(factor: sympy.Expr) -> bool:
    """Whether a factor is a number to a negative power with letters, such as 2^(-t/T): 1/2^(t/T), where exp(-t/T) stays."""
    return (
        isinstance(factor, sympy.Pow)
        and bool(factor.base.is_Rational)
        and not factor.exp.is_number
        and factor.exp.could_extract_minus_sign()
    )


def _roots_together(top: sympy.Expr, bottom: sympy.Expr) -> tuple[Expr | None, sympy.Expr]:
    """Two square roots or more as one, `sqrt(2*g*h)`, and what stands beside it; None when there are fewer."""
    above, cofactors_above = _square_roots(top)
    below, cofactors_below = _square_roots(bottom)
    if len(above) + len(below) < 2:
        return None, top / bottom
    return Call("sqrt", (tree(sympy.Mul(*above) / sympy.Mul(*below)),)), sympy.Mul(
        *cofactors_above
    ) / sympy.Mul(*cofactors_below)


def _square_roots(product: sympy.Expr) -> tuple[list[sympy.Expr], list[sympy.Expr]]:
    """What stands under square roots among the factors, and the other factors."""
    factors = sympy.Mul.make_args(product)
    half = sympy.Rational(1, 2)
    under = [factor.base for factor in factors if isinstance(factor, sympy.Pow) and factor.exp == half]
    return under, [factor for factor in factors if not (isinstance(factor, sympy.Pow) and factor.exp == half)]


def _with_root(cofactor: sympy.Expr, root: Expr) -> Expr:
    top, bottom = sympy.fraction(cofactor)
    above = root if top == 1 else Product((tree(top), root))
    return above if bottom == 1 else Quotient(above, tree(bottom))


def _power(base: sympy.Expr, exponent: sympy.Expr) -> Expr:
    if exponent.could_extract_minus_sign():
        return Quotient(Number(Fraction(1)), tree(base**-exponent))
    if exponent == sympy.Rational(1, 2):
        return Call("sqrt", (tree(base),))
    return Power(tree(base), tree(exponent))
