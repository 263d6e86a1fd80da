"""Words from a list: any spelling is right, what is nearly a word goes to a person or back to the student, never wrong."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from corollary.answers.answer import Letter, Unclear
from corollary.answers.expected import Expected, RightOption
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type, judging
from corollary.answers.spellings import distance
from corollary.answers.verdict import Mistaken, Right, Unmarked, Unread
from corollary.formula.value import Real, Text
from corollary.grading.judge import verdict_on
from corollary.problem.part import Option
from corollary.problem.reader import read_problem

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
OPTIONS = (
    Option("a", "circle"),
    Option("b", "ellipse | elliptic orbit | oval"),
    Option("c", "parabola"),
    Option("d", "ungleichförmige Bewegung"),
)
QUESTION = question_of(PROBLEM, replace(PROBLEM.part("a"), answer_types=("word",), options=OPTIONS))
EXPECTED = Expected(QUESTION, option=RightOption("b", {"a": "Then it were slower."}))


def read(typed):
    return answer_type("word").read(Text(typed) if isinstance(typed, str) else typed, QUESTION)


@pytest.mark.parametrize(
    ("typed", "letter"),
    [
        ("ellipse", "b"), ("an Ellipse.", "b"), ("ELLIPTIC ORBIT", "b"), ("oval", "b"), ("the circle", "a"),
        ("ungleichfoermige bewegung", "d"), ("Ungleichförmige Bewegung", "d"),
    ],
)  # fmt: skip
def test_each_spelling_is_the_word(typed, letter):
    found = read(typed)
    assert isinstance(found, Letter)
    assert found.letter == letter


@pytest.mark.parametrize("typed", ["elipse", "elllipse", "ellispe", "ellipsa"])
def test_a_slip_of_a_finger_goes_to_a_person_and_is_said_while_writing(typed):
    assert isinstance(read(typed), Unclear)
    preview = answer_type("word").preview(Text(typed), QUESTION)
    assert not preview.ok
    assert "did you mean “ellipse”" in preview.text
    assert isinstance(verdict_on("word", read(typed), EXPECTED), Unmarked)


def test_what_is_nearly_a_wrong_word_is_not_read():
    verdict = verdict_on("word", read("parabole"), EXPECTED)
    assert isinstance(verdict, Unread)
    assert "“parabola”" in verdict.why


def test_what_is_near_no_word_is_told_the_words():
    for typed in ("a straight line", "x", Real(3.0)):
        found = read(typed)
        assert isinstance(found, Unclear)
        assert "circle, ellipse, parabola" in found.why
        assert not found.near


def test_a_word_is_judged_by_its_option():
    assert judging("word").judge(read("oval"), EXPECTED) == Right()
    assert judging("word").judge(read("circle"), EXPECTED) == Mistaken("Then it were slower.")


@given(st.text("abc", max_size=6), st.text("abc", max_size=6), st.text("abc", max_size=6))
def test_a_distance_is_one(one, other, third):
    assert (distance(one, other) == 0) == (one == other)
    assert distance(one, other) == distance(other, one)
    assert distance(one, other) <= max(len(one), len(other))
    assert distance(one + third, other + third) <= distance(one, other)


def test_the_distance_of_known_pairs():
    assert distance("kitten", "sitting") == 3
    assert distance("ab", "ba") == 1
    assert distance("", "abc") == 3
