"""Answers as students type them: the honest ones are right, however they are written, and no wrong one becomes right by that."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from corollary.answers.verdict import Follows, Right, Unmarked
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge
from corollary.grading.key import Key

FOLDER = Path(__file__).with_name("answers")


def groups(name: str) -> Iterator[Any]:
    """What is asked, and the answers to it, by what is odd about them."""
    for group, questions in json.loads(FOLDER.joinpath(f"{name}.json").read_text(encoding="utf-8")).items():
        for question in questions:
            yield pytest.param(question, id=f"{group}, {question['code']} {question['part']}")


def verdicts(key: Callable[..., Key], question: dict[str, Any]) -> list[tuple[Any, Any]]:
    """Each answer and its verdict, as if it were the only one given."""
    own = key(question["code"], **{name: str(value) for name, value in question["given"].items()})
    part = question["part"]
    return [(answer, judge(own, {part: from_json(answer)})[part][0][0]) for answer in question["answers"]]


@pytest.mark.parametrize("question", list(groups("honest")))
def test_an_honest_answer_is_right(key, question: dict[str, Any]):
    assert not [each for each in verdicts(key, question) if not isinstance(each[1], Right)]


@pytest.mark.parametrize("question", list(groups("wrong")))
def test_a_wrong_answer_is_not(key, question: dict[str, Any]):
    assert not [each for each in verdicts(key, question) if isinstance(each[1], Right | Follows)]


@pytest.mark.parametrize(
    ("code", "part", "answer"),
    [
        ("X12.10", "b", "20.58 J (heat)"),
        ("X12.6", "a", "100 kN gegen die Fahrtrichtung"),
        ("T12.3", "c", "3465 N (as far as we can tell)"),
        ("S12.5el", "b", "B goes back at 3.2 m/s"),
        ("S12.5el", "e", "A stops, B moves to the left at 4 m/s"),
        ("X12.8", "c2", "1.57 m/s away from me"),
        ("X12.2", "c", "2 m/s towards object 1"),
        ("X12.11", "b", "3 m/s downward (away from the ball)"),
    ],
)
def test_words_that_may_be_a_sign_are_read_by_a_person(key, code: str, part: str, answer: str):
    assert isinstance(judge(key(code), {part: from_json(answer)})[part][0][0], Unmarked)


@pytest.mark.parametrize(
    ("code", "part", "answer"),
    [
        ("P12.14", "h2", "x=v0*sqrt(m/2k)"),
        ("P12.14", "h2", "v0 √(m/2k)"),
        pytest.param("P12.15", "e", "d*√3k/m", marks=pytest.mark.whole),  # half a minute to solve
        ("T12.3", "a", "√2gh"),
        ("T12.3", "a", "sqrt2gh"),
        ("X12.1", "a", "4/2v"),
        ("E12.7.2", "a", "vrel ln m0/m1"),
        ("E12.7.2", "b", "m0 e^-dv/vrel"),
    ],
)
def test_a_formula_whose_end_only_a_bracket_would_settle_is_read_by_a_person(
    key, code: str, part: str, answer: str
):
    assert isinstance(judge(key(code), {part: from_json(answer)})[part][0][0], Unmarked)


def test_there_are_many_of_both():
    counted = {
        name: sum(len(question.values[0]["answers"]) for question in groups(name))
        for name in ("honest", "wrong")
    }
    assert counted["honest"] > 600
    assert counted["wrong"] > 300
