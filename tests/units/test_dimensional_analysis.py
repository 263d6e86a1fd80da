"""What a formula measures."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.errors import ParseError
from corollary.formula.syntax import author_formula
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, UNITS, Dimension, unit

OF = {
    name: unit(text).dimension
    for name, text in {
        "m": "kg",
        "M": "kg",
        "v": "m/s",
        "w": "m/s",
        "dt": "s",
        "g": "m/s^2",
        "h": "m",
        "theta": "rad",
        "k": "N/m^1.5",
        "r": "1",
    }.items()
}


@pytest.mark.parametrize(
    ("formula", "measures"),
    [
        ("m*v/dt", "N"),
        ("m*v^2/2", "J"),
        ("sqrt(2*g*h)", "m/s"),
        ("-v*ln(m/M)", "m/s"),
        ("m*(v - w)", "kg*m/s"),
        ("(1 - r^2)*m", "kg"),
        ("k*h^1.5", "N"),
        ("k*h^(3/2)", "N"),
        ("m^(4/4)", "kg"),
        ("2*m*v*sin(theta)", "N*s"),
        ("atan2(v, w)", "rad"),
        ("abs(v) + max(v, w)", "m/s"),
        ("0", "1"),
        ("v + 0", "m/s"),
        ("0 + v", "m/s"),
        ("v + 0*m", "m/s"),
        ("r^theta", "1"),
        ("m*v = M*w", "kg*m/s"),
        ("v > 0", "m/s"),
        ("exp(-v/w)*pi", "1"),
        ("m*h^(r - 1)/h^(r - 1)", "kg"),
        ("m*(h/(2*h))^(r - 1)", "kg"),
        ("v^r*w^(theta - r)*v^(2 - theta)", "m^2/s^2"),
        ("(h^r)^(1/r)", "m"),
        ("m*h^(r - 1) = M*h^(r - 1)", None),
        ("v^((r - 1)/r)*v^(1/r)", "m/s"),
    ],
)
def test_a_formula_measures_what_its_letters_give(formula, measures):
    found = dimension_of(author_formula(formula), OF)
    assert not isinstance(found, ParseError)
    assert measures is None or found == unit(measures).dimension


@pytest.mark.parametrize(
    ("formula", "why"),
    [
        ("m*v + h", "m*v (kg m/s) and h (m) cannot be added"),
        ("v - h/2", "v (m/s) and h/2 (m) cannot be added"),
        ("v + 1", "v (m/s) and 1 (a plain number) cannot be added"),
        ("sin(m)", "m (kg) cannot be inside sin"),
        ("ln(v)", "v (m/s) cannot be inside ln"),
        ("r^h", "h (m) cannot be an exponent"),
        ("v^theta", "v (m/s) can only have a number as its exponent"),
        ("m*h^(r - 1) = M*h^r", "h (m) can only have a number as its exponent"),
        ("h^r*h^theta", "h (m) can only have a number as its exponent"),
        ("h^r + h", "h (m) can only have a number as its exponent"),
        ("m*h^(h/v) = M", "h/v (s) cannot be an exponent"),
        ("h^sin(theta)", "h (m) can only have a number as its exponent"),
        ("atan2(v, h)", "v (m/s) and h (m) cannot be compared"),
        ("v = h", "v (m/s) and h (m) cannot be compared"),
        ("sqrt(v^2 + 2*g)", "v^2 (m²/s²) and 2*g (m/s²) cannot be added"),
    ],
)
def test_metres_are_not_added_to_seconds(formula, why):
    found = dimension_of(author_formula(formula), OF)
    assert isinstance(found, ParseError)
    assert found.why == why


def test_a_letter_nobody_declared_is_an_error_of_the_caller():
    with pytest.raises(KeyError):
        dimension_of(author_formula("q"), OF)


powers = st.lists(st.tuples(st.sampled_from(sorted(OF)), st.integers(-3, 3)), min_size=1, max_size=5)


@given(powers)
def test_a_product_of_powers_has_the_product_of_dimensions(parts):
    expected = ONE
    for name, power in parts:
        expected = expected * OF[name] ** power
    formula = "*".join(f"{name}^({power})" for name, power in parts)
    assert dimension_of(author_formula(formula), OF) == expected
    assert isinstance(expected, Dimension)
    assert UNITS["N"].dimension == OF["m"] * OF["v"] / OF["dt"]
