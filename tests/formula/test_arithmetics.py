"""Formulas in every arithmetic: pairs of doubles against exact fractions, intervals that enclose, arrays like single doubles."""

from __future__ import annotations

import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.arithmetics import DOUBLES, PAIRS, NotAvailable, arrays, intervals, ready
from corollary.formula.double_double import PI, DoubleDouble, root
from corollary.formula.syntax import author_formula

FORMULA = author_formula("m*v^2/2 - sqrt(m)*v/(1 + v) + 3", ["m", "v"])
sizes = st.floats(1e-6, 1e6)
doubles = st.one_of(sizes, sizes.map(lambda x: -x))
# The relative error of each operation is at most a few units of 2^-104; 2^-100 leaves room for the proofs' constants.
CLOSE = Fraction(1, 2**100)


def exact(number: DoubleDouble) -> Fraction:
    return Fraction(number.high) + Fraction(number.low)


@given(doubles, doubles, doubles)
def test_pairs_keep_thirty_digits(a, b, c):
    x, y = DoubleDouble(a) / DoubleDouble(b), DoubleDouble(c)
    for got, true in (
        (x * y, exact(x) * exact(y)),
        (x / y, exact(x) / exact(y)),
        (y * y * y, exact(y) ** 3),
        (y**3, exact(y) ** 3),
        (y**-2, exact(y) ** -2),
    ):
        assert abs(exact(got) - true) <= 8 * CLOSE * abs(true)
    assert abs(exact(x + y) - (exact(x) + exact(y))) <= CLOSE * (abs(exact(x)) + abs(exact(y)))
    assert exact(-x) == -exact(x)
    assert exact(abs(x)) == abs(exact(x))


@given(sizes)
def test_the_root_of_a_pair(a):
    found = exact(root(DoubleDouble(a)))
    assert abs(found * found - Fraction(a)) <= 8 * CLOSE * Fraction(a)


def test_zero_and_pi():
    assert exact(root(DoubleDouble(0.0))) == 0
    assert abs(exact(PI) - Fraction("3.14159265358979323846264338327950288419716939937510")) < Fraction(
        1, 10**31
    )
    assert exact(DoubleDouble.of(Fraction(1, 3))) != Fraction(1, 3)
    assert abs(exact(DoubleDouble.of(Fraction(1, 3))) - Fraction(1, 3)) < Fraction(1, 2**105)


@given(sizes, sizes)
def test_every_arithmetic_finds_the_same(m, v):
    true = m * v**2 / 2 - math.sqrt(m) * v / (1 + v) + 3
    room = 1e-14 * (m * v**2 + math.sqrt(m) + 3)
    assert ready(FORMULA, DOUBLES)({"m": m, "v": v}) == pytest.approx(true, abs=room)
    assert ready(FORMULA, arrays())({"m": np.array([m, m]), "v": np.array([v, v])})[1] == pytest.approx(
        true, abs=room
    )
    fine = ready(FORMULA, PAIRS)({"m": DoubleDouble(m), "v": DoubleDouble(v)})
    assert float(fine) == pytest.approx(true, abs=room)
    between = intervals()
    wide = ready(FORMULA, between)({"m": between.number(Fraction(m)), "v": between.number(Fraction(v))})
    assert float(wide.a) <= float(fine) <= float(wide.b)


def test_what_an_arithmetic_lacks_is_said():
    with pytest.raises(NotAvailable, match="double-double has no sin"):
        ready(author_formula("sin(v)", ["v"]), PAIRS)
    with pytest.raises(NotAvailable, match="broken powers"):
        ready(author_formula("v^(3/2)", ["v"]), PAIRS)
