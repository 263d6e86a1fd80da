"""The dimension of a formula, from those of its letters: metres are never added to seconds."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import assert_never

from corollary.formula.arithmetics import constant, exactly
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
    map_children,
    names,
    unsigned,
    walk,
)
from corollary.formula.errors import ParseError, refused
from corollary.formula.functions import FUNCTIONS
from corollary.formula.plain_text import text
from corollary.formula.rational_pi import RationalPi
from corollary.messages import N_, catalogue
from corollary.units.unit import ONE, Dimension, show, si_unit

_ = catalogue(__name__)

ADDED = N_("{one} and {other} cannot be added")
COMPARED = N_("{one} and {other} cannot be compared")
EXPONENT = N_("{part} cannot be an exponent")
INSIDE = N_("{part} cannot be inside {function}")

Found = Dimension | None  # None is the dimension of 0: it may be added to whatever it stands beside


EXPONENTS = (
    tuple(Fraction(each, 101) for each in (137, 251, 389, 523, 661, 797)),
    tuple(Fraction(each, 89) for each in (173, 277, 359, 487, 743, 911)),
)
"""Numbers in place of the letters of exponents, between which nobody's law has a relation."""


class _Mismatch(Exception):
    def __init__(self, why: str, letter_in_exponent: bool = False) -> None:
        self.why = why
        self.letter_in_exponent = letter_in_exponent


def dimension_of(tree: Expr, dimensions: Mapping[str, Dimension]) -> Dimension | ParseError:
    """The dimension of a formula; of a comparison, that of its sides. 0 counts as a plain number.

    A quantity may have letters in its exponent where the units come out alike whatever their numbers are, as in
    T*V^(k-1)/W^(k-1). Letters that are not in `dimensions` raise KeyError.
    """
    try:
        return _dimension(tree, dimensions) or ONE
    except _Mismatch as mismatch:
        found = _whatever_the_exponents(tree, dimensions) if mismatch.letter_in_exponent else None
        return found or refused(mismatch.why, None, _("look at the units of each term"))


def _whatever_the_exponents(tree: Expr, dimensions: Mapping[str, Dimension]) -> Dimension | None:
    """The dimension that a formula has with some numbers in its exponents and with others; None where these are not the same.

    Powers of units are linear in the exponents: where two sets of odd numbers agree, all do. Of a comparison each set need
    only make the sides alike.
    """
    found: list[Dimension] = []
    exponents = [each.exponent for each in walk(tree) if isinstance(each, Power)]
    inside = names(*exponents)
    letters = sorted(name for name in inside if name == "pi" or dimensions[name] == ONE)
    if len(letters) > len(EXPONENTS[0]):
        return None
    for primes in EXPONENTS:
        values = {name: RationalPi(prime) for name, prime in zip(letters, primes, strict=False)}
        try:
            found.append(_dimension(_with_exponents(tree, values), dimensions) or ONE)
        except _Mismatch:
            return None
    return found[0] if isinstance(tree, Relation) or len(set(found)) == 1 else None


def _with_exponents(tree: Expr, values: Mapping[str, RationalPi]) -> Expr:
    if isinstance(tree, Power) and constant(tree.exponent) is None:
        power = exactly(tree.exponent, values)
        if power is not None and not power.pi:
            return Power(_with_exponents(tree.base, values), Number(power.ratio))
    return map_children(tree, lambda part: _with_exponents(part, values))


def _dimension(tree: Expr, of: Mapping[str, Dimension]) -> Found:
    match tree:
        case Number(value):
            return ONE if value else None
        case Name(name):
            return ONE if name == "pi" and name not in of else of[name]
        case Negative(term):
            return _dimension(term, of)
        case Sum(terms):
            return _same(terms, of, ADDED)
        case Product(factors):
            found = [_dimension(factor, of) for factor in factors]
            product = ONE
            for each in found:
                product = product * (each or ONE)
            return None if None in found else product
        case Quotient(top, bottom):
            above, below = _dimension(top, of), _dimension(bottom, of)
            return None if above is None else above / (below or ONE)
        case Power(base, exponent):
            return _power(base, exponent, of)
        case Call(function, arguments):
            return _call(function, arguments, of)
        case Relation(_, left, right):
            return _same((left, right), of, COMPARED)
        case _:
            assert_never(tree)


def _same(terms: tuple[Expr, ...], of: Mapping[str, Dimension], unlike: str) -> Found:
    common: Found = None
    first = terms[0]
    for term in terms:
        found = _dimension(term, of)
        if common is None:
            common, first = found, term
        elif found is not None and found != common:
            raise _Mismatch(_(unlike, one=_described(first, common), other=_described(term, found)))
    return common


def _described(tree: Expr, dimension: Dimension) -> str:
    unit = show(si_unit(dimension)) or _("a plain number")
    return f"{text(unsigned(tree))} ({unit})"


def _check_dimensionless(tree: Expr, of: Mapping[str, Dimension], misplaced: str, function: str = "") -> None:
    found = _dimension(tree, of)
    if found is not None and found != ONE:
        raise _Mismatch(_(misplaced, part=_described(tree, found), function=function))


def _power(base: Expr, exponent: Expr, of: Mapping[str, Dimension]) -> Found:
    _check_dimensionless(exponent, of, EXPONENT)
    below, power = _dimension(base, of), constant(exponent)
    if below is None or below == ONE:
        return None if below is None and power != 0 else ONE
    if power is None:
        raise _Mismatch(
            _("{part} can only have a number as its exponent", part=_described(base, below)),
            letter_in_exponent=True,
        )
    return below**power


def _call(function: str, arguments: tuple[Expr, ...], of: Mapping[str, Dimension]) -> Found:
    power = FUNCTIONS[function].dimension
    if power is None:
        for argument in arguments:
            _check_dimensionless(argument, of, INSIDE, function)
        return ONE
    common = _same(arguments, of, COMPARED)
    return ONE if power == 0 else None if common is None else common**power
