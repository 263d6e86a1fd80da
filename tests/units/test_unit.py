"""The units of mechanics, and how students write them."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.formula.errors import ParseError
from corollary.units.unit import (
    ONE,
    UNITS,
    Dimension,
    Unit,
    called,
    canonical,
    latex,
    read_unit,
    show,
    si_unit,
    unit,
)


@pytest.mark.parametrize(
    ("text", "written", "powers", "factor"),
    [
        ("kg m/s", "kg*m/s", (1, 1, -1), 1),
        ("kg*m/s", "kg*m/s", (1, 1, -1), 1),
        ("kg·m/s", "kg*m/s", (1, 1, -1), 1),
        ("kg·m·s⁻¹", "kg*m/s", (1, 1, -1), 1),
        ("kg m s⁻¹", "kg*m/s", (1, 1, -1), 1),
        ("kg m s^-1", "kg*m/s", (1, 1, -1), 1),
        ("kg m s^{-1}", "kg*m/s", (1, 1, -1), 1),
        ("kgm/s", "kg*m/s", (1, 1, -1), 1),
        ("(kg m)/s", "kg*m/s", (1, 1, -1), 1),
        ("N s", "N*s", (1, 1, -1), 1),
        ("Ns", "N*s", (1, 1, -1), 1),
        ("Nm", "N*m", (1, 2, -2), 1),
        ("Kg", "kg", (1, 0, 0), 1),
        ("km/h", "km/h", (0, 1, -1), Fraction(5, 18)),
        ("g", "g", (1, 0, 0), Fraction(1, 1000)),
        ("ms", "ms", (0, 0, 1), Fraction(1, 1000)),
        ("m s-2", "m/s^2", (0, 1, -2), 1),
        ("m/s2", "m/s^2", (0, 1, -2), 1),
        ("m/s**2", "m/s^2", (0, 1, -2), 1),
        ("m/s²", "m/s^2", (0, 1, -2), 1),
        ("m/s/s", "m/s^2", (0, 1, -2), 1),
        ("J/(kg m)", "J/(kg*m)", (0, 1, -2), 1),
        ("N/m^1.5", "N/m^1.5", (1, Fraction(-1, 2), -2), 1),
        ("N/m^(3/2)", "N/m^1.5", (1, Fraction(-1, 2), -2), 1),
        ("1/s", "1/s", (0, 0, -1), 1),
        ("kN", "kN", (1, 1, -2), 1000),
        ("µs", "us", (0, 0, 1), Fraction(1, 10**6)),
        ("min", "min", (0, 0, 1), 60),
        ("t", "t", (1, 0, 0), 1000),
        ("kWh", "kW*h", (1, 2, -2), 3_600_000),
        ("%", "%", (0, 0, 0), Fraction(1, 100)),
        ("rad/s", "rad/s", (0, 0, -1), 1),
        ("eV", "eV", (1, 2, -2), Fraction("1.602176634e-19")),
        ("newton seconds", "N*s", (1, 1, -1), 1),
        ("1", "1", (0, 0, 0), 1),
        ("A", "A", (0, 0, 0, 1), 1),
        ("mA", "mA", (0, 0, 0, 1), Fraction(1, 1000)),
        ("K", "K", (0, 0, 0, 0, 1), 1),
        ("J/(kg K)", "J/(kg*K)", (0, 2, -2, 0, -1), 1),
        ("J/(mol*K)", "J/(mol*K)", (1, 2, -2, 0, -1, -1), 1),
        ("cd", "cd", (0, 0, 0, 0, 0, 0, 1), 1),
        ("Ω", "ohm", (1, 2, -3, -2), 1),
        ("kΩ m", "kohm*m", (1, 3, -3, -2), 1000),
        ("Ohms", "ohm", (1, 2, -3, -2), 1),
        ("V/m", "V/m", (1, 1, -3, -1), 1),
        ("Vs", "V*s", (1, 2, -2, -1), 1),
        ("Wb", "Wb", (1, 2, -2, -1), 1),
        ("pF", "pF", (-1, -2, 4, 2), Fraction(1, 10**12)),
        ("microcoulombs", "uC", (0, 0, 1, 1), Fraction(1, 10**6)),
        ("MBq", "MBq", (0, 0, -1), 10**6),
        ("mSv", "mSv", (0, 2, -2), Fraction(1, 1000)),
        ("Km/h", "km/h", (0, 1, -1), Fraction(5, 18)),  # K is kilo before a unit, a kelvin alone or last
        ("KN", "kN", (1, 1, -2), 1000),
        ("Kgm", "kg*m", (1, 1), 1),
        ("kgK", "kg*K", (1, 0, 0, 0, 1), 1),
        ("m/m", "1", (0, 0, 0), 1),
    ],
)
def test_a_unit_is_read(text, written, powers, factor):
    found = read_unit(text)
    assert isinstance(found, Unit)
    assert found == Unit(written, Dimension(*map(Fraction, powers)), Fraction(factor))


@pytest.mark.parametrize("text", ["deg", "°", "º", "degrees"])
def test_a_degree_keeps_its_pi(text):
    assert read_unit(text) == Unit("deg", ONE, Fraction(1, 180), 1)


@pytest.mark.parametrize(
    "text", ["J/kg m", "kg m/s s", "J/kg*m", "N/m s", "ms^-1", "ms-1", "ms⁻¹", "kgms-1", "Nms", "kg/s m"]
)
def test_two_readings_are_asked_about_and_each_choice_can_be_typed(text):
    found = read_unit(text)
    assert isinstance(found, ParseError)
    assert found.status == "asked"
    choices = [read_unit(choice) for choice in found.choices]
    assert (
        len({(each.dimension, each.factor) for each in choices if isinstance(each, Unit)})
        == len(choices)
        >= 2
    )


@pytest.mark.parametrize(
    ("text", "suggestion"),
    [
        ("n", "N"),
        ("j", "J"),
        ("KM", "km"),
        ("newtn", "newton"),
        ("hz", "Hz"),
        ("dB", None),
        ("e-3", None),
        ("m/Q", None),
        ("blub", None),
        ("kg/", None),
        ("/", None),
        ("", None),
        ("m/(s", None),
        ("m)", None),
        ("kg**", None),
        ("m^99", None),
        ("m^1e9", None),
        ("m^-", None),
        ("5", None),
        ("m/2", None),
        ("m - s", None),
        ("m/s/(s)/m)", None),
        ("x" * 100, None),
        ("N/mm^1.5", None),
        ("m^1/0", None),
        ("m^(1/0)", None),
        ("deg^0.5", None),
    ],
)
def test_what_is_no_unit_is_refused_with_a_suggestion(text, suggestion):
    found = read_unit(text)
    assert isinstance(found, ParseError)
    assert found.status == "refused"
    assert suggestion is None or found.suggestion == f"did you mean {suggestion}?"
    assert found.position is None or 0 <= found.position <= len(text)


@pytest.mark.parametrize("letters", ["v", "a", "mv", "B"])
def test_a_letter_of_a_formula_is_not_taken_for_a_unit_of_another_subject(letters):
    found = read_unit(letters)
    assert isinstance(found, ParseError)
    assert not any(other in found.suggestion for other in ("V", "A", "C", "Bq"))


def test_an_author_is_told_in_a_sentence():
    assert unit("N/m^1.5").dimension == Dimension(Fraction(1), Fraction(-1, 2), Fraction(-2))
    with pytest.raises(ValueError, match="unit 'kgs/q': q is not a unit known here"):
        unit("kgs/q")


@pytest.mark.parametrize(
    ("text", "people", "tex"),
    [
        ("kg*m/s", "kg m/s", r"\mathrm{kg\,m/s}"),
        ("m/s^2", "m/s²", r"\mathrm{m/s^{2}}"),
        ("deg", "°", r"\mathrm{{}^{\circ}}"),
        ("1", "", ""),
        ("%", "%", r"\mathrm{\%}"),
        ("us", "µs", r"\mathrm{\mu s}"),
        ("N/m^1.5", "N/m^1.5", r"\mathrm{N/m^{1.5}}"),
        ("u", "u", r"\mathrm{u}"),
    ],
)
def test_units_for_people_and_for_tex(text, people, tex):
    assert (show(unit(text)), latex(unit(text))) == (people, tex)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("N", "a force"),
        ("N*s", "a momentum or an impulse"),
        ("rad", "a plain number"),
        ("kg^2", "something in kg²"),
        ("C", "an electric charge"),
        ("V/A", "a resistance"),
        ("V*m", "something in kg m³/(s³ A)"),
    ],
)
def test_a_dimension_has_a_name(text, words):
    assert called(unit(text).dimension) == words


symbols = st.sampled_from(
    sorted(symbol for symbol in UNITS if UNITS[symbol].text == symbol and symbol != "ms")
)
factors = st.lists(
    st.tuples(symbols, st.integers(-3, 3).filter(bool)),
    min_size=1,
    max_size=4,
    unique_by=lambda each: each[0],
)


@given(factors)
def test_powers_multiply_and_the_canonical_text_reads_back(parts):
    found = unit("*".join(f"{symbol}^{power}" for symbol, power in parts))
    dimension, factor = ONE, Fraction(1)
    for symbol, power in parts:
        dimension, factor = (
            dimension * UNITS[symbol].dimension ** power,
            factor * UNITS[symbol].factor ** power,
        )
    assert (found.dimension, found.factor) == (dimension, factor)
    assert unit(canonical(found)) == found


@given(factors)
def test_what_people_are_shown_reads_back(parts):
    found = unit("*".join(f"{symbol}^{power}" for symbol, power in parts))
    again = read_unit(show(found) or "1")
    assert isinstance(again, Unit)
    assert (again.dimension, again.factor, again.pi) == (found.dimension, found.factor, found.pi)


halves = st.integers(-6, 6).map(lambda number: Fraction(number, 2))
dimensions = st.builds(Dimension, *[halves] * 7)


@given(dimensions, dimensions, st.integers(-4, 4))
def test_dimensions_form_a_group(left, right, power):
    assert left * right / right == left
    assert (left * right) ** power == left**power * right**power
    assert si_unit(left).dimension == left
    assert si_unit(left).factor == 1


def test_the_powers_of_a_dimension_leave_out_zero():
    assert unit("N").dimension.powers() == {"kg": 1, "m": 1, "s": -2}
    assert unit("J/(mol*K)").dimension.powers() == {"kg": 1, "m": 2, "s": -2, "K": -1, "mol": -1}
    assert Dimension.of("kg m^2 s^-3 A^-1") == unit("V").dimension
    with pytest.raises(ValueError, match="not a product of base units"):
        Dimension.of("kg V")


@pytest.mark.parametrize(
    ("text", "size"), [("km", 1e3), ("deg", math.pi / 180), ("g", 1e-3), ("eV", 1.602176634e-19)]
)
def test_the_size_in_si_as_a_double(text, size):
    assert unit(text).si == pytest.approx(size, rel=1e-15)
