"""Numbers of twice a double's length, as (head, tail) pairs, for compiled loops: about 31 digits.

Source: T. J. Dekker, Numerische Mathematik 18 (1971) 224; D. H. Bailey's double-double in the form of Y. Hida, X. S. Li, 2001.
"""

# pyright: reportMissingParameterType=false, reportUnknownParameterType=false, reportUnknownArgumentType=false, reportUnknownVariableType=false, reportUnknownMemberType=false, reportUntypedFunctionDecorator=false, reportOptionalSubscript=false, reportOptionalMemberAccess=false

from __future__ import annotations

import math
from fractions import Fraction

from numba import njit

compiled = njit(cache=True)
"""What is compiled is kept beside its module until that changes."""


@njit(inline="always")
def _exact_sum(a, b):
    s = a + b
    part = s - a
    return s, (a - (s - part)) + (b - part)


@njit(inline="always")
def _ordered_sum(a, b):
    s = a + b
    return s, b - (s - a)


@njit(inline="always")
def _halves(a):
    t = 134217729.0 * a
    head = t - (t - a)
    return head, a - head


@njit(inline="always")
def _exact_product(a, b):
    p = a * b
    ah, al = _halves(a)
    bh, bl = _halves(b)
    return p, ((ah * bh - p) + ah * bl + al * bh) + al * bl


@compiled
def plus(a, b):
    s, e = _exact_sum(a[0], b[0])
    t, f = _exact_sum(a[1], b[1])
    s, e = _ordered_sum(s, e + t)
    return _ordered_sum(s, e + f)


@compiled
def minus(a, b):
    return plus(a, (-b[0], -b[1]))


@compiled
def times(a, b):
    p, e = _exact_product(a[0], b[0])
    return _ordered_sum(p, e + (a[0] * b[1] + a[1] * b[0]))


@compiled
def over(a, b):
    q = a[0] / b[0]
    left = minus(a, times(b, (q, 0.0)))
    r = left[0] / b[0]
    left = minus(left, times(b, (r, 0.0)))
    q, r = _ordered_sum(q, r)
    return plus((q, r), (left[0] / b[0], 0.0))


@compiled
def root(a):
    """The square root; of what is not above zero, zero."""
    if a[0] <= 0.0:
        return 0.0, 0.0
    x = 1.0 / math.sqrt(a[0])
    near = a[0] * x
    left = minus(a, _exact_product(near, near))
    return _exact_sum(near, left[0] * x * 0.5)


@compiled
def power(a, q):
    """a to 1, 3/2, 2 or 3; of what is below zero, nothing where the power is no whole number."""
    if q == 1.0:
        return a
    if q == 1.5:
        return times(a, root(a)) if a[0] > 0.0 else (0.0, 0.0)
    return times(a, a) if q == 2.0 else times(a, times(a, a))


def pair(x: Fraction | float) -> tuple[float, float]:
    """The pair next to a number."""
    exact = Fraction(x)
    head = float(exact)
    return head, float(exact - Fraction(head))


def number(head: float, tail: float) -> Fraction:
    """What a pair stands for."""
    return Fraction(float(head)) + Fraction(float(tail))
