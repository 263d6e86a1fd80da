"""The positive direction in a problem's own words, and words behind a number that it gives a sign."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from corollary.answers.answer import Numbers, Unclear
from corollary.answers.positive_direction import angle_reference, named_positive
from corollary.answers.question import Question
from corollary.answers.registry import answer_type
from corollary.formula.value import Text
from corollary.units.unit import unit


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("You fall by 5 m. **Up is positive.** Neglect drag.", "up"),
        (
            "The direction *towards* the wall is positive, and the velocity before is 3 m/s.",
            "the direction towards the wall",
        ),
        (
            "Take the direction in which the ball leaves as positive.",
            "take the direction in which the ball leaves",
        ),
        ("It falls, with *down* as positive direction.", "it falls, with down"),
        ("A ball flies to the right, the positive direction, at 3 m/s.", "a ball flies to the right"),
        ("A velocity is positive in the direction in which the body moves.", "a velocity"),
        ("The positive pole is at the top.", ""),
    ],
)
def test_a_statement_names_it(text, words):
    assert named_positive(text) == words


def test_the_part_has_the_last_word():
    assert named_positive("Up is positive.", "Here down is positive.") == "here down"
    assert named_positive("Up is positive.", "How fast?") == "up"


def read(text: str, its_unit: str = "m/s", **more: str):
    question = replace(Question("a", "a", ("value",), unit(its_unit)), **more)
    return answer_type("value").read(Text(text), question)


@pytest.mark.parametrize(
    ("text", "positive", "value"),
    [
        ("3 m/s downwards", "", -3),
        ("3 m/s downwards", "down", 3),
        ("3 m/s up", "here down", -3),
        ("3 m/s to the left", "velocities to the left", 3),
        ("3 m/s downwards", "velocities to the left", -3),
        ("3 m/s to the left", "a is to the left of b, and velocities to the right", -3),
        ("3 m/s (positive, up)", "up", 3),
        ("3 m/s down, negative", "up", -3),
        ("3 m/s towards the wall", "the direction towards the wall", 3),
        ("3 m/s straight at the wall", "the direction towards the wall", 3),
        ("3 m/s away from the wall", "the direction towards the wall", -3),
        ("0 m/s (he has not moved yet)", "", 0),
        ("0 m/s, it hasn't started yet", "", 0),
    ],
)
def test_words_behind_a_number_have_the_sign_of_the_problem(text, positive, value):
    found = read(text, positive=positive)
    assert isinstance(found, Numbers), found
    assert found.values == (value,)


@pytest.mark.parametrize(
    ("text", "positive"),
    [
        ("3 m/s (positive, up)", "down"),
        ("3 m/s towards the wall", "the direction in which the ball leaves"),
        ("3 m/s straight at the wall", ""),
        ("3 m/s in the direction of car 2", "the direction in which car 1 drives"),
        ("3 m/s (he has not moved yet)", ""),
    ],
)
def test_what_the_problem_does_not_say_is_asked(text, positive):
    found = read(text, positive=positive)
    assert isinstance(found, Unclear)
    assert {each.values for each in found.readings} == {(3,), (-3,)}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("3 m/s in the direction of motion", 3),
        ("3 m/s against the motion", -3),
        ("3 m/s opposite to the direction of motion", -3),
        ("3 m/s along the motion", 3),
    ],
)
def test_words_on_the_motion_give_a_sign_where_it_is_the_positive_direction(text, value):
    found = read(text, positive="the direction in which the car drives")
    assert isinstance(found, Numbers)
    assert found.values == (value,)
    assert isinstance(read(text, positive="the direction away from the wall"), Unclear)


@pytest.mark.parametrize(
    "text", ["301 kg left", "301 kg are left", "301 kg is left over", "301 kg remaining"]
)
def test_a_mass_that_is_left_has_no_direction(text):
    found = read(text, "kg")
    assert isinstance(found, Numbers)
    assert found.values == (301,)


def test_a_speed_takes_no_sign_from_words():
    found = read("12 m/s downwards", title="Speed at the ground")
    assert isinstance(found, Numbers)
    assert found.values == (12,)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("Through which angle from the vertical does it swing?", "vertical"),
        ("An angle of 30° above the horizontal", "horizontal"),
        ("By what angle below the horizontal does it move?", "below horizontal"),
        ("Unter welchem Winkel unterhalb der Horizontalen?", "below horizontal"),
        ("How far?", ""),
    ],
)
def test_a_problem_says_from_where_an_angle_is_counted(text, line):
    assert angle_reference(text) == line


def test_an_angle_from_another_line_is_asked_about():
    """30° from the vertical are 60° from the horizontal."""
    assert isinstance(read("30° from the vertical", "deg", reference="vertical"), Numbers)
    assert isinstance(read("30° from the horizontal", "deg"), Numbers)
    found = read("30° from the vertical", "deg")
    assert isinstance(found, Unclear)
    assert [round(math.degrees(each.values[0])) for each in found.readings] == [30, 60]


@pytest.mark.parametrize("text", ["20 m", "20m"])
def test_a_bare_m_where_a_time_is_asked_is_asked_about(text):
    found = read(text, "s")
    assert isinstance(found, Unclear)
    assert "m can be minutes or metres" in found.why
    assert isinstance(read("20 min", "s"), Numbers)
    assert isinstance(read(text, "m"), Numbers)
