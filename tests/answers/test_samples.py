"""Samples of answers are what they claim: a wrong one is far off, a doubtful one is near a word, and no proof is its claim alone."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.questions import question_of
from corollary.answers.registry import judging
from corollary.problem.part import Option
from corollary.problem.reader import read_problem

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
VALUE = PROBLEM.part("a")


def samples(truth, **changed):
    part = replace(VALUE, **changed)
    return judging(part.answer_type).samples(truth, question_of(PROBLEM, part))


def numbers(answer):
    return [float(each.split()[0]) for each in answer]


@pytest.mark.parametrize("truth", [(3.0, 4.0), (3000.0, -4000.0), (0.003, 0.004), (0.0, 0.0), (0.0, 500.0)])
def test_a_wrong_vector_is_off_by_a_third_of_its_length_and_no_component_fits(truth):
    found = samples(truth, answer_types=("vector",), components=("x", "y"))
    (wrong,) = (numbers(each.answer) for each in found if each.verdict == "wrong")
    size = math.hypot(*truth) or 1.0
    assert math.dist(wrong, truth) > 0.3 * size
    assert all(abs(mine - right) > 0.2 * size for mine, right in zip(wrong, truth, strict=True))
    for right in (numbers(each.answer) for each in found if each.verdict == "right"):
        assert right == pytest.approx(truth, rel=1e-3)
    assert [len(each.answer) for each in found if each.verdict == "unread" and isinstance(each.answer, list)] == [
        len(truth) - 1, len(truth), 2,
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("word", "doubtful"),
    [("ellipse | oval", ["ellips"]), ("waves | wave", []), ("oval", []), ("ring", [])],
)
def test_a_word_without_its_last_letter_is_for_a_person_unless_it_is_a_word_too(word, doubtful):
    options = (Option("a", word), Option("b", "parabola"))
    found = samples("a", answer_types=("word",), options=options)
    assert [each.answer for each in found if each.verdict == "unmarked"] == doubtful
    assert [each.answer for each in found if each.verdict == "wrong"] == ["parabola"]
    assert [each.answer for each in found if each.verdict == "right"][:-1] == word.split(" | ")


def test_neither_the_claim_alone_nor_a_false_end_is_a_proof():
    found = samples("p = m*v\nv = 2*u\nm = p/(2*u)", answer_types=("proof",), components=("p",))
    assert [(each.answer, each.verdict) for each in found[:3]] == [
        (["p = m*v", "v = 2*u", "m = p/(2*u)"], "right"),
        (["1 = 1", "m = p/(2*u)"], "wrong"),
        (["p = m*v", "v = 2*u", "0 = 1"], "wrong"),
    ]
