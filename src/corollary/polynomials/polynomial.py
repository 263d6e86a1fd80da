"""Polynomials with whole coefficients, of bounded size."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false, reportMissingTypeStubs=false

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, TypeAlias

from flint import Ordering, fmpq_mpoly_ctx, fmpz_mpoly_ctx

Polynomial: TypeAlias = Any
"""flint's `fmpz_mpoly`, whose types lack some of what it can do."""

# A derivation on paper has polynomials of some fifty terms; thousands are made by nobody but to find out what happens.
MOST_TERMS = 1500
LARGEST_DEGREE = 60
MOST_BITS = 20000


class TooLarge(ArithmeticError):
    """The polynomials grow beyond what is worked with: nothing is decided."""


def context(names: tuple[str, ...]) -> Any:
    """Polynomials with whole coefficients in these letters."""
    return fmpz_mpoly_ctx.get(names, Ordering.degrevlex)


def product(left: Polynomial, right: Polynomial) -> Polynomial:
    """Raises TooLarge before anything large is made."""
    if len(left) * len(right) > 20 * MOST_TERMS or _degree(left) + _degree(right) > LARGEST_DEGREE:
        raise TooLarge
    return checked(left * right)


def power(base: Polynomial, exponent: int) -> Polynomial:
    """Raises TooLarge before anything large is made."""
    if _degree(base) * exponent > LARGEST_DEGREE or exponent > 4 * LARGEST_DEGREE:
        raise TooLarge
    made = base.context().constant(1)
    for _factor in range(exponent):
        made = product(made, base)
    return made


def checked(polynomial: Polynomial) -> Polynomial:
    """The polynomial, if it is of bounded size. Raises TooLarge."""
    if len(polynomial) > MOST_TERMS or _degree(polynomial) > LARGEST_DEGREE:
        raise TooLarge
    if any(int(each).bit_length() > MOST_BITS for each in polynomial.coeffs()):
        raise TooLarge
    return polynomial


def factored(polynomial: Polynomial) -> tuple[int, list[tuple[Polynomial, int]]]:
    """A whole number, and irreducible factors with their exponents, whose product is the polynomial."""
    try:
        content, found = polynomial.factor()
    except (
        OverflowError
    ):  # flint puts factors in order by coefficients as C integers; over fractions it does not
        return _factored_in_fractions(polynomial)
    return int(content), found


def _factored_in_fractions(polynomial: Polynomial) -> tuple[int, list[tuple[Polynomial, int]]]:
    ours = polynomial.context()
    fractions = fmpq_mpoly_ctx.get(ours.names(), Ordering.degrevlex)
    content, found = fractions.from_dict(polynomial.to_dict()).factor()
    scale, factors = Fraction(int(content.p), int(content.q)), list[tuple[Polynomial, int]]()
    for factor, exponent in found:
        terms = {place: Fraction(int(each.p), int(each.q)) for place, each in factor.to_dict().items()}
        below = math.lcm(*(each.denominator for each in terms.values()))
        shared = Fraction(math.gcd(*(int(each * below) for each in terms.values())), below)
        whole = {place: int(each / shared) for place, each in terms.items()}
        factors.append((ours.from_dict(whole), int(exponent)))
        scale *= shared**exponent
    return int(scale), factors  # whole by Gauss's lemma: the factors have no divisor


def _degree(polynomial: Polynomial) -> int:
    return 0 if polynomial.is_zero() else int(polynomial.total_degree())
