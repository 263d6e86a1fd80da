"""A derivation whose steps are solved again with other laws, from what was known before each."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, replace
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from corollary.derive.assumptions import FoundFunction, Known
from corollary.derive.function_values import Pair, functions_in, is_differential, letters_in, put_back
from corollary.derive.roots import roots
from corollary.derive.solve import Solver
from corollary.derive.statements import Finding, Optimum, Step
from corollary.formula.ast import Expr, Relation
from corollary.formula.from_sympy import NoTree, tree
from corollary.laws.law import Law, sides, substitute

MOMENTS = (sympy.Rational(3, 7), sympy.Rational(8, 5))
"""Numbers for the letter of a function where a law holds at any."""
Functions = Mapping[str, FoundFunction]
"""Functions that are other than those of the derivation, by name."""


@dataclass(frozen=True, slots=True)
class OtherRoots:
    """The roots of a step's laws in the letters found before it, one formula for each unknown, and the functions found with them."""

    formulas: tuple[tuple[Expr, ...], ...]
    functions: Functions


class SolvedAgain:
    """What is known before each find; `differential` are the places of steps with functions, derivatives or integrals."""

    def __init__(self, solver: Solver, finds: Sequence[Finding]):
        """Raises NotDerivable where the derivation cannot be solved."""
        self.finds = finds
        self.before: list[Known] = []
        for entry in finds:
            self.before.append(solver.known.copied())
            solver.find(entry)
        self.after = solver.known
        self.differential = frozenset(
            place
            for place, entry in enumerate(finds)
            if isinstance(entry, Step) and is_differential(_pairs(entry.laws))
        )

    def roots(self, place: int, laws: Sequence[Law], functions: Functions) -> OtherRoots:
        """Those of the step at a place with other laws, or other functions. Raises ValueError where there is none, as when it is
        solved first, and where none is a formula."""
        entry = self.finds[place]
        assert isinstance(entry, Step)
        unknowns = (*entry.unknowns, *entry.also)
        found, new = roots(laws, unknowns, _with(self.before[place], functions))
        formulas = [
            each for root in found if (each := _formulas([root[one] for one in unknowns])) is not None
        ]
        if not formulas:
            raise ValueError("no root is a formula")
        asides = {symbol: found[0][symbol] for symbol in entry.also} if len(found) == 1 else {}
        named = {each.name: replace(each, formula=substitute(each.formula, asides)) for each in new}
        return OtherRoots(tuple(formulas), named)

    def takes_formulas(self, place: int, laws: Sequence[Law], changed: Set[str]) -> bool:
        """Whether laws derive or integrate letters, of those changed, by what these are in the givens."""
        nodes = (node for pair in _pairs(laws) for node in _by_formulas(pair, self.before[place]))
        return any({symbol.name for symbol in node.args[0].free_symbols} & changed for node in nodes)

    def written_out(self, law: Law, functions: Functions) -> list[Relation]:
        """The equations of a law, the functions put in, at some moments; none where a formula is derived or integrated in it.
        Raises ValueError where something has no closed form."""
        known = _with(self.after, functions)
        free = letters_in([law], known)
        places = [each.place for each in self.after.functions if not each.place.free_symbols & free]
        moments = [*MOMENTS, *[each for each in places if each != 0][:1]]
        found: list[Relation] = []
        for pair in sides(law):
            if _by_formulas(pair, known):
                return []
            left, right = (put_back(known.with_functions(side), ()) for side in pair)
            for moment in moments if free else moments[:1]:
                at = dict.fromkeys(free, moment)
                found.append(Relation("=", *(tree(substitute(side, at)) for side in (left, right))))
        return found


def differential(law: Law) -> bool:
    """Whether a law holds functions, derivatives or integrals."""
    return is_differential(sides(law))


def functions_of(stated: Sequence[Law] | Optimum) -> set[str]:
    """The names of the functions that laws speak of, or what is made an extremum."""
    if isinstance(stated, Optimum):
        return {str(each.func) for each in stated.of.atoms(AppliedUndef)}
    return {str(each) for each in functions_in(stated)}


def _pairs(laws: Sequence[Law]) -> list[Pair]:
    return [pair for law in laws for pair in sides(law)]


def _with(known: Known, functions: Functions) -> Known:
    found = known.copied()
    found.functions = [functions.get(each.name, each) for each in found.functions]
    return found


def _formulas(values: Sequence[sympy.Expr]) -> tuple[Expr, ...] | None:
    try:
        return tuple(map(tree, values))
    except NoTree:
        return None


def _by_formulas(pair: Pair, known: Known) -> list[Any]:
    """The derivatives and integrals of what depends on their letter by what it is in the givens alone."""
    nodes: list[Any] = [node for side in pair for node in side.atoms(sympy.Derivative, sympy.Integral)]
    return [
        node
        for node in nodes
        if not node.args[0].has(over := node.args[1][0]) and known.in_givens(node.args[0]).has(over)
    ]
