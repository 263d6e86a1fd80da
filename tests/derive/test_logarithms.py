"""Logarithms that are added are one, and what stands inside of it measures nothing."""

from __future__ import annotations

import pytest
import sympy
from tests.derive.conftest import ASKS
from tests.derive.test_solve import closed

from corollary.derive.assumptions import logarithms_together

A, B, r, t = sympy.symbols("A B r t", positive=True)
x = sympy.Symbol("x", real=True)


@pytest.mark.parametrize(
    ("apart", "together"),
    [
        (sympy.log(A) - sympy.log(B), sympy.log(A / B)),
        ((-sympy.log(1 / x) - sympy.log(B)) / r, sympy.log(x / B) / r),
        (t * sympy.log(A) - t * sympy.log(B) + r, t * sympy.log(A / B) + r),
        (sympy.log(A) - 2 * sympy.log(B), sympy.log(A / B**2)),
        (sympy.log(2 ** (A / B), evaluate=False), A * sympy.log(2) / B),
        (-t * sympy.log(A / B), t * sympy.log(B / A)),
        (sympy.log(A) + t * sympy.log(B), sympy.log(A) + t * sympy.log(B)),
        (-sympy.log(1 - t), -sympy.log(1 - t)),
    ],
)
def test_one_logarithm(apart, together):
    found = logarithms_together(apart)
    assert found == together
    numbers = {A: 3, B: 7, r: 2, t: sympy.Rational(1, 3), x: 5}
    assert abs((found - apart).subs(numbers).evalf(30)) < 1e-25


def test_a_decay_backwards(solved):
    """ln(1/A0) is of no dimension only beside ln(A): apart, their sum was refused."""
    found = solved(
        """
        t1, r = unknowns("t1 r")
        return derivation(
            step(r, "Half in t.", law("Half-life", "exp(-r*t) = 1/2")),
            step(q, "Twice.", law("Whole", "q = 2*v")),
            step(t1, "Until.", law("Decay", "v = 3*q*exp(-r*t1)"), answers="a"),
        )""",
        asks=ASKS.replace("kg*m/s", "s"),
    )
    assert closed(found, "a") == ["t*ln(6)/ln(2)"]
    assert found.answer("a").local.trees
