"""Formulas as plain text that can be read again: `m*v/dt`, `sqrt(2*g*h)`."""

from __future__ import annotations

from fractions import Fraction
from typing import assert_never

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum
from corollary.formula.numerals import decimal_text

COMPARE, ADD, TIMES, RAISE, ATOM = range(5)  # how tightly a formula holds together


def text(tree: Expr) -> str:
    """The formula in ASCII, its form kept; reading it as an author's formula gives the same tree back."""
    return _text(tree)[0]


def _text(tree: Expr) -> tuple[str, int]:
    match tree:
        case Number(value, figures):
            return _number_text(value, figures)
        case Name(name):
            return name, ATOM
        case Negative(term):
            return "-" + within(term, TIMES), ADD
        case Sum(terms):
            return _sum_text(terms), ADD
        case Product(factors):
            return "*".join(within(factor, RAISE) for factor in factors), TIMES
        case Quotient(top, bottom):
            return f"{within(top, TIMES)}/{within(bottom, RAISE)}", TIMES
        case Power(base, exponent):
            return f"{within(base, ATOM)}^{within(exponent, RAISE)}", RAISE
        case Call(function, arguments):
            return f"{function}({', '.join(text(argument) for argument in arguments)})", ATOM
        case Relation(sign, left, right):
            return f"{within(left, ADD)} {sign} {within(right, ADD)}", COMPARE
        case _:
            assert_never(tree)


def within(tree: Expr, hold: int) -> str:
    """In brackets unless the formula holds together at least so tightly."""
    written, own = _text(tree)
    return written if own >= hold else f"({written})"


def _number_text(value: Fraction, figures: int) -> tuple[str, int]:
    """A decimal when its figures say all of it, else a fraction."""
    if figures and value > 0:
        written = decimal_text(value, figures)
        if written.isdecimal():  # 1200 with two figures
            written = f"{written[0]}{'.' * (figures > 1)}{written[1:figures]}e{len(written) - 1}"
        if Fraction(written) == value:
            return written, ATOM
    return str(value), ADD if value < 0 else ATOM if value.denominator == 1 else TIMES


def _sum_text(terms: tuple[Expr, ...]) -> str:
    written = within(terms[0], TIMES) if not isinstance(terms[0], Negative) else _text(terms[0])[0]
    for term in terms[1:]:
        written += (
            f" - {within(term.term, TIMES)}" if isinstance(term, Negative) else f" + {within(term, TIMES)}"
        )
    return written
