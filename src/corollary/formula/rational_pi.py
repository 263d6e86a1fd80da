"""Numbers q·π^n: the fractions, and what becomes of them in sums, products, powers and functions of angles, exactly."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

MOST_BITS = 20_000  # beyond, a fraction is given up: 9^9^9 has 370 million digits

ZERO, HALF = Fraction(0), Fraction(1, 2)
SINES = {ZERO: ZERO, Fraction(1, 6): HALF, HALF: Fraction(1), Fraction(5, 6): HALF, Fraction(1): ZERO}
"""sin(pi x) where it is rational, for x from 0 to 1 (Niven's theorem: there are no others)."""
TANGENTS = {ZERO: ZERO, Fraction(1, 4): Fraction(1), Fraction(3, 4): Fraction(-1)}
"""tan(pi x) where it is rational, for x from 0 to 1 (by the same theorem)."""


class Irrational(ArithmeticError):
    """The result is no fraction times a power of pi, has no value, or has too many digits."""


@dataclass(frozen=True, slots=True)
class RationalPi:
    """The number `ratio` times pi to the power `pi`. Operations raise Irrational."""

    ratio: Fraction
    pi: int = 0

    def __float__(self) -> float:
        """The nearest double but one or two. Raises OverflowError beyond the doubles."""
        return float(self.ratio) * math.pi**self.pi

    def __neg__(self) -> RationalPi:
        return RationalPi(-self.ratio, self.pi)

    def __add__(self, other: RationalPi) -> RationalPi:
        if self.ratio and other.ratio and self.pi != other.pi:
            raise Irrational
        return _bounded(self.ratio + other.ratio, self.pi if self.ratio else other.pi)

    def __sub__(self, other: RationalPi) -> RationalPi:
        return self + -other

    def __mul__(self, other: RationalPi) -> RationalPi:
        return _bounded(self.ratio * other.ratio, self.pi + other.pi)

    def __truediv__(self, other: RationalPi) -> RationalPi:
        return self * other**MINUS_ONE

    def __pow__(self, exponent: RationalPi) -> RationalPi:
        power = exponent.ratio
        if exponent.pi or (self.ratio == 0 and power < 0):
            raise Irrational
        if power.denominator > 64 or power.numerator.bit_length() > 12:
            raise Irrational
        bits = max(self.ratio.numerator.bit_length(), self.ratio.denominator.bit_length())
        if bits * abs(power) > MOST_BITS or (self.pi * power).denominator != 1:
            raise Irrational
        root = self.ratio if power.denominator == 1 else _root(self.ratio, power.denominator)
        return _bounded(root**power.numerator, int(self.pi * power))


NOTHING = RationalPi(ZERO)
ONE = RationalPi(Fraction(1))
MINUS_ONE = RationalPi(Fraction(-1))
PI = RationalPi(Fraction(1), 1)


def _bounded(ratio: Fraction, pi: int) -> RationalPi:
    """The number, 0 without any pi. Raises Irrational where its fraction has become too long."""
    if ratio == 0:
        return NOTHING
    if max(ratio.numerator.bit_length(), ratio.denominator.bit_length()) >= MOST_BITS:
        raise Irrational
    return RationalPi(ratio, pi)


def _root(ratio: Fraction, degree: int) -> Fraction:
    if ratio < 0:
        raise Irrational
    top, bottom = whole_root(ratio.numerator, degree), whole_root(ratio.denominator, degree)
    if top**degree != ratio.numerator or bottom**degree != ratio.denominator:
        raise Irrational
    return Fraction(top, bottom)


def whole_root(number: int, degree: int) -> int:
    """The largest whole number whose power does not exceed `number` (Newton from above)."""
    if degree == 2:
        return math.isqrt(number)
    guess = 1 << -(-number.bit_length() // degree)
    while guess and (step := ((degree - 1) * guess + number // guess ** (degree - 1)) // degree) < guess:
        guess = step
    return guess


def sine(angle: RationalPi) -> RationalPi | None:
    """The sine of a rational share of pi, where it is rational."""
    return _sine_of_turn(angle.ratio % 2) if angle.pi == 1 or not angle.ratio else None


def cosine(angle: RationalPi) -> RationalPi | None:
    """The cosine of a rational share of pi, where it is rational."""
    return _sine_of_turn((angle.ratio + HALF) % 2) if angle.pi == 1 or not angle.ratio else None


def tangent(angle: RationalPi) -> RationalPi | None:
    """The tangent of a rational share of pi, where it is rational."""
    known = TANGENTS.get(angle.ratio % 1) if angle.pi == 1 or not angle.ratio else None
    return None if known is None else RationalPi(known)


def _sine_of_turn(turn: Fraction) -> RationalPi | None:
    found = SINES.get(turn) if turn <= 1 else SINES.get(turn - 1)
    return None if found is None else RationalPi(found if turn <= 1 else -found)


def arc_sine(x: RationalPi) -> RationalPi | None:
    """The angle between -pi/2 and pi/2 whose sine is x, where it is a rational share of pi."""
    if x.pi:
        return None
    known = next((turn for turn, value in SINES.items() if value == abs(x.ratio) and turn <= HALF), None)
    return None if known is None else _bounded(known if x.ratio >= 0 else -known, 1)


def arc_cosine(x: RationalPi) -> RationalPi | None:
    """The angle between 0 and pi whose cosine is x, where it is a rational share of pi."""
    found = arc_sine(x)
    return None if found is None else _bounded(HALF - found.ratio, 1)


def arc_tangent(x: RationalPi) -> RationalPi | None:
    """The angle between -pi/2 and pi/2 whose tangent is x, where it is a rational share of pi."""
    if x.pi or abs(x.ratio) not in (0, 1):
        return None
    return _bounded(x.ratio / 4, 1)


def smallest(*numbers: RationalPi) -> RationalPi | None:
    """The least of them; None where their powers of pi differ."""
    alike = len({each.pi for each in numbers if each.ratio}) < 2
    return min(numbers, key=lambda each: each.ratio) if alike else None


def largest(*numbers: RationalPi) -> RationalPi | None:
    """The greatest of them; None where their powers of pi differ."""
    alike = len({each.pi for each in numbers if each.ratio}) < 2
    return max(numbers, key=lambda each: each.ratio) if alike else None
