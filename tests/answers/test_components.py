"""Vectors in words, as texts of their components."""

from __future__ import annotations

import pytest

from corollary.answers.components import pieces_of
from corollary.answers.polar import length_and_angle
from corollary.answers.quantity import in_si
from corollary.answers.vector_quantity import read_quantities
from corollary.formula.errors import ParseError
from corollary.units.unit import unit


@pytest.mark.parametrize(
    "typed",
    [
        "(3, 4) N", "[3; 4] N", "<3, 4> N", "{3, 4} N", "(3 | 4) N", "3 N and 4 N", "3 N; 4 N", "3 i + 4 j N", "3 ex + 4 ey N",
        "p_y = 4 N, p_x = 3 N", "y: 4 N; x: 3 N", "vx = 3 N, vy = 4 N", "3 N und 4 N", "3 N og 4 N", "3 i N + 4 j N", "4 j N + 3 i N",
        "3 N 4 N", "(3 N 4 N)",
    ],
)  # fmt: skip
def test_the_components_in_their_order(typed):
    found = pieces_of(typed, 2, ("x", "y"))
    assert isinstance(found, list), found
    assert [piece.lstrip("+") for piece in found] == ["3 N", "4 N"]


@pytest.mark.parametrize("typed", ["3 N 4 J", "3 N 4", "3 4 N 5 N", "1 h 30 min", "3 N -4 N 5 N"])
def test_a_blank_parts_only_what_has_the_same_unit_each(typed):
    assert isinstance(read_quantities(typed, unit("N"), 2, ("x", "y")), ParseError)


@pytest.mark.parametrize(
    ("typed", "components"),
    [
        ("3 i + -4 j N", ["3 N", "-4 N"]),
        ("3 i - -4 j N", ["3 N", "4 N"]),
        ("3 i kg m s^-1 - 4 j kg m s^-1", ["3 kg m s^-1", "-4 kg m s^-1"]),
        ("-m*v i - M*u j", ["-m*v", "-M*u"]),
    ],
)
def test_signs_and_units_between_unit_vectors(typed, components):
    assert pieces_of(typed, 2, ("x", "y")) == components


@pytest.mark.parametrize(
    ("typed", "values"),
    [
        ("-(3, 4) N", [-3, -4]), ("- (3, 4)", [-3, -4]), ("+(3, 4)", [3, 4]), ("2(3, 4) N", [6, 8]), ("2 (3, 4) N", [6, 8]), ("2*(3, 4) N", [6, 8]),
        ("2 kg * (3, 4) m/s^2", [6, 8]), ("-2*(3, 4) N", [-6, -8]), ("(3, 4)/2 N", [1.5, 2]), ("1/2 (3, 4)", [1.5, 2]),
    ],
)  # fmt: skip
def test_a_factor_before_the_bracket_multiplies_each_component(typed, values):
    found = read_quantities(typed, unit("N"), 2, ("x", "y"))
    assert isinstance(found, tuple), found
    assert [in_si(each) for each in found] == pytest.approx(values)


def test_a_slash_between_two_decimal_commas_or_a_quotient_is_asked_about():
    found = read_quantities("7,5 / -10", unit("N"), 2, ("x", "y"))
    assert isinstance(found, ParseError)
    assert found.status == "asked"
    assert len(found.choices) == 2


def test_names_that_are_none_of_the_components_keep_their_order():
    assert pieces_of("v1 = 3 N, v2 = 4 N", 2, ("A", "B")) == ["v1 = 3 N", "v2 = 4 N"]
    assert isinstance(pieces_of("x = 3 N, x = 4 N", 2, ("x", "y")), ParseError)
    assert pieces_of("4 unknowns, 3 equations", 2, ("unknowns", "equations")) == ["4", "3"]


def test_a_factor_before_the_brackets_goes_to_each():
    assert pieces_of("m v (cos(a), sin(a))", 2) == ["m v*(cos(a))", "m v*(sin(a))"]


@pytest.mark.parametrize(
    ("typed", "length", "angle"),
    [
        ("5 N at 30°", "5 N", "30°"),
        ("5 N, 30°", "5 N", "30°"),
        ("5 N (30 deg)", "5 N", "30 deg"),
        ("5∠30° N", "5 N", "30°"),
        ("5 N at 30° above the horizontal", "5 N", "30°"),
        ("5 N, 30° below the x-axis", "5 N", "-30°"),
        ("5 N at 30 degrees to the horizontal", "5 N", "30 degrees"),
    ],
)
def test_a_length_and_an_angle(typed, length, angle):
    assert length_and_angle(typed) == (length, angle)


@pytest.mark.parametrize("typed", ["(40 cos 30°, 40 sin 30°) N", "(3, 4) N", "3 N; 4 N"])
def test_what_is_none(typed):
    assert length_and_angle(typed) is None


@pytest.mark.parametrize(
    "text", ["1.10 m ± 20.6 cm", "1.10 m ± 206 mm", "110 cm ± 0.206 m", "1100 mm ± 20.6 cm", "1.10 ± 0.206 m"]
)
def test_each_side_of_both_signs_has_its_own_unit(text):
    found = read_quantities(text, unit("m"), 2, ("near", "far"))
    assert not isinstance(found, ParseError)
    assert [in_si(each) for each in found] == pytest.approx([0.894, 1.306])


@pytest.mark.parametrize(
    "text", ["142.5 + (-199.5) j", "142.5 + 199.5 j", "142.5 - 199.5j", "(142.5 - 199.5j) N"]
)
def test_a_complex_number_is_no_plane_vector_unasked(text):
    found = read_quantities(text, unit("N"), 2, ("x", "y"))
    assert isinstance(found, ParseError)
    assert found.status == "asked"
