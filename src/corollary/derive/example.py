"""Examples of a student's own: how free their laws leave them, and one good one."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from typing import Any

import sympy

from corollary.derive.applied import applied
from corollary.derive.assumptions import Known, at, simplest
from corollary.derive.solution import SolvedExample
from corollary.derive.statements import Example
from corollary.formula.ast import Expr
from corollary.formula.from_sympy import tree
from corollary.laws.law import Law, sides, substitute

Stated = Example[sympy.Symbol, sympy.Expr, Law]


def solved_example(entry: Stated, known: Known) -> SolvedExample:
    """Counts how many unknowns the laws leave free, for an example must leave room for the student's own. Raises ValueError."""
    equations = [
        sympy.simplify(known.in_givens(left - right)) for law in entry.laws for left, right in sides(law)
    ]
    unknowns = len(entry.unknowns)
    free = unknowns - sympy.Matrix(equations).jacobian(list(entry.unknowns)).rank()
    if free != entry.free:
        raise ValueError(f"{len(equations)} laws for {unknowns} unknowns leave {free} free, not {entry.free}")
    return Example(
        entry.statement,
        tuple(symbol.name for symbol in entry.unknowns),
        tuple(map(applied, entry.laws)),
        tuple((tuple(map(known.tree_in_givens, values)), why) for values, why in entry.apart),
        entry.free,
        known.tree_in_givens(entry.scale),
        _instance(entry, known, equations),
    )


def _instance(entry: Stated, known: Known, equations: list[sympy.Expr]) -> tuple[Expr, ...] | None:
    """One good example: the first unknowns set to simple shares of the scale, the others solved for."""
    scale = known.in_givens(entry.scale)
    chosen, others = entry.unknowns[: entry.free], list(entry.unknowns[entry.free :])
    for share in (sympy.Rational(-1, 3), sympy.Rational(1, 2), sympy.Integer(2), sympy.Rational(1, 5)):
        fixed: dict[sympy.Symbol, Any] = dict.fromkeys(chosen, share * scale)
        left = [substitute(equation, fixed) for equation in equations]
        for root in sympy.solve(left, others, dict=True) if others else [{}]:
            whole = fixed | root
            if all(
                symbol in whole and not whole[symbol].free_symbols - set(known.formulas)
                for symbol in entry.unknowns
            ) and all(at(value, each).is_real for value in whole.values() for each in known.points):
                return tuple(tree(simplest(whole[symbol])) for symbol in entry.unknowns)
    return None
