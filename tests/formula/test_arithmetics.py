"""Formulas in every arithmetic: pairs of doubles against exact fractions, intervals that enclose, arrays like single doubles."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.arithmetics import DOUBLES, NotAvailable, arrays, ready
from corollary.formula.syntax import author_formula
from corollary.trade.arithmetic_costs import PAIRS, intervals
from corollary.trade.double_double import PI, DoubleDouble, root

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
    with pytest.raises(NotAvailable, match="fractional powers"):
        ready(author_formula("v^(3/2)", ["v"]), PAIRS)


# Worked out by hand: each number in the comments is written down with three figures before the next is worked out.


def three_figures(x: float) -> float:
    return float(f"{x:.2e}")


BY_HAND = replace(DOUBLES, rounded=lambda step: lambda at: three_figures(step(at)))


def worked(formula: str, **letters: float) -> float:
    return ready(author_formula(formula, list(letters)), BY_HAND)(letters)


@pytest.mark.parametrize(
    ("formula", "letters", "by_hand"),
    [
        ("m*v", {"m": 1.237, "v": 2.0}, 1.237 * 2.0),  # the last operation is not rounded, nor are letters
        ("a*b - c*d", {"a": 3.33, "b": 3.33, "c": 3.31, "d": 3.35}, 0.0),  # 11.0889, 11.0885: 11.1 - 11.1
        ("-(a*b)", {"a": 3.33, "b": 3.33}, -11.0889),
        ("c - a*b", {"a": 3.33, "b": 3.33, "c": 11.0889}, 11.0889 - 11.1),
        ("v*ln(a/b)", {"v": 3600, "a": 2350, "b": 1410}, 3600 * 0.513),  # 1.67; 0.513
        ("a/exp(d/v)", {"a": 1280, "d": 4300, "v": 1750}, 1280 / 11.7),  # 2.46; 11.7
        ("sqrt(2*g*h)", {"g": 9.81, "h": 0.7}, math.sqrt(13.7)),  # 13.734
        ("(a + b)^2", {"a": 1.234, "b": 0.002}, 1.24**2),  # 1.236
        ("a^(b*c)", {"a": 2.0, "b": 1.111, "c": 1.111}, 2.0**1.23),  # 1.2343
        ("a*sqrt(2)*pi", {"a": 1.0}, math.sqrt(2) * math.pi),  # what has no letter is exact
    ],
)
def test_what_is_written_down_is_rounded(formula, letters, by_hand):
    assert worked(formula, **letters) == pytest.approx(by_hand, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("formula", ["1/(a - a)", "sqrt(0*a - 1)", "exp(1000*a)"])
def test_what_has_no_value_raises(formula):
    with pytest.raises((ValueError, ZeroDivisionError, OverflowError)):
        worked(formula, a=1.0)


def test_a_comparison_is_no_number():
    with pytest.raises(NotAvailable, match="comparison"):
        ready(author_formula("a < b", ["a", "b"]), BY_HAND)


def test_arrays_are_rounded_in_the_order_of_the_work():
    """a*b, then sin of it, then c*d: the last operation, the division, is not rounded."""
    order = list[float]()

    def rounded(step):
        mine = len(order)
        order.append(mine)
        return lambda at: step(at) + mine

    tree = author_formula("sin(a*b)/(c*d)", list("abcd"))
    found = ready(tree, replace(arrays(), rounded=rounded))(
        {"a": np.array([1.0, 2.0]), "b": 1.0, "c": 1.0, "d": 1.0}
    )
    assert found == pytest.approx([(math.sin(1) + 1) / 3, (math.sin(2) + 1) / 3])


def test_what_numpy_lacks_is_worked_out_element_by_element():
    found = ready(author_formula("gamma(x)", ["x"]), arrays())({"x": np.array([5.0, -1.0])})
    assert found[0] == pytest.approx(24)
    assert math.isnan(found[1])
