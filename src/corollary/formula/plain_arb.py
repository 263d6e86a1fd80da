"""Interval arithmetic in plain Python with python-flint's names (`arb`, `fmpq`, `ctx`), for a browser."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from fractions import Fraction
from functools import cache
from typing import Self

from corollary.formula.rational_pi import whole_root

FINEST = 32  # bits of how far a value may be off


# Roots, constants and series to as many bits as wanted, in whole numbers of 2^-bits.


def fixed(whole: int, exponent: int, bits: int) -> int:
    """In units of 2^-bits."""
    up = exponent + bits
    return whole << up if up >= 0 else whole >> -up


@cache
def pi(bits: int) -> int:
    """Machin's formula."""
    more = bits + 16
    return 4 * (4 * _arc(5, more, -1) - _arc(239, more, -1)) >> 16


@cache
def log2(bits: int) -> int:
    more = bits + 16
    return 18 * _arc(26, more, 1) - 2 * _arc(4801, more, 1) + 8 * _arc(8749, more, 1) >> 16


def _arc(inverse: int, bits: int, sign: int) -> int:
    """The inverse tangent of 1/inverse, or with the sign 1 the hyperbolic one."""
    term = (1 << bits) // inverse
    total, place = term, 1
    while term:
        term //= sign * inverse * inverse
        place += 2
        total += term // place
        if term == -1:
            break
    return total


def exp(number: int, bits: int) -> int:
    total = term = 1 << bits
    place = 0
    while term not in (0, -1):
        place += 1
        term = (term * number >> bits) // place
        total += term
    return total


def sine_and_cosine(number: int, bits: int) -> tuple[int, int]:
    """Of an angle of at most about 1 rad."""
    square = number * number >> bits
    sine = term = number
    cosine = even = 1 << bits
    place = 0
    while even or term not in (0, -1):
        place += 2
        even = -(even * square >> bits) // (place * (place - 1))
        term = -(term * square >> bits) // (place * (place + 1))
        cosine, sine = cosine + even, sine + term
        if abs(even) <= 1 and abs(term) <= 1:
            break
    return sine, cosine


class Context:
    """The working precision, in bits."""

    prec: int = 64


ctx = Context()


class DyadicBall(ABC):
    """`whole` times two to the power `exponent`, off by `off` such units at most; with `off` below 0 nothing is known of it."""

    __slots__ = ("exponent", "off", "whole")

    def __init__(self, value: DyadicBall | float | Fraction | str = 0, error: float = 0.0) -> None:
        self.whole, self.off, self.exponent = 0, 0, 0
        match value:
            case DyadicBall():
                self._take(value)
            case int():
                self.whole = value
            case float() if math.isfinite(value):
                top, bottom = value.as_integer_ratio()
                self.whole, self.exponent = top, 1 - bottom.bit_length()
            case Fraction():
                self._take(self.of(value.numerator) / value.denominator)
            case _:
                self.off = -1
        if error:
            self._take(self + self.wider(type(self)(error)))

    def _take(self, other: DyadicBall) -> None:
        self.whole, self.off, self.exponent = other.whole, other.off, other.exponent

    @classmethod
    def of(cls, whole: int, off: int = 0, exponent: int = 0) -> Self:
        made = cls()
        made.whole, made.off, made.exponent = whole, off, exponent
        return made

    @classmethod
    def nothing(cls) -> Self:
        """What has no value, or one of which nothing is known."""
        return cls.of(0, -1)

    @classmethod
    def rounded(cls, whole: int, off: int, exponent: int) -> Self:
        """To the bits that are set."""
        spare = max(whole.bit_length() - ctx.prec, off.bit_length() - FINEST)
        if spare > 0:
            exact = not off and not whole & ((1 << spare) - 1)
            whole, off, exponent = whole >> spare, 0 if exact else (off >> spare) + 2, exponent + spare
        return cls.of(whole, off, exponent)

    @classmethod
    def between(cls, low: DyadicBall, high: DyadicBall) -> Self:
        """The ball around two exact ones."""
        if low.off < 0 or high.off < 0:
            return cls.nothing()
        least = min(low.exponent, high.exponent) - 1
        bottom, top = low.whole << (low.exponent - least), high.whole << (high.exponent - least)
        return cls.rounded((bottom + top) >> 1, (top - bottom) >> 1, least)

    @classmethod
    def wider(cls, size: DyadicBall) -> Self:
        """From minus so much to so much."""
        most = abs(size).upper()
        return cls.of(0, most.whole, most.exponent) if most.off >= 0 else cls.nothing()

    def is_finite(self) -> bool:
        return self.off >= 0

    def is_zero(self) -> bool:
        return self.whole == 0 == self.off

    def is_integer(self) -> bool:
        return self.off == 0 and (self.exponent >= 0 or self.whole % (1 << -self.exponent) == 0)

    def contains(self, number: int) -> bool:
        return not (self < number or self > number)

    def contains_integer(self) -> bool:
        if self.off < 0 or self.exponent >= 0:
            return True
        unit = 1 << -self.exponent
        return (self.whole + self.off) // unit >= -((self.off - self.whole) // unit)

    def overlaps(self, other: DyadicBall) -> bool:
        return not (self < other or self > other)

    def mid(self) -> Self:
        return self.of(self.whole, min(self.off, 0), self.exponent)

    def lower(self) -> Self:
        return self.of(self.whole - self.off, 0, self.exponent) if self.off >= 0 else self

    def upper(self) -> Self:
        return self.of(self.whole + self.off, 0, self.exponent) if self.off >= 0 else self

    def width(self) -> Self:
        """How far the value may lie from the middle."""
        return self.of(self.off, 0, self.exponent)

    def size(self) -> int:
        """The power of two that it stays below."""
        return (abs(self.whole) + self.off).bit_length() + self.exponent

    def union(self, other: DyadicBall) -> Self:
        return self.between(_smaller(self.lower(), other.lower()), _larger(self.upper(), other.upper()))

    def min(self, other: DyadicBall) -> Self:
        return self.between(_smaller(self.lower(), other.lower()), _smaller(self.upper(), other.upper()))

    def max(self, other: DyadicBall) -> Self:
        return self.between(_larger(self.lower(), other.lower()), _larger(self.upper(), other.upper()))

    def __float__(self) -> float:
        if self.off < 0:
            return math.nan
        size, exponent = abs(self.whole), self.exponent
        if (spare := size.bit_length() - 64) > 0:  # the last bit stands for all that is cut off
            size, exponent = size >> spare | bool(size & ((1 << spare) - 1)), exponent + spare
        try:
            return math.copysign(math.ldexp(float(size), exponent), self.whole)
        except OverflowError:
            return math.copysign(math.inf, self.whole)

    def __lt__(self, other: DyadicBall | float) -> bool:
        return _sign(self.upper(), self._same(other).lower()) == -1

    def __gt__(self, other: DyadicBall | float) -> bool:
        return _sign(self.lower(), self._same(other).upper()) == 1

    def __le__(self, other: DyadicBall | float) -> bool:
        return _sign(self.upper(), self._same(other).lower()) in (-1, 0)

    def __ge__(self, other: DyadicBall | float) -> bool:
        return _sign(self.lower(), self._same(other).upper()) in (1, 0)

    def __neg__(self) -> Self:
        return self.of(-self.whole, self.off, self.exponent)

    def __abs__(self) -> Self:
        if self.off < 0 or abs(self.whole) >= self.off:
            return self.of(abs(self.whole), self.off, self.exponent)
        return self.between(self.of(0), self.of(abs(self.whole) + self.off, 0, self.exponent))

    def __add__(self, other: DyadicBall | float) -> Self:
        high, low = self, self._same(other)
        if high.off < 0 or low.off < 0:
            return self.nothing()
        if high.exponent < low.exponent:
            high, low = low, high
        up = high.exponent - low.exponent
        enough = max(0, 2 * ctx.prec + low.whole.bit_length() - high.whole.bit_length()) + 64
        if up > enough and high.whole and low.off.bit_length() <= low.whole.bit_length():
            wide = up - enough  # far below: no more than a unit
            low = self.of(low.whole >> wide, (low.off >> wide) + 2, low.exponent + wide)
            up = enough
        return self.rounded((high.whole << up) + low.whole, (high.off << up) + low.off, low.exponent)

    __radd__ = __add__

    def __sub__(self, other: DyadicBall | float) -> Self:
        return self + -self._same(other)

    def __rsub__(self, other: float) -> Self:
        return self._same(other) - self

    def __mul__(self, other: DyadicBall | float) -> Self:
        right = self._same(other)
        if self.off < 0 or right.off < 0:
            return self.nothing()
        off = abs(self.whole) * right.off + abs(right.whole) * self.off + self.off * right.off
        return self.rounded(self.whole * right.whole, off, self.exponent + right.exponent)

    __rmul__ = __mul__

    def __truediv__(self, other: DyadicBall | float) -> Self:
        below = self._same(other)
        size = abs(below.whole)
        if self.off < 0 or below.off < 0 or size <= below.off:
            return self.nothing()
        up = max(0, ctx.prec + 8 + size.bit_length() - self.whole.bit_length())
        found, rest = divmod(self.whole << up, below.whole)
        off = self.off * size + abs(self.whole) * below.off
        if off:
            off = (off << up) // (size * (size - below.off)) + 1
        return self.rounded(found, off + bool(rest), self.exponent - below.exponent - up)

    def __rtruediv__(self, other: float) -> Self:
        return self._same(other) / self

    def floor(self) -> Self:
        """The whole numbers that the numbers of the ball are rounded down to."""
        if self.off < 0 or self.exponent >= 0:
            return self
        low, high = self.whole - self.off >> -self.exponent, self.whole + self.off >> -self.exponent
        return self.of(low) if low == high else self.between(self.of(low), self.of(high))

    @abstractmethod
    def sqrt(self) -> Self: ...

    def power(self, whole: int) -> Self:
        result, square, left = self.of(1), self, abs(whole)
        while left:
            if left & 1:
                result = result * square
            square, left = square * square if left > 1 else square, left >> 1
        return 1 / result if whole < 0 else result

    def root(self, degree: int) -> Self:
        """Of a ball above 0, or of 0 itself."""
        if self.is_zero():
            return self
        least = self.whole - self.off
        if self.off < 0 or least <= 0:
            return self.nothing()
        up = max(0, degree * (ctx.prec + 8) - self.whole.bit_length())
        up += (self.exponent - up) % degree
        raised = self.whole << up
        found = whole_root(raised, degree)
        off = -(-(found + 1) * self.off // least) + (found**degree != raised)
        return self.rounded(found, off, (self.exponent - up) // degree)

    def _same(self, other: DyadicBall | float) -> Self:
        return other if isinstance(other, type(self)) else type(self)(other)


def _sign(left: DyadicBall, right: DyadicBall) -> int | None:
    """Of the difference of two exact balls; None where it is not known."""
    if left.off < 0 or right.off < 0:
        return None
    least = min(left.exponent, right.exponent)
    difference = (left.whole << (left.exponent - least)) - (right.whole << (right.exponent - least))
    return (difference > 0) - (difference < 0)


def _smaller(left: DyadicBall, right: DyadicBall) -> DyadicBall:
    return left if _sign(left, right) in (-1, None) else right


def _larger(left: DyadicBall, right: DyadicBall) -> DyadicBall:
    return left if _sign(left, right) in (1, None) else right


__all__ = ["arb", "ctx", "fmpq"]

GUARD = 24  # bits worked with beyond those asked for
UNSURE = 1 << 12  # the last places, of those, that series and constants may miss
LARGEST = 1 << 12  # an argument of sine beyond 2^4096 has no angle that one could find
STEEPEST = 24  # nor has an argument of the exponential beyond 2^24 a use
SETTLED = 1 << 8
GAMMA_OFF = 1e-12  # Python's is right to a few units of 1e-16


def fmpq(numerator: int, denominator: int) -> Fraction:
    """What flint calls a rational."""
    return Fraction(numerator, denominator)


class arb(DyadicBall):
    """A ball with the functions of formulas; not finite where it has no value, or none is found."""

    __slots__ = ()

    @classmethod
    def pi(cls) -> Self:
        bits = ctx.prec + GUARD
        return cls.rounded(pi(bits), UNSURE, -bits)

    @classmethod
    def const_log10(cls) -> Self:
        return cls(10).log()

    def __pow__(self, power: int | arb) -> Self:
        if isinstance(power, int):
            return self.power(power)
        if power.is_integer() and abs(power) < 1 << 20:
            return self.power(int(float(power)))
        return (self.log() * power).exp()

    def sqrt(self) -> Self:
        return self.root(2)

    def exp(self) -> Self:
        size = max(0, self.size())
        if self.off < 0 or size > STEEPEST or self.width() > 1:
            return self.nothing()
        if self.is_zero():
            return self.of(1)
        bits = ctx.prec + GUARD + size
        twos, rest = divmod(fixed(self.whole, self.exponent, bits), log2(bits))
        found = self.rounded(exp(rest, bits), UNSURE << size, twos - bits)
        return found * (1 + self.wider(2 * self.width()))  # e^r - 1 < 2 r up to 1

    def log(self) -> Self:
        if self.off < 0 or self.whole <= self.off:
            return self.nothing()
        bits, length = ctx.prec + GUARD, self.whole.bit_length()
        number = fixed(self.whole, -length, bits)  # from a half to one
        guess = self._fixed(math.log(number / (1 << bits)), bits)
        change = before = 1 << bits
        while abs(change) > SETTLED:
            power = exp(guess, bits)
            change = ((number - power) << (bits + 1)) // (number + power)
            guess += change
            if abs(change) >= before:
                break
            before = abs(change)
        twos = self.rounded(log2(bits), UNSURE, -bits) * (self.exponent + length)
        found = self.rounded(guess, 2 * abs(change) + UNSURE, -bits) + twos
        return found + self.wider(self.of(self.off) / (self.whole - self.off))

    def sin(self) -> Self:
        return self._turned(0)

    def cos(self) -> Self:
        return self._turned(1)

    def tan(self) -> Self:
        return self.sin() / self.cos()

    def _turned(self, quarters: int) -> Self:
        """The sine so many quarters of a turn further."""
        if self.off < 0 or self.is_zero():
            return self.of(quarters) if self.off == 0 else self
        size = self.size()
        if abs(size) > LARGEST:
            return self.wider(self.of(1)) if size > 0 or quarters else self + self.wider(self * self)
        bits = ctx.prec + GUARD + abs(size)
        half = pi(bits) >> 1
        turns, rest = divmod(fixed(self.whole, self.exponent, bits) + (half >> 1), half)
        sine, cosine = sine_and_cosine(rest - (half >> 1), bits)
        found = (sine, cosine, -sine, -cosine)[(turns + quarters) % 4]
        return self.rounded(found, UNSURE << max(0, size), -bits) + self.wider(self.width())

    def atan(self) -> Self:
        if self.off < 0 or self.is_zero():
            return self
        if abs(self) > 1:
            quarter = self.pi() / 2
            return (quarter if self.whole > 0 else -quarter) - (1 / self).atan()
        bits = ctx.prec + GUARD + min(LARGEST, max(0, -self.size()))
        number = fixed(self.whole, self.exponent, bits)
        guess = self._fixed(math.atan(number / (1 << bits)), bits)
        change = before = 1 << bits
        while abs(change) > SETTLED:
            sine, cosine = sine_and_cosine(guess, bits)
            change = (((number * cosine >> bits) - sine) << bits) // (cosine + (number * sine >> bits))
            guess += change
            if abs(change) >= before:
                break
            before = abs(change)
        return self.rounded(guess, abs(change) + UNSURE, -bits) + self.wider(self.width())

    def atan2(self, x: arb) -> Self:
        """The angle of (x, y), where this is y."""
        if x > 0:
            return (self / x).atan()
        quarter = self.pi() / 2
        if self > 0:
            return quarter - self._same(x / self).atan()
        if self < 0:
            return -quarter - self._same(x / self).atan()
        return 2 * quarter if x < 0 and self.is_zero() else self.wider(2 * quarter)

    def asin(self) -> Self:
        rest = 1 - self * self
        across = not (rest > 0 or rest.is_zero())
        return self.atan2(self.between(self.of(0), rest.upper().root(2).upper()) if across else rest.root(2))

    def acos(self) -> Self:
        return self.pi() / 2 - self.asin()

    def sinh(self) -> Self:
        return (self.exp() - (-self).exp()) / 2

    def cosh(self) -> Self:
        return (self.exp() + (-self).exp()) / 2

    def tanh(self) -> Self:
        return 1 - 2 / ((2 * self).exp() + 1)

    def gamma(self) -> Self:
        """To twelve figures only."""
        number = float(self)
        if self.off < 0 or not 0 < number < 170 or self.width() > 1e-15:
            return self.nothing()
        return type(self)(math.gamma(number)) * (1 + self.wider(type(self)(GAMMA_OFF)))

    def _fixed(self, number: float, bits: int) -> int:
        first = self._same(number)
        return fixed(first.whole, first.exponent, bits)
