"""Formulas worked out in fractions and powers of pi."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.arithmetics import constant, exactly
from corollary.formula.ball import Undefined, evaluate
from corollary.formula.rational_pi import RationalPi
from corollary.formula.syntax import author_formula


@pytest.mark.parametrize(
    ("formula", "ratio", "pi"),
    [
        ("2/3 + 1/6", "5/6", 0),
        ("2*pi/3 - pi/6", "1/2", 1),
        ("pi^2/pi", "1", 1),
        ("pi/pi", "1", 0),
        ("sqrt(9/4)", "3/2", 0),
        ("(27/8)^(2/3)", "9/4", 0),
        ("4^(-1/2)", "1/2", 0),
        ("sqrt(pi^2)", "1", 1),
        ("cos(pi/3)", "1/2", 0),
        ("sin(7*pi/6)", "-1/2", 0),
        ("cos(0)", "1", 0),
        ("sin(pi)", "0", 0),
        ("sin(2*pi)", "0", 0),
        ("cos(pi/2)", "0", 0),
        ("cos(3*pi/2)", "0", 0),
        ("sin(pi/2)", "1", 0),
        ("sin(5*pi/6)", "1/2", 0),
        ("tan(pi)", "0", 0),
        ("tan(3*pi/4)", "-1", 0),
        ("acos(1/2)", "1/3", 1),
        ("acos(-1/2)", "2/3", 1),
        ("asin(1/2)", "1/6", 1),
        ("asin(-1/2)", "-1/6", 1),
        ("asin(-1)", "-1/2", 1),
        ("atan(-1)", "-1/4", 1),
        ("exp(0) + ln(1)", "1", 0),
        ("abs(-3) + max(1, 2) - min(1, 2)", "4", 0),
        ("0*pi + 3", "3", 0),
        ("0^2", "0", 0),
    ],
)
def test_a_value_is_found_exactly(formula, ratio, pi):
    assert exactly(author_formula(formula), {}) == RationalPi(Fraction(ratio), pi)


@pytest.mark.parametrize(
    "formula",
    [
        "sqrt(2)",
        "1 + pi",
        "1/0",
        "0^(-1)",
        "sqrt(-1)",
        "sin(1)",
        "sin(pi/4)",
        "tan(pi/2)",
        "exp(1)",
        "2^pi",
        "sqrt(pi)",
        "x",
        "9^9^9",
        "((2^64)^64)^64*x",
    ],
)
def test_what_is_no_fraction_of_pi_is_left_alone(formula):
    try:
        tree = author_formula(formula)
    except ValueError:  # refused as too large already
        return
    assert exactly(tree, {}) is None
    assert constant(tree) is None


@given(st.sampled_from(["sin", "cos", "tan"]), st.fractions(-4, 4, max_denominator=12))
def test_angles_agree_with_the_ball(function, turn):
    tree = author_formula(f"{function}(x)")
    known = exactly(tree, {"x": RationalPi(turn, 1)})
    ball = evaluate(tree, {"x": RationalPi(turn, 1)}, 100)
    if known is not None:
        assert ball.contains(evaluate(author_formula("x"), {"x": known}, 400))
    else:  # Niven: no rational value was overlooked
        rational = (0, 1, -1) if function == "tan" else (0, 1, -1, 0.5, -0.5)
        assert not ball.is_finite() or not any(ball.contains(value) for value in rational)


@given(st.integers(0, 10**39), st.integers(2, 9))
def test_whole_roots(number, degree):
    assert constant(author_formula(f"({number}^{degree})^(1/{degree})")) == number


def test_an_undefined_value_is_not_called_exact():
    with pytest.raises(Undefined):
        evaluate(author_formula("1/0"), {}, 64)
    assert (
        math.isnan(float(evaluate(author_formula("tan(pi/2)"), {}, 64)))
        or exactly(author_formula("tan(pi/2)"), {}) is None
    )
