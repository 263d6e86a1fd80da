"""Formulas whose value is a fraction, or a fraction times a power of pi: worked out exactly."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import assert_never

from corollary.formula.ast import Call, Expr, Name, Negative, Number, Power, Product, Quotient, Relation, Sum

MOST_BITS = 20_000

ZERO, HALF = Fraction(0), Fraction(1, 2)
SINES = {ZERO: ZERO, Fraction(1, 6): HALF, HALF: Fraction(1), Fraction(5, 6): HALF, Fraction(1): ZERO}
"""sin(pi x) where it is rational, for x from 0 to 1 (Niven's theorem: there are no others)."""


@dataclass(frozen=True, slots=True)
class RationalPi:
    """The number `ratio` times pi to the power `pi`."""

    ratio: Fraction
    pi: int = 0


NOTHING = RationalPi(ZERO)
ONE = RationalPi(Fraction(1))


def constant(tree: Expr) -> Fraction | None:
    """The value of a formula without letters, where it is a fraction."""
    found = exactly(tree, {})
    return found.ratio if found is not None and found.pi == 0 else None


def exactly(tree: Expr, values: Mapping[str, object]) -> RationalPi | None:
    """The value in Q times a power of pi; None where it is not one, is not defined, or has too many digits."""
    match tree:
        case Number(value):
            return RationalPi(value)
        case Name(name):
            known = values.get(name, RationalPi(Fraction(1), 1) if name == "pi" else None)
            return known if isinstance(known, RationalPi) else None
        case Negative(term):
            return _times(RationalPi(Fraction(-1)), exactly(term, values))
        case Sum(terms):
            total: RationalPi | None = NOTHING
            for term in terms:
                total = _plus(total, exactly(term, values))
            return total
        case Product(factors):
            product: RationalPi | None = ONE
            for factor in factors:
                product = _times(product, exactly(factor, values))
            return product
        case Quotient(top, bottom):
            return _times(exactly(top, values), _power(exactly(bottom, values), Fraction(-1)))
        case Power(base, exponent):
            power = exactly(exponent, values)
            return _power(exactly(base, values), power.ratio) if power is not None and power.pi == 0 else None
        case Call(function, arguments):
            known = [exactly(argument, values) for argument in arguments]
            return (
                _called(function, [each for each in known if each is not None]) if None not in known else None
            )
        case Relation():
            return None
        case _:
            assert_never(tree)


def _small(ratio: Fraction, pi: int) -> RationalPi | None:
    if ratio == 0:
        return NOTHING
    return (
        RationalPi(ratio, pi)
        if max(ratio.numerator.bit_length(), ratio.denominator.bit_length()) < MOST_BITS
        else None
    )


def _plus(left: RationalPi | None, right: RationalPi | None) -> RationalPi | None:
    if left is None or right is None:
        return None
    if left.ratio and right.ratio and left.pi != right.pi:
        return None
    return _small(left.ratio + right.ratio, left.pi if left.ratio else right.pi)


def _times(left: RationalPi | None, right: RationalPi | None) -> RationalPi | None:
    return None if left is None or right is None else _small(left.ratio * right.ratio, left.pi + right.pi)


def _power(base: RationalPi | None, power: Fraction) -> RationalPi | None:
    if (
        base is None
        or (base.ratio == 0 and power < 0)
        or power.denominator > 64
        or power.numerator.bit_length() > 12
    ):
        return None
    bits = max(base.ratio.numerator.bit_length(), base.ratio.denominator.bit_length())
    if bits * abs(power) > MOST_BITS or (base.pi * power).denominator != 1:
        return None
    root = base.ratio if power.denominator == 1 else _root(base.ratio, power.denominator)
    return None if root is None else _small(root**power.numerator, int(base.pi * power))


def _root(ratio: Fraction, degree: int) -> Fraction | None:
    if ratio < 0:
        return None
    top, bottom = _whole_root(ratio.numerator, degree), _whole_root(ratio.denominator, degree)
    return (
        Fraction(top, bottom)
        if top**degree == ratio.numerator and bottom**degree == ratio.denominator
        else None
    )


def _whole_root(number: int, degree: int) -> int:
    """The largest whole number whose power does not exceed `number` (Newton from above)."""
    if degree == 2:
        return math.isqrt(number)
    guess = 1 << -(-number.bit_length() // degree)
    while guess and (step := ((degree - 1) * guess + number // guess ** (degree - 1)) // degree) < guess:
        guess = step
    return guess


def _called(function: str, at: list[RationalPi]) -> RationalPi | None:
    x = at[0]
    plain = x.pi == 0
    match function:
        case "sqrt":
            return _power(x, HALF)
        case "abs":
            return RationalPi(abs(x.ratio), x.pi)
        case "min" | "max":
            if x.pi != at[1].pi and x.ratio and at[1].ratio:
                return None
            return (min if function == "min" else max)(at, key=lambda each: each.ratio)
        case "sin" | "cos" | "tan":
            return _of_angle(function, x)
        case "asin" | "acos" | "atan" if plain:
            return _angle_of(function, x.ratio)
        case "exp" | "cosh":
            return ONE if x.ratio == 0 else None
        case "ln" | "log10":
            return NOTHING if x == ONE else None
        case "sinh" | "tanh":
            return NOTHING if x.ratio == 0 else None
        case _:
            return None


def _of_angle(function: str, angle: RationalPi) -> RationalPi | None:
    if angle.ratio and angle.pi != 1:
        return None
    turn = angle.ratio % 2
    if function == "tan":
        known = {Fraction(0): 0, Fraction(1, 4): 1, Fraction(3, 4): -1}.get(turn % 1)
        return None if known is None else RationalPi(Fraction(known))
    turn = (turn + HALF) % 2 if function == "cos" else turn
    sine = SINES.get(turn) if turn <= 1 else SINES.get(turn - 1)
    return None if sine is None else RationalPi(sine if turn <= 1 else -sine)


def _angle_of(function: str, ratio: Fraction) -> RationalPi | None:
    if function == "atan":
        known = {ZERO: ZERO, Fraction(1): Fraction(1, 4), Fraction(-1): Fraction(-1, 4)}.get(ratio)
    else:
        known = {
            ZERO: ZERO,
            HALF: Fraction(1, 6),
            Fraction(1): HALF,
            -HALF: Fraction(-1, 6),
            Fraction(-1): -HALF,
        }.get(ratio)
        known = HALF - known if known is not None and function == "acos" else known
    return None if known is None else _small(known, 1)
