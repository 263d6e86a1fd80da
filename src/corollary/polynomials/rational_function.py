"""Quotients of two polynomials, in lowest terms and of bounded size."""

from __future__ import annotations

from dataclasses import dataclass

from corollary.formula.errors import Undefined
from corollary.polynomials.polynomial import Polynomial, checked, power, product


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
