"""Interval arithmetic in plain Python with python-flint's names (`arb`, `fmpq`, `ctx`), for a browser.

A hundred times as slow, which one answer does not notice. Inverse functions are found by Newton's method, and the last correction is
what they may be off.
"""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Self

from corollary.formula.fixed_point import exp, fixed, log2, pi, sine_and_cosine
from corollary.formula.plain_balls import DyadicBall, ctx

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
