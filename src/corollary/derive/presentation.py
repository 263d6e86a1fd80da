"""Presentation forms of solved formulas: among equal forms, the one that costs a reader least."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any, cast

import sympy

from corollary.derive.numbered_list import listed
from corollary.derive.solution import ClosedForms, Regime, Solution, Unknown
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import (
    ZERO,
    Call,
    Expr,
    Name,
    Negative,
    Number,
    Power,
    Product,
    Relation,
    map_children,
    names,
    walk,
)
from corollary.formula.errors import NotAvailable
from corollary.formula.from_sympy import NoTree, tree
from corollary.formula.layout import Layout, LetterOrder, Points
from corollary.formula.to_sympy import expression
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter
from corollary.units.dimension import Dimension

TRIED = 6  # draws at which signs are seen; whoever prints a form holds it against the value
ANGLES = {"deg", "rad"}  # whose letters are no coefficients
LARGE = 60  # parts of a formula from which on only the cheap forms are tried
MANY = 8  # terms, and letters to collect by, likewise
FEW = 2  # terms of a factor that nothing is collected in
AS_STATED = 1.6  # times the cost of the best form: so much longer may a law's own words be


def with_presentation(solution: Solution) -> Solution:
    """The solution with the forms in which its worked solution prints formulas; what is computed with stays as it is."""
    if solution.template is not None:
        return listed(with_presentation(solution.template))
    problem = solution.problem
    draws = [chapter(problem), *sample(problem, TRIED - 1, salt="presentation")]
    points = [dict(each.letters_in_si) for each in draws]
    if not solution.regimes:
        return _presented(solution, points)
    regimes: list[Regime] = []
    done: dict[int, Solution] = {}
    for each in solution.regimes:
        if each.place not in done:
            with suppress(ArithmeticError):
                done[each.place] = _presented(each.solution, points)
        found = done[each.place]
        regimes.append(replace(each, solution=replace(found, conditions=each.solution.conditions)))
    return replace(regimes[0].solution, regimes=tuple(regimes))


def _presented(solution: Solution, points: Points) -> Solution:
    forms = Forms(solution, [dict(each) for each in points])
    unknowns = tuple(map(forms.unknown, solution.unknowns))
    neglected = tuple(replace(each, bound=forms.unknown(each.bound)) for each in solution.neglected)
    decided_by = tuple(map_children(each, forms.layout.set) for each in solution.decided_by)
    return replace(
        solution, unknowns=unknowns, neglected=neglected, decided_by=cast("tuple[Relation, ...]", decided_by)
    )


@dataclass(slots=True)
class Forms:
    """The forms of one derivation, whose letters get their values at the points as they are found."""

    solution: Solution
    points: list[dict[str, float]]
    layout: Layout = field(init=False)
    symbols: dict[str, sympy.Expr] = field(default_factory=dict[str, sympy.Expr])
    _known: dict[Expr, Expr] = field(default_factory=dict[Expr, Expr])

    def __post_init__(self) -> None:
        laws = [relation for find in self._finds() for law in find.laws for relation in law.here]
        formulas = {
            name: formula
            for find in self._finds()
            for name, formula in zip(find.names, find.in_givens or (), strict=False)
        }
        coefficients = [
            given.symbol
            for given in self.solution.problem.givens
            if given.unit.dimension == Dimension() and given.unit.text not in ANGLES
        ]
        self.layout = Layout(LetterOrder(laws, formulas, coefficients), self.points)

    def _finds(self) -> Iterator[Unknown]:
        yield from self.solution.unknowns
        yield from (each.bound for each in self.solution.neglected)

    def unknown(self, find: Unknown) -> Unknown:
        """The unknown with its forms, where it has formulas."""
        if not isinstance(find.local, ClosedForms) or find.numbering:
            return find
        for point in self.points:
            for name, formula in zip(find.names, find.local.trees, strict=True):
                with suppress(NotAvailable, KeyError, ValueError, ArithmeticError, TypeError):
                    point[name] = ready(formula, DOUBLES)(point)
        local = tuple(
            self.local(_as_stated(name, find), formula)
            for name, formula in zip(find.names, find.local.trees, strict=True)
        )
        in_givens = None if find.in_givens is None else tuple(map(self.best, find.in_givens))
        functions = tuple(replace(each, printed=self.best(each.formula)) for each in find.functions)
        slope = find.slope and (find.slope[0], self.best(find.slope[1]))
        return replace(find, printed=local, printed_in_givens=in_givens, functions=functions, slope=slope)

    def local(self, stated: Expr | None, formula: Expr) -> Expr:
        """The law's own words where they are not much longer than the best form."""
        best = self.best(formula)
        if stated is None or self.layout.total(stated) > AS_STATED * self.layout.total(best):
            return best
        return stated

    def best(self, formula: Expr) -> Expr:
        """The form that costs least; the formula, set as a textbook does, where nothing better is found."""
        if formula not in self._known:
            self._known[formula] = self._best(formula)
        return self._known[formula]

    def _best(self, formula: Expr) -> Expr:
        if isinstance(formula, Name | Number):
            return formula
        found = [self.layout.set(self._inside(formula))]
        if any(True for _ in walk(formula)) and len(list(walk(formula))) > 3:
            with suppress(KeyError, TypeError, NotImplementedError, sympy.PolynomialError, RecursionError):
                start = expression(formula, _Symbols(self))
                for form in dict.fromkeys(_forms(start)):
                    with suppress(NoTree):
                        found.append(self.layout.set(self._inside(tree(form))))
        best = min(dict.fromkeys(found), key=self.layout.total)
        return best if names(best) else formula  # a step function is more than its value here

    def _inside(self, formula: Expr) -> Expr:
        """The formula with the best form of what stands in its functions, roots among them."""
        if isinstance(formula, Call):
            return Call(formula.function, tuple(map(self.best, formula.arguments)))
        return map_children(formula, self._inside)

    def symbol(self, name: str) -> sympy.Expr:
        """Its letter, positive where it is so at all points."""
        if name not in self.symbols:
            positive = self.layout.sign(Name(name)) > 0
            self.symbols[name] = (
                sympy.Symbol(name, positive=True) if positive else sympy.Symbol(name, real=True)
            )
        return self.symbols[name]


class _Symbols(dict[str, sympy.Expr]):
    """The letters of `Forms`, made as they are asked for."""

    def __init__(self, forms: Forms):
        super().__init__()
        self.forms = forms

    def __missing__(self, name: str) -> sympy.Expr:
        return self.forms.symbol(name)


def _as_stated(name: str, find: Unknown) -> Expr | None:
    """What the only law about a letter says that it is, word for word: the book's own form."""
    stated = [relation for law in find.laws for relation in law.here if name in names(relation)]
    if len(stated) != 1 or stated[0].left != Name(name):
        return None
    right = stated[0].right
    if not names(right) or names(right) & set(find.names):
        return None
    return None if any(map(_is_unfinished, walk(right))) else right


def _is_unfinished(node: Expr) -> bool:
    """Derivatives and integrals, zeros, and what a person would write without a minus."""
    match node:
        case Call("derivative" | "integral" | "value" | "dot" | "cross" | "norm", _):
            return True
        case Product(factors):
            return any(isinstance(each, Negative) for each in factors)
        case Power(Negative(), _):
            return True
        case _:
            return node == ZERO


def _forms(start: sympy.Expr) -> Iterator[sympy.Expr]:
    """Equal forms: as solved, factored, over one denominator, collected by each letter, multiplied out."""
    yield start
    size = sympy.count_ops(start)
    if size > 4 * LARGE:
        return
    yield sympy.factor_terms(start)
    together = cast(sympy.Expr, sympy.together(start))
    yield together
    if size > LARGE:
        return
    yield sympy.factor(start)
    top, bottom = sympy.fraction(together)
    top = sympy.expand(top)
    terms: Sequence[Any] = sympy.Add.make_args(top)
    if 1 < len(terms) <= MANY:
        below, above = sympy.factor(bottom), sympy.factor(top)
        yield above / below
        sums: Sequence[Any] = [each.as_base_exp()[0] for each in sympy.Mul.make_args(above)]
        if any(len(each.args) > FEW for each in sums if each.is_Add):
            for letter in sorted(top.free_symbols, key=str)[:MANY]:
                if sum(term.has(letter) for term in terms) > 1:
                    yield cast(sympy.Expr, sympy.collect(top, letter, sympy.factor_terms) / below)
        yield sympy.Add(*(term / below for term in terms))
    yield sympy.expand_mul(start)
    for node in start.atoms(sympy.atan):
        yield _doubled(start, node)


def _doubled(whole: sympy.Expr, node: Any) -> sympy.Expr:
    """2 arctan(x) as one arctangent, which it is for -1 < x < 1."""
    (x,) = node.args
    return cast(sympy.Expr, whole.xreplace({node: sympy.atan(sympy.simplify(2 * x / (1 - x**2))) / 2}))
