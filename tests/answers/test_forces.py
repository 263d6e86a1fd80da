"""The forces on a body: names and directions in words or angles; what is missing, extra, or turned is named."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.answer import Blank, NamedForces, Unclear
from corollary.answers.expected import Expected, FreeBody
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type, judging
from corollary.answers.verdict import Mistaken, Right, Wrong
from corollary.answers.ways import DEGREES, of_a_slope, spellings
from corollary.formula.ball import RationalPi
from corollary.formula.value import Items, Named, Nothing, Real, Text
from corollary.messages import language
from corollary.problem.part import Option
from corollary.problem.reader import read_problem

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
OPTIONS = (
    Option("a", "weight | gravity"),
    Option("b", "normal force | normal"),
    Option("c", "friction"),
    Option("d", "driving force"),
)
PART = replace(PROBLEM.part("a"), answer_types=("forces",), options=OPTIONS, slope="v")
QUESTION = question_of(PROBLEM, PART)
SLOPE = math.radians(30)
BODY = FreeBody(
    (("a", math.radians(270)), ("b", math.radians(120)), ("c", SLOPE)),
    {"d": "Motion needs no force."},
    SLOPE,
    lambda: {"m": RationalPi(Fraction(2)), "v": RationalPi(Fraction(1, 6), 1)},
)


def items(*texts):
    return Items(tuple(map(Text, texts)), (len(texts),))


def read(value):
    return answer_type("forces").read(Text(value) if isinstance(value, str) else value, QUESTION)


def judged(value):
    return judging("forces").judge(read(value), Expected(QUESTION, free_body=BODY))


@pytest.mark.parametrize(
    "value",
    [
        items("weight: down", "normal force: away from the slope", "friction: up the slope"),
        items("friction uphill", "gravity downwards", "normal 120°"),
        "weight down, normal force away from the slope, friction up the slope",
        "weight: 270 deg; normal: 120 deg; friction: 30 deg",
        "weight = -90°\nnormal = 2/3 pi rad\nfriction → 30°",
        Named(
            ("weight", "normal force", "friction"),
            (Text("vertically down"), Real(120.0), Text("up the incline")),
        ),
        Items(
            (items("weight", "down"), items("normal force", "120 deg"), items("friction", "30 deg")), (3, 2)
        ),
    ],
)
def test_all_ways_to_name_them_are_right(value):
    assert judged(value) == Right()


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (items("weight: down", "friction: 30°"), ["Not named: normal force"]),
        (items("weight: down", "normal: up", "friction: 30°"), ["direction again: normal force"]),
        (items("weight: down", "normal: 120°", "friction: down the slope"), ["direction again: friction"]),
        (items("weight: up", "driving force: 30°"), ["Motion needs", "Not named: normal force, friction", "again: weight"]),
        (items("weight: down", "weight: down", "normal: 120°", "friction: 30°"), ["too often: weight"]),
        (items("weight: down", "normal: 123°", "friction: 30°"), ["direction again: normal force"]),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(value, words):
    verdict = judged(value)
    assert isinstance(verdict, Wrong)
    assert all(each in verdict.why for each in words), verdict.why


def test_a_force_that_does_not_act_is_a_misconception_when_it_is_all_that_is_wrong():
    right = ["weight: down", "normal: 120°", "friction: 30°"]
    assert judged(items(*right, "driving force: down the slope")) == Mistaken("Motion needs no force.")


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (items("weigth: down"), "did you mean weight"),
        (items("weight: dwon"), "did you mean down"),
        (items("weight: somewhere"), "none of these: up, down, left, right, up the slope"),
        (items("magnetism: up"), "none of these: weight, normal force"),
        (items("weight"), "should be a name and a direction"),
        (Real(3.0), "as a name and a direction"),
    ],
)
def test_what_cannot_be_read_is_said_and_never_wrong(value, words):
    found = read(value)
    assert isinstance(found, Unclear)
    assert words in found.why


def test_nothing_is_blank():
    for value in (Nothing(), Items((), (0,)), "", "..."):
        assert isinstance(read(value), Blank)


def test_without_a_slope_there_are_no_directions_of_one():
    level = replace(QUESTION, slope="")
    assert "slope" not in answer_type("forces").instructions(level)
    assert isinstance(answer_type("forces").read(items("weight: up the slope"), level), Unclear)


def test_directions_in_german_are_read_on_a_german_sheet():
    with language("de"):
        german = replace(QUESTION, option_texts=("Gewichtskraft", "Normalkraft", "Reibung", "Antrieb"))
        typed = items("Gewichtskraft: nach unten", "Normalkraft: vom Hang weg", "Reibung: hangaufwärts")
        found = answer_type("forces").read(typed, german)
        assert isinstance(found, NamedForces), found
        assert judging("forces").judge(found, Expected(german, free_body=BODY)) == Right()
        assert "nach unten" in answer_type("forces").instructions(german)


@given(st.permutations(["weight: 270°", "normal force: 120°", "friction: 30°"]), st.integers(-2, 2))
def test_neither_the_order_nor_whole_turns_matter(lines, turns):
    turned = [
        f"{line.partition(':')[0]}: {int(line.partition(': ')[2][:-1]) + 360 * turns}°" for line in lines
    ]
    assert judged(items(*turned)) == Right()


def test_opposite_ways_are_half_a_turn_apart_and_the_slope_s_own_stand_upright_on_each_other():
    for way, opposite in (
        ("up", "down"), ("right", "left"), ("up the slope", "down the slope"), ("away from the slope", "into the slope"),
    ):  # fmt: skip
        assert (DEGREES[opposite] - DEGREES[way]) % 360 == 180
    assert (
        (DEGREES["right"], DEGREES["up"])
        == (DEGREES["up the slope"], DEGREES["away from the slope"])
        == (0, 90)
    )
    assert all(0 <= degrees < 360 for degrees in DEGREES.values())
    assert set(spellings(with_slope=True)) == set(DEGREES)
    assert [way for way in DEGREES if of_a_slope(way)] == [
        way for way in DEGREES if way.endswith(" the slope")
    ]
