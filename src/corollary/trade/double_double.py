"""Numbers of twice the digits: an unevaluated sum of two doubles, the second at most half a last place of the first.

Source: T. J. Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971) 224.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

SPLITTER = 134217729.0  # 2^27 + 1 parts a double into two halves whose products are exact


@dataclass(frozen=True, slots=True)
class DoubleDouble:
    """About 32 digits, in the range of the doubles."""

    high: float
    low: float = 0.0

    @classmethod
    def of(cls, value: Fraction) -> DoubleDouble:
        high = float(value)
        return cls(high, float(value - Fraction(high)))

    def __neg__(self) -> DoubleDouble:
        return DoubleDouble(-self.high, -self.low)

    def __abs__(self) -> DoubleDouble:
        return -self if self.high < 0.0 else self

    def __add__(self, other: DoubleDouble) -> DoubleDouble:
        total, left = _sum(self.high, other.high)
        small, least = _sum(self.low, other.low)
        total, left = _short_sum(total, left + small)
        return DoubleDouble(*_short_sum(total, left + least))

    def __sub__(self, other: DoubleDouble) -> DoubleDouble:
        return self + -other

    def __mul__(self, other: DoubleDouble) -> DoubleDouble:
        product, left = _product(self.high, other.high)
        return DoubleDouble(*_short_sum(product, left + (self.high * other.low + self.low * other.high)))

    def __truediv__(self, other: DoubleDouble) -> DoubleDouble:
        first = self.high / other.high
        rest = self - other * DoubleDouble(first)
        second = rest.high / other.high
        rest = rest - other * DoubleDouble(second)
        return DoubleDouble(*_short_sum(first, second)) + DoubleDouble(rest.high / other.high)

    def __pow__(self, whole: int) -> DoubleDouble:
        result = DoubleDouble(1.0)
        for _ in range(abs(whole)):
            result = result * self
        return DoubleDouble(1.0) / result if whole < 0 else result

    def __float__(self) -> float:
        return self.high + self.low


PI = DoubleDouble(3.141592653589793, 1.2246467991473532e-16)


def root(square: DoubleDouble) -> DoubleDouble:
    """The square root: that of the first double, and one step of Newton's method."""
    guess = math.sqrt(square.high)
    if guess == 0.0:
        return DoubleDouble(0.0)
    rest = square - DoubleDouble(guess) * DoubleDouble(guess)
    return DoubleDouble(*_short_sum(guess, 0.5 * rest.high / guess))


def _sum(a: float, b: float) -> tuple[float, float]:
    total = a + b
    part = total - a
    return total, (a - (total - part)) + (b - part)


def _short_sum(a: float, b: float) -> tuple[float, float]:
    """The sum of two doubles of which the first is the larger."""
    total = a + b
    return total, b - (total - a)


def _product(a: float, b: float) -> tuple[float, float]:
    product = a * b
    a1, a2 = _halves(a)
    b1, b2 = _halves(b)
    return product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2


def _halves(a: float) -> tuple[float, float]:
    spread = SPLITTER * a
    high = spread - (spread - a)
    return high, a - high
