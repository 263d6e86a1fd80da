"""Quantities in sentences, and results behind their work: read where no word changes them, never where one does."""

from __future__ import annotations

import pytest

from corollary.answers.answer import Letter, Numbers, Unclear
from corollary.answers.question import Question
from corollary.answers.registry import answer_type
from corollary.formula.value import Text
from corollary.units.unit import unit

FORCE = Question("a", "F", ("value",), unit("N"), "Mean force", text="What is the average force on the ball?")
TIME = Question(
    "a", "t", ("value",), unit("s"), "Overtaking", text="After what time does the car pass the cyclist?"
)
MASS = Question("a", "m", ("value",), unit("kg"), "Nitrogen", text="What mass of nitrogen is in the bottle?")
SHARE = Question("a", "q", ("value",), unit("%"), "Share", text="What part of it is let out?")
IMAGE = Question("a", "b", ("value",), unit("cm"), "Image", text="How far behind the mirror is the image?")
VELOCITY = Question("a", "v", ("value",), unit("m/s"), "Velocity", text="What is its velocity?")
MOMENTUM = Question("a", "p", ("vector",), unit("kg m/s"), "Momentum", ("x", "y"))
PLACES = Question("a", "x", ("vector",), unit("m"), "Turning points", ("near", "far"))
ROOTS = Question("a", "t", ("list",), unit("s"), "Times", ("up", "down"))
HEIGHT = Question(
    "d", "h", ("choice",), unit("1"), "Twice as far", options=("a", "b", "c"),
    option_texts=("as large as before", "twice as large", "four times as large"), text="The height is then",
)  # fmt: skip
SIDES = Question(
    "c", "s", ("choice",), unit("1"), "Further out", options=("a", "b", "c"),
    option_texts=("the plank stays level", "the side of the heavier child goes down", "the side of the lighter child goes down"),
    text="Both children move outwards by the same distance. Then",
)  # fmt: skip
VECTOR = Question(
    "c", "w", ("choice",), unit("1"), "Vector or scalar", options=("a", "b", "c", "d"),
    option_texts=("the momentum only", "the kinetic energy only", "both", "neither"), text="Which of the two is a vector?",
)  # fmt: skip


def read(text: str, question: Question):
    return answer_type(question.types[0]).read(Text(text), question)


@pytest.mark.parametrize(
    ("text", "question", "value"),
    [
        ("twice as much: 172 N", FORCE, 172), ("So I get for the force 172 N", FORCE, 172), ("this time it's twice as big, 172 N", FORCE, 172),
        ("then it is twice that, so 172 N", FORCE, 172), ("two times as much as before, so 172 N", FORCE, 172), ("then F is 172 N", FORCE, 172),
        ("The average force must then be 172 N", FORCE, 172), ("it is pushed backwards, so the force is -100 N", FORCE, -100),
        ("it takes the car 7.41 s", TIME, 7.41), ("after 7.41 s", TIME, 7.41),         ("the mass is 1.77 kg, nitrogen in the bottle", MASS, 1.77),
        ("only 1.77 kg", MASS, 1.77),
        ("56.25 cm behind the mirror", IMAGE, 0.5625), ("13.1 % of it", SHARE, 0.131),
        ("0.8 m/s to the left, i.e. -0.8 m/s", VELOCITY, -0.8), ("9.90 m/s which is about 35.6 km/h", VELOCITY, 9.9),
        ("it flies back to the left at 9 m/s, so -9 m/s", VELOCITY, -9), ("it flies to the left at 9 m/s", VELOCITY, -9), ("3 m/s west", VELOCITY, -3),
        ("3 m/s to the north", VELOCITY, 3),
        ("v² = 2gh = 98, v = 9.90 m/s", VELOCITY, 9.9), ("0 = 2u - (-6) -> u = -3.00 m/s", VELOCITY, -3),
        ("v = sqrt(0.7*9.8*60) = 20.29 m/s = 73.0 km/h", VELOCITY, 20.29),
        ("1 - 285.15/328.15 = 0.131 = 13.1 %", SHARE, 0.131), ("65 % of 20 cm = 13 cm", IMAGE, 0.13), ("t = 432408/(0.88*2000) = 245.7 s = 4.09 min", TIME, 245.4),
        ("4:06 min", TIME, 246), ("4m 6s", TIME, 246), ("4 min, 6 s", TIME, 246), ("1:30 h", TIME, 5400), ("√40 m/s", VELOCITY, 6.3246),
    ],
)  # fmt: skip
def test_words_and_work_around_a_result_are_passed_over(text, question, value):
    found = read(text, question)
    assert isinstance(found, Numbers), found
    assert found.values == pytest.approx((value,), rel=2e-3)
    assert not found.misfit
    assert not found.missing


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("half of 344 N", FORCE), ("twice 86 N", FORCE), ("not 172 N", FORCE), ("172 N less than B has", FORCE), ("172 N or 86 N", FORCE), ("86 N, so 172 N", FORCE),
        ("maybe less than 172 N", FORCE), ("172 N per second and ball", FORCE), ("F = 86 N, F = 172 N", FORCE), ("F = 86 N, R = 172 N", FORCE),
        ("in kilonewtons: 172", FORCE),
        ("172 flurbs", FORCE), ("there are 172 flurbs", FORCE), ("if it stuck it would be 172 N", FORCE), ("the force to the left: 172 J", FORCE),
        ("either 1.77 kg in it", MASS),
        ("0.8 m/s to the right, i.e. -0.8 m/s", VELOCITY), ("-0.8 m/s, i.e. 0.8 m/s", VELOCITY), ("0.8 m/s, so 0.9 m/s", VELOCITY), ("3 J to the left", MASS),
        ("4:66 min", TIME), ("twice 1.77 kg of it", MASS), ("half of the 1.77 kg", MASS), ("double: 1.77 kg", MASS), ("anything but 1.77 kg", MASS),
        ("it cannot be 1.77 kg", MASS), ("I doubt 1.77 kg", MASS), ("the uncertainty is 1.77 kg", MASS), ("the first 1.77 kg", MASS),
        ("172 N oppositely", FORCE), ("172 N away from it", FORCE), ("it lacks 1.77 kg", MASS), ("nobody gets 172 N", FORCE), ("172 N or -172 N", FORCE),
        ("172 N, so -172 N", FORCE), ("172 N, i.e. -172 N", FORCE),
        ("0.433 m/s towards my son, to the right, i.e. -0.433 m/s", VELOCITY), ("between 7 s and 7.41 s", TIME), ("7.41 s too much", TIME), ("7.41 s short", TIME),
    ],
)  # fmt: skip
def test_words_that_change_or_take_back_a_result_are_not(text, question):
    found = read(text, question)
    assert isinstance(found, Unclear) or found.misfit or found.missing, found
    if isinstance(found, Unclear):
        assert not found.benefit
        assert not found.sign_alone


@pytest.mark.parametrize(
    ("text", "question", "values"),
    [
        ("7.5 kg m/s east, 10 kg m/s south", MOMENTUM, (7.5, -10)), ("7.5x - 10y", MOMENTUM, (7.5, -10)), ("7.5/-10", MOMENTUM, (7.5, -10)),
        ("p = 2.5*(3,-4) = (7.5, -10)", MOMENTUM, (7.5, -10)), ("p = m v = 2.5 kg (3, -4) m/s = (7.5, -10) kg m/s", MOMENTUM, (7.5, -10)),
        ("(px; py) = (7.5; -10)", MOMENTUM, (7.5, -10)),
        ("2.28 kg m/s along x and nothing along y", MOMENTUM, (2.28, 0)), ("no momentum along x, 1.6 kg m/s along y", MOMENTUM, (0, 1.6)),
        ("The near one is at 0.760 m and the far one at 1.24 m", PLACES, (0.76, 1.24)), ("Near: 0.76 m. Far: 1.24 m.", PLACES, (0.76, 1.24)),
        ("0.3586 2.0903", ROOTS, (0.3586, 2.0903)), ("It is there at 0.359 s on the way up and at 2.09 s on the way down.", ROOTS, (0.359, 2.09)),
    ],
)  # fmt: skip
def test_components_in_sentences_and_along_axes(text, question, values):
    found = read(text, question)
    assert isinstance(found, Numbers), found
    assert found.values == pytest.approx(values)


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("p = 2.5*(3,4) = (7.5, -10)", MOMENTUM), ("p = 2*(3,-4) = (7.5, -10)", MOMENTUM), ("-p = m v = (7.5,-10)", MOMENTUM),
        ("not at 0.760 m and 1.24 m", PLACES), ("one at 0.760 m, the near one at 1.24 m, the far one at 3 m", PLACES),
    ],
)  # fmt: skip
def test_vectors_that_contradict_their_sides_are_asked_about(text, question):
    assert isinstance(read(text, question), Unclear)


@pytest.mark.parametrize(
    ("text", "question", "letter"),
    [
        ("4 times", HEIGHT, "c"), ("4x", HEIGHT, "c"), ("four times as high", HEIGHT, "c"), ("quadruple", HEIGHT, "c"), ("twice as high", HEIGHT, "b"),
        ("it doubles", HEIGHT, "b"),
        ("the same", HEIGHT, "a"), ("just as large", HEIGHT, "a"), ("it does not change", HEIGHT, "a"),
        ("four times as high, because K goes with the square", HEIGHT, "c"),
        ("the heavier child goes down", SIDES, "b"), ("the side of the lighter child", SIDES, "c"), ("it stays level", SIDES, "a"),
        ("momentum", VECTOR, "a"), ("only the momentum", VECTOR, "a"), ("A, momentum", VECTOR, "a"), ("kinetic energy", VECTOR, "b"),
        ("momentum is a vector", VECTOR, "a"),
    ],
)  # fmt: skip
def test_an_option_is_known_by_words_that_it_alone_has(text, question, letter):
    found = read(text, question)
    assert isinstance(found, Letter), found
    assert found.letter == letter


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("the heavier child goes up", SIDES), ("the heavier child rises", SIDES), ("the plank does not stay level", SIDES), ("the side goes down", SIDES),
        ("heavier and lighter", SIDES),
        ("not four times", HEIGHT), ("two or four times", HEIGHT), ("eight times", HEIGHT), ("4 or 2 times as large", HEIGHT), ("not the momentum", VECTOR),
        ("momentum or energy", VECTOR),
        ("momentum is the vector, kinetic energy is not", VECTOR), ("B, momentum", VECTOR), ("everything but the momentum", VECTOR),
    ],
)  # fmt: skip
def test_denied_mixed_and_foreign_words_name_no_option(text, question):
    assert isinstance(read(text, question), Unclear)


@pytest.mark.parametrize(
    ("text", "question"),
    [
        ("There are 1.77 kg of nitrogen in the bottle", MASS), ("the car passes her after 7.41 s on the way", TIME), ("56.25 cm away from it", IMAGE),
    ],
)  # fmt: skip
def test_other_words_beside_what_is_never_negative_leave_it_as_it_is(text, question):
    found = read(text, question)
    assert isinstance(found, Unclear)
    assert found.sign_alone
    assert found.readings[0].values[0] > 0
