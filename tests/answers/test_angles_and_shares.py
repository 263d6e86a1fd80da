"""Angles by their form, from a line or in turns, and shares less than 1: numbers whose unit is told without one."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from corollary.answers.answer import Numbers, Unclear
from corollary.answers.question import Question, Symbol
from corollary.answers.registry import answer_type
from corollary.formula.value import Real, Text
from corollary.units.unit import unit


def question(its_unit: str, title: str = "", **more):
    return replace(Question("a", "a", ("value",), unit(its_unit), title), **more)


def read(typed: str | float, of: Question):
    return answer_type("value").read(Text(typed) if isinstance(typed, str) else Real(typed), of)


@pytest.mark.parametrize(
    ("text", "angle"),
    [
        ("arcsin(0.44)", math.asin(0.44)), ("asin(1.1/2.5)", math.asin(0.44)), ("sin^-1(0.44)", math.asin(0.44)), ("-atan(2)", -math.atan(2)),
        ("90° - arctan(2)", math.atan(0.5)), ("pi/2 - atan(2)", math.atan(0.5)), ("2*atan(0.5)", 2 * math.atan(0.5)), ("acos(0.5)/2", math.pi / 6),
        ("asin(0.44)*180/pi", math.asin(0.44)), ("atan(0.5)/pi*180", math.atan(0.5)), ("arctan(1)°", math.pi / 4), ("arctan(1) deg", math.pi / 4),
        ("arcsin(0.44) = 26.1°", math.asin(0.44)), ("θ = arctan(2.475) = 68.0°", math.atan(2.475)),
    ],
)  # fmt: skip
def test_an_inverse_function_gives_an_angle_whatever_its_unit(text, angle):
    found = read(text, question("deg"))
    assert isinstance(found, Numbers), found
    assert found.values == pytest.approx((angle,), rel=2e-3)


@given(st.floats(-0.99, 0.99).filter(lambda x: abs(x) > 0.01), st.sampled_from(["asin", "acos", "arctan"]))
def test_degrees_and_radians_read_one_formula_alike(argument, function):
    text = f"{function}({argument:.4f})"
    in_degrees, in_radians = read(text, question("deg")), read(text, question("rad"))
    assert isinstance(in_degrees, Numbers)
    assert isinstance(in_radians, Numbers)
    assert in_degrees.values == in_radians.values


def test_the_sine_of_an_angle_is_a_number_whatever_unit_the_angle_is_asked_in():
    for its_unit in ("deg", "rad"):
        found = read("sin(theta) = 0.44", question(its_unit))
        assert isinstance(found, Unclear)
        assert found.why == "sin(theta) = 0.44 gives theta = 26.1039 deg; type the angle"
        assert [each.values for each in found.readings] == [pytest.approx((math.asin(0.44),), rel=1e-5)]


@pytest.mark.parametrize(
    ("text", "reference", "value"),
    [
        ("68° below the horizontal", "below horizontal", 68), ("68° above the horizontal", "below horizontal", -68), ("68°", "below horizontal", 68),
        ("68° downwards", "below horizontal", 68), ("68° below the horizontal", "horizontal", -68), ("68° above the horizontal", "horizontal", 68),
        ("68° with the horizontal", "below horizontal", 68),
    ],
)  # fmt: skip
def test_an_angle_is_counted_as_the_question_counts_it(text, reference, value):
    found = read(text, question("deg", reference=reference))
    assert isinstance(found, Numbers), found
    assert found.values == pytest.approx((math.radians(value),))


@pytest.mark.parametrize(
    ("text", "turns"),
    [
        ("1000", 1000),
        ("1000 turns", 1000),
        ("1000 rotations", 1000),
        ("2000*pi rad", 1000),
        ("1000 rad", 159.155),
        ("360000°", 1000),
    ],
)
def test_an_angle_is_so_many_turns_where_turns_are_counted(text, turns):
    found = read(text, question("1", "Turns"))
    assert isinstance(found, Numbers)
    assert found.values == pytest.approx((turns,), rel=1e-5)


@given(st.decimals("0.011", "0.989", places=3))
def test_a_number_less_than_one_may_be_the_share_itself(share):
    assume(share != 1)
    for typed in (str(share), float(share)):
        found = read(typed, question("%"))
        assert isinstance(found, Unclear)
        assert [each.values[0] for each in found.readings] == pytest.approx(
            [float(share), float(share) / 100]
        )


@pytest.mark.parametrize("typed", ["49.7", "0.497 %", "49.7 %", "0", "1", 49.7])
def test_with_its_sign_or_from_one_up_a_percentage_is_one(typed):
    assert isinstance(read(typed, question("%")), Numbers)


def test_where_a_plain_number_is_asked_a_share_is_one():
    found = read("0.497", question("1"))
    assert isinstance(found, Numbers)
    assert found.values == (0.497,)


def test_g_is_the_letter_of_the_problem_before_it_is_a_unit_of_acceleration():
    found = read("0.387 g", question("m/s^2"))
    assert isinstance(found, Numbers)
    assert found.values == pytest.approx((0.387 * 9.80665,))
    on_the_moon = question("m/s^2", symbols=(Symbol("g", unit("m/s^2")),))
    assert not isinstance(read("0.387 g", on_the_moon), Numbers)


def test_a_loss_said_twice_is_a_loss_and_asked_about_where_the_loss_is_asked_for():
    found = read("-205 J lost", question("J", "Change of kinetic energy"))
    assert isinstance(found, Numbers)
    assert found.values == (-205,)
    asked = read("-205 J lost", question("J", "Energy lost"))
    assert isinstance(asked, Unclear)
    assert {each.values for each in asked.readings} == {(-205,), (205,)}
