"""Numbers as whole multiples of a power of two: roots, constants and series to as many bits as wanted, in Python's whole numbers."""

from __future__ import annotations

import math
from functools import cache


def whole_root(number: int, degree: int) -> int:
    """Rounded down."""
    if degree == 2:
        return math.isqrt(number)
    guess = 1 << -(-number.bit_length() // degree)
    while (better := ((degree - 1) * guess + number // guess ** (degree - 1)) // degree) < guess:
        guess = better
    return guess


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
