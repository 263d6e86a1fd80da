"""Laws solved together for all the letters they leave open: every root, one letter after the other, with no problem around them."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Generator, Mapping, Sequence, Set
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, cast

import sympy

from corollary.derive.assumptions import in_sympy, simplest
from corollary.derive.roots import NoRoot
from corollary.formula.ast import Expr
from corollary.formula.ball import RationalPi, Undefined, certified
from corollary.formula.from_sympy import NoTree, tree
from corollary.laws.law import Law, law, own_letters, sides, substitute, symbols

SHORT = 40  # operations: a longer formula is left as it was found, for simplifying it may take minutes
DIGITS = 30
REAL = 1e-18  # an imaginary part so small, of 30 digits, is rounding
INFINITE = (sympy.nan, sympy.oo, -sympy.oo, sympy.zoo)
Values = dict[sympy.Symbol, sympy.Expr]


@dataclass(frozen=True, slots=True)
class NamedEquation:
    """An equation, and the name of the law that it is, or comes from."""

    law: str
    left: sympy.Expr
    right: sympy.Expr

    @property
    def residual(self) -> sympy.Expr:
        return self.left - self.right

    def with_values(self, values: Mapping[Any, sympy.Expr]) -> NamedEquation:
        return NamedEquation(self.law, *(substitute(side, values) for side in (self.left, self.right)))

    def speaks_of(self, letters: Set[sympy.Symbol]) -> bool:
        return bool((self.left.free_symbols | self.right.free_symbols) & letters)

    def at(self, givens: Mapping[str, RationalPi]) -> tuple[float, float] | None:
        """Both sides; None where one is not real."""
        left, right = number_at(self.left, givens), number_at(self.right, givens)
        return None if left is None or right is None else (left, right)


@dataclass(frozen=True, slots=True)
class SystemRoot:
    """A value for each letter that was open, in the givens; `left` are equations of givens alone that must hold besides."""

    values: Mapping[str, sympy.Expr]
    left: tuple[NamedEquation, ...]

    def formula(self, letter: str) -> Expr | None:
        """The short formula for a letter; None where it is no formula of ours (a root of a cubic)."""
        value = self.values[letter]
        try:
            return tree(simplest(value) if sympy.count_ops(value) <= SHORT else value)
        except NoTree:
            return None

    def at(self, givens: Mapping[str, RationalPi]) -> dict[str, float] | None:
        """The value of each letter for these givens; None where one of them is not a real number."""
        found: dict[str, float] = {}
        for letter, value in self.values.items():
            number = number_at(value, givens)
            if number is None:
                return None
            found[letter] = number
        return found


def number_at(value: sympy.Expr, givens: Mapping[str, RationalPi]) -> float | None:
    """The value in doubles; None where it is not real. Certified where it is a formula of ours, else to 30 digits."""
    try:
        return certified(tree(value), givens).value
    except (NoTree, Undefined):
        number = cast(Any, value).subs(
            {
                each: in_sympy(givens[each.name])
                for each in value.free_symbols
                if isinstance(each, sympy.Symbol)
            }
        )
        number = sympy.N(number, DIGITS)
    if not number.is_number or number.is_finite is not True:
        return None
    real, imaginary = number.as_real_imag()
    return float(real) if abs(imaginary) <= REAL * max(abs(real), abs(imaginary)) else None


@contextmanager
def in_letters(givens: Mapping[str, int], unknowns: Sequence[str]) -> Generator[None]:
    """While laws are stated: givens (with the sign that each has for all of its values, or 0) and real unknowns."""
    letters = {name: _given(name, sign) for name, sign in givens.items()}
    with own_letters(letters | {name: sympy.Symbol(name, real=True) for name in unknowns}):
        yield


def stated(
    laws: Sequence[tuple[str, str]], givens: Mapping[str, int], unknowns: Sequence[str]
) -> tuple[Law, ...]:
    """Laws from names and texts, in these letters. Raises ValueError with a sentence for what is no law."""
    with in_letters(givens, unknowns):
        return tuple(law(name, formula) for name, formula in laws)


def system_roots(
    laws: Sequence[Law], unknowns: Sequence[str], at: Mapping[str, RationalPi] | None = None
) -> tuple[SystemRoot, ...]:
    """Every real root of the laws in the unknowns; with `at`, for these values of the givens alone.

    Raises NoRoot where one stays free, or the equations cannot be solved in formulas.
    """
    numbers = {
        symbol: in_sympy(at[symbol.name])
        for each in laws
        for symbol in symbols(each)
        if at and symbol.name in at
    }
    equations = [
        NamedEquation(each.name, left, right).with_values(numbers)
        for each in laws
        for left, right in sides(each)
    ]
    letters = {sympy.Symbol(name, real=True) for name in unknowns}
    found: list[SystemRoot] = []
    for root, left in _with_letters_for_angles(equations, letters) or _solved(equations, letters):
        if free := [each for each in letters if each not in root or root[each].free_symbols & letters]:
            names = ", ".join(sorted(map(str, free)))
            raise NoRoot(f"{len(equations)} equations for {len(letters)} unknowns leave {names} free")
        found.append(
            SystemRoot({name: root[sympy.Symbol(name, real=True)] for name in unknowns}, tuple(left))
        )
    return tuple(found)


def _with_letters_for_angles(
    equations: Sequence[NamedEquation], unknowns: Set[sympy.Symbol]
) -> list[tuple[Values, list[NamedEquation]]]:
    """The roots, sought with a letter for each sine and cosine of a number; none where one of them does not fulfil the equations.

    cos 38° is a root of a polynomial of degree 24, in whose field of numbers the same roots take half a minute.
    """
    back = {
        sympy.Dummy("c", real=True, positive=each.is_positive, negative=each.is_negative): each
        for each in sorted(_functions_of_numbers(equations), key=str)
    }
    if not back:
        return []
    there = {number: letter for letter, number in back.items()}
    try:
        solved = _solved([each.with_values(there) for each in equations], unknowns)
    except NoRoot:
        return []
    found = [
        (
            {symbol: substitute(value, back) for symbol, value in root.items()},
            [each.with_values(back) for each in left],
        )
        for root, left in solved
    ]
    whole = all(_fulfilled(each.with_values(root)) for root, _ in found for each in equations)
    return found if whole else []


def _functions_of_numbers(equations: Sequence[NamedEquation]) -> set[sympy.Expr]:
    return {
        each
        for equation in equations
        for each in equation.residual.atoms(sympy.Function)
        if each.is_number and each.is_real and each.is_zero is False
    }


def _fulfilled(equation: NamedEquation) -> bool:
    """Whether nothing speaks against it: its terms are finite, and their sum is nothing beside them where they are numbers."""
    terms = [sympy.N(each, DIGITS) for each in sympy.Add.make_args(equation.residual)]
    if not all(each.is_number for each in terms):
        return not any(each.has(*INFINITE) for each in terms)
    size = sympy.Add(*(abs(each) for each in terms))
    return size.is_finite is True and bool(abs(sympy.Add(*terms)) <= REAL * size)


def _solved(
    equations: Sequence[NamedEquation], unknowns: Set[sympy.Symbol]
) -> list[tuple[Values, list[NamedEquation]]]:
    """Roots with the equations that are left without unknowns: what one equation tells is put into the others."""
    equations = [each for each in equations if sympy.expand(each.residual) != 0]
    rest = [each for each in equations if each.speaks_of(unknowns)]
    left = [each for each in equations if not each.speaks_of(unknowns)]
    if not rest:
        return [({}, left)]
    chosen = _alone(rest, unknowns) or _linear(rest, unknowns)
    if chosen is None:
        return [(root, left) for root in _together(rest, unknowns)]
    equation, symbol, roots = chosen
    found: list[tuple[Values, list[NamedEquation]]] = []
    for value in roots:
        put_in = [each.with_values({symbol: value}) for each in rest if each is not equation]
        for others, still_left in _solved(put_in, unknowns - {symbol}):
            found.append(({**others, symbol: substitute(value, others)}, left + still_left))
    return found


Chosen = tuple[NamedEquation, sympy.Symbol, list[sympy.Expr]]
"""The equation to solve next, for what, and its roots."""


def _alone(equations: Sequence[NamedEquation], unknowns: Set[sympy.Symbol]) -> Chosen | None:
    """An equation with a single unknown, the shortest that can be solved."""
    for each in sorted(equations, key=_size):
        inside = (each.left.free_symbols | each.right.free_symbols) & unknowns
        if len(inside) == 1:
            (symbol,) = cast("set[sympy.Symbol]", inside)
            try:
                return each, symbol, cast("list[sympy.Expr]", list(sympy.solve(each.residual, symbol)))
            except NotImplementedError:
                continue
    return None


def _linear(equations: Sequence[NamedEquation], unknowns: Set[sympy.Symbol]) -> Chosen | None:
    """An equation linear in an unknown whose coefficient has no other: no root is lost when it is divided by."""
    for each in sorted(equations, key=_size):
        residual = sympy.expand(each.residual)
        for symbol in sorted(cast("set[sympy.Symbol]", residual.free_symbols & unknowns), key=str):
            slope = sympy.diff(residual, symbol)
            if not slope.free_symbols & unknowns and sympy.simplify(slope) != 0:
                return each, symbol, [cast(sympy.Expr, sympy.together(-residual.subs(symbol, 0) / slope))]
    return None


def _together(equations: Sequence[NamedEquation], unknowns: Set[sympy.Symbol]) -> list[Values]:
    inside = sorted(
        {symbol for each in equations for symbol in each.residual.free_symbols & unknowns}, key=str
    )
    try:
        return cast("list[Values]", sympy.solve([each.residual for each in equations], inside, dict=True))
    except NotImplementedError:
        raise NoRoot(f"no formula was found for {', '.join(map(str, inside))}") from None


def _size(equation: NamedEquation) -> int:
    return int(sympy.count_ops(equation.left) + sympy.count_ops(equation.right))


def _given(name: str, sign: int) -> sympy.Symbol:
    return sympy.Symbol(
        name, real=True, **({"positive": True} if sign > 0 else {"negative": True} if sign < 0 else {})
    )
