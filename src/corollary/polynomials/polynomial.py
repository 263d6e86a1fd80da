"""Polynomials with whole coefficients, of bounded size, and quotients of two of them in lowest terms."""

# pyright: reportMissingTypeStubs=false, reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction
from typing import Any, TypeAlias

from flint import Ordering, fmpq_mpoly_ctx, fmpz_mpoly_ctx

from corollary.formula.errors import Undefined

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


@dataclass(frozen=True, slots=True)
class RationalFunction:
    """`top/bottom`, without a common factor; the bottom is never the polynomial 0."""

    top: Polynomial
    bottom: Polynomial

    def __add__(self, other: RationalFunction) -> RationalFunction:
        if self.bottom == other.bottom:
            return reduced(self.top + other.top, self.bottom)
        shared = self.bottom.gcd(other.bottom)
        mine, theirs = self.bottom / shared, other.bottom / shared
        return reduced(product(self.top, theirs) + product(other.top, mine), product(self.bottom, theirs))

    def __neg__(self) -> RationalFunction:
        return RationalFunction(-self.top, self.bottom)

    def __sub__(self, other: RationalFunction) -> RationalFunction:
        return self + -other

    def __mul__(self, other: RationalFunction) -> RationalFunction:
        return reduced(product(self.top, other.top), product(self.bottom, other.bottom))

    def inverse(self) -> RationalFunction:
        """Raises Undefined for 1/0."""
        if self.top.is_zero():
            raise Undefined("a divisor is zero")
        return RationalFunction(self.bottom, self.top)

    def __pow__(self, exponent: int) -> RationalFunction:
        base = self if exponent >= 0 else self.inverse()
        return RationalFunction(power(base.top, abs(exponent)), power(base.bottom, abs(exponent)))


def reduced(top: Polynomial, bottom: Polynomial) -> RationalFunction:
    """In lowest terms. Raises TooLarge."""
    if top.is_zero():
        return RationalFunction(top, top.context().constant(1))
    shared = top.gcd(bottom)
    return RationalFunction(checked(top / shared), checked(bottom / shared))
