"""A formula turned round: what one of its letters must be for the formula to come to a value."""

# pyright: reportMissingTypeArgument=false, reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownParameterType=false, reportUnknownVariableType=false, reportUnknownLambdaType=false, reportArgumentType=false, reportCallIssue=false

from __future__ import annotations

from contextlib import suppress
from functools import lru_cache

import sympy

from corollary.formula.ast import Expr, names
from corollary.formula.from_sympy import NoTree, tree
from corollary.formula.to_sympy import expression

ARCS = {
    sympy.sin: (sympy.asin, lambda y: sympy.pi - sympy.asin(y)),
    sympy.cos: (sympy.acos, lambda y: -sympy.acos(y)),
    sympy.tan: (sympy.atan,),
    sympy.asin: (sympy.sin,),
    sympy.acos: (sympy.cos,),
    sympy.atan: (sympy.tan,),
    sympy.exp: (sympy.log,),
    sympy.log: (sympy.exp,),
}
LONGEST = 60  # operations: what is longer than that nobody turns round by hand


@lru_cache(maxsize=4096)
def inverses(formula: Expr, letter: str, value: Expr) -> tuple[Expr, ...]:
    """What the letter may be where the formula comes to `value`: every branch, for it to be seen which one is meant.

    Only what takes no more than the operations undone one by one, or a quadratic equation; else nothing.
    """
    letters = {
        name: sympy.Symbol(name, real=True)
        for name in names(formula) | names(value) | {letter}
        if name != "pi"
    }
    unknown = letters[letter]
    left, right = expression(formula, letters), expression(value, letters)
    if sympy.count_ops(left) > LONGEST:
        return ()
    found: list[Expr] = []
    for root in _undone(left, unknown, right) or _quadratic(left - right, unknown):
        with suppress(NoTree):
            found.append(tree(root))
    return tuple(found)


def _undone(formula: sympy.Expr, unknown: sympy.Symbol, value: sympy.Expr) -> list[sympy.Expr]:
    """The operations on the unknown undone from the outside, where it stands in one place only."""
    if formula == unknown:
        return [value]
    inside = [each for each in formula.args if each.has(unknown)]
    if len(inside) != 1:
        shorter = sympy.factor(formula) if inside else formula
        if shorter != formula and sum(each.has(unknown) for each in shorter.args) == 1:
            return _undone(shorter, unknown, value)
        return []
    (part,) = inside
    others = [each for each in formula.args if each is not part]
    if isinstance(formula, sympy.Add):
        before = [value - sympy.Add(*others)]
    elif isinstance(formula, sympy.Mul):
        before = [value / sympy.Mul(*others)]
    elif isinstance(formula, sympy.Pow) and part is formula.base:
        root = value ** (1 / formula.exp)
        before = [root, -root] if formula.exp.is_Integer and formula.exp % 2 == 0 else [root]
    elif isinstance(formula, sympy.Pow) and formula.base.is_positive:
        before = [sympy.log(value) / sympy.log(formula.base)]
    elif isinstance(formula, sympy.Abs):
        before = [value, -value]
    else:
        before = [arc(value) for arc in ARCS.get(formula.func, ())]
    return [root for each in before for root in _undone(part, unknown, each)]


def _quadratic(residual: sympy.Expr, unknown: sympy.Symbol) -> list[sympy.Expr]:
    top, _bottom = sympy.fraction(sympy.together(residual))
    try:
        polynomial = sympy.Poly(sympy.expand(top), unknown)
    except sympy.PolynomialError:
        return []
    if polynomial.degree() not in (1, 2):
        return []
    c, b, a = (polynomial.coeff_monomial(unknown**power) for power in (0, 1, 2))
    if a == 0:
        return [sympy.factor(-c / b)]
    spread = sympy.sqrt(sympy.factor(b**2 - 4 * a * c))
    return [(-b + spread) / (2 * a), (-b - spread) / (2 * a)]
