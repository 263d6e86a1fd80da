"""Calculations left standing in an answer."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.arithmetic_answer import Worked, worked_out
from corollary.answers.quantity import Reading, in_si, read_quantity
from corollary.formula.errors import ParseError
from corollary.units.unit import canonical, unit


@pytest.mark.parametrize(
    ("typed", "value", "its_unit"),
    [
        ("0.43 kg * 20 m/s", 8.6, "kg*m/s"),
        ("80 kg * 16.7 m/s / 0.4 s", 3340, "N"),
        ("0.43*20/0.1 N", 86, "N"),
        ("2*86 N", 172, "N"),
        ("2*86 N * cos 60°", 86, "N"),
        ("2*86*sin 30 deg N", 86, "N"),
        ("20√3 m/s", 20 * 3**0.5, "m/s"),
        ("sqrt(2*9.8 m/s^2*5 m)", 98**0.5, "m/s"),
        ("sqrt(2*9.8*5) m/s", 98**0.5, "m/s"),
        ("(0.01+1)/0.01*2.425 m/s", 244.925, "m/s"),
        ("1/2 * 2 kg * (3 m/s)^2", 9, "J"),
        ("40 cos 30° N", 40 * math.cos(math.pi / 6), "N"),
        ("2*20*cos(30°)/80 m/s", math.cos(math.pi / 6) / 2, "m/s"),
        ("2*-3 N", -6, "N"),
        ("π/2", math.pi / 2, None),
        ("1/2 π", math.pi / 2, None),
        ("arccos(0.7)", math.acos(0.7), None),
        ("2/(2+3)", 0.4, None),
        ("(2 + 3) m", 5, "m"),
        ("√2/2 π", math.pi / 2**0.5, None),
        ("3^2 m", 9, "m"),
        ("80 kg/4 m", 20, "kg/m"),
        ("2^3 * 10^-3 m", 0.008, "m"),  # the exponent is 3, not 3·10^-3
        ("√2 rad", 2**0.5, "1"),
        ("cos 0.5 rad", math.cos(0.5), None),
        ("cos(30°)^2 N", 0.75, "N"),
        ("1,5 kg * 2 m/s", 3, "kg*m/s"),
        ("12 V / 4 ohm", 3, "A"),
        # read since calculations are formulas: minutes (min is also a function), powers beyond 9,
        # an angle times pi, a zero with two units
        ("30 m / 2 min", 0.25, "m/s"),
        ("2^10 N", 1024, "N"),
        ("cos 2π", 1, None),
        ("0 kg * 3 m/s", 0, None),
    ],
)
def test_it_is_worked_out(typed, value, its_unit):
    found = worked_out(typed)
    assert isinstance(found, Worked), found
    assert found.value == pytest.approx(value, rel=1e-12)
    assert (found.unit and canonical(found.unit)) == its_unit


@pytest.mark.parametrize(
    "typed",
    [
        "3 m - 4 s",
        "8-9",
        "cos(30)",
        "1/0",
        "sqrt(-1)",
        "9^99",
        "9^9^9^9",
        "2 (3)",
        "1/2π",
        "3 m + 2 s",
        "(3 m + 2 s)",
        "0.4 (40 %)",
        "x*3",
        "--3 N",
        "2*--3",
        "10^10^9 m",
        "[2*3]",
        "cos(-30)",
        "5 °C * 2",
        "",
        "(" * 60,
    ],
)
def test_what_has_no_value_or_two_is_not(typed):
    assert isinstance(worked_out(typed), ParseError)


@given(st.floats(0.01, 1e4), st.floats(0.01, 1e4), st.floats(0.01, 1e4))
def test_a_calculation_is_its_value(a, b, c):
    found = read_quantity(f"{a!r} kg * {b!r} m/s / {c!r} s", unit("N"))
    assert isinstance(found, Reading)
    assert in_si(found) == pytest.approx(a * b / c, rel=1e-12)
    assert found.fit == "fits"


def test_the_same_said_twice_is_said_once():
    for typed in ("0.4 (40 %)", "40 % (= 0.4)"):
        found = read_quantity(typed, unit("1"))
        assert isinstance(found, Reading)
        assert in_si(found) == 0.4
    assert isinstance(read_quantity("0.4 (50 %)", unit("1")), ParseError)


def test_a_unit_with_two_meanings_is_the_one_asked_for():
    found = read_quantity("3 ms^-1", unit("m/s"))
    assert isinstance(found, Reading)
    assert in_si(found) == 3
    assert isinstance(read_quantity("3 ms^-1", None), ParseError)
