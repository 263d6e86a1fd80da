"""Intervals: in words, in brackets, as a chain, around a middle; judged by both ends."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.answer import Blank, Formulas, Numbers, Unclear
from corollary.answers.expected import Expected, FollowThrough, Quantity
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type, judging
from corollary.answers.verdict import Follows, Mistaken, Right, Wrong
from corollary.formula.value import Nothing, Real, Text
from corollary.messages import language
from corollary.problem.reader import read_problem
from corollary.units.unit import unit

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
ENDS = replace(PROBLEM.part("a"), answer_types=("interval",), components=("low", "high"), unit=unit("m"))
QUESTION = question_of(PROBLEM, ENDS)


def read(typed):
    return answer_type("interval").read(typed if not isinstance(typed, str) else Text(typed), QUESTION)


@pytest.mark.parametrize(
    "typed",
    [
        "-0.2 m to 0.5 m", "from -20 cm to 50 cm", "between -0.2 and 0.5 m", "[-0.2; 0.5] m", "[-0.2, 0.5] m",
        "-0.2 m < x < 0.5 m", "-0.2 m ≤ x <= 50 cm", "0.5 m > x > -0.2 m", "-0.2 ... 0.5 m", "von -0,2 m bis 0,5 m",
        "mellom -0,2 m og 0,5 m", "0.15 m ± 0.35 m", "0.15 ± 0.35 m", "(0.15 +/- 0.35) m",
    ],
)  # fmt: skip
def test_an_interval_is_read(typed):
    found = read(typed)
    assert isinstance(found, Numbers), found
    assert sorted(found.values) == pytest.approx([-0.2, 0.5], abs=1e-12)


@pytest.mark.parametrize(
    "typed",
    [
        "±20 cm",
        "+/- 0.2 m",
        "|x| < 0.2 m",
        "|x| ≤ 20 cm",
        "abs(x) <= 0.2",
        "0 ± 0.2 m",
        "x between -0.2 m and 0.2 m",
        "x lies between -20 cm and +20 cm",
    ],
)
def test_an_interval_about_zero_is_read(typed):
    found = read(typed)
    assert isinstance(found, Numbers), found
    assert sorted(found.values) == pytest.approx([-0.2, 0.2], abs=1e-12)


@pytest.mark.parametrize("typed", ["|x| > 0.2 m", "|x| < -0.2 m", "|x| = 0.2 m", "±", "x < 0.2 m"])
def test_what_is_outside_of_zero_is_no_interval(typed):
    assert isinstance(read(typed), Unclear)


@pytest.mark.parametrize("typed", ["2 m", "x < 2 m", "2"])
def test_of_one_end_the_other_is_asked_for(typed):
    answer = read(typed)
    assert isinstance(answer, Unclear)
    assert answer.why == 'an interval has two ends; write both, such as "-1.5 to 2.5"'


def test_what_is_no_interval_is_not_guessed():
    assert isinstance(read("0.2 m"), Unclear)
    assert isinstance(read("rather long"), Unclear)
    assert isinstance(read(Real(0.2)), Unclear)
    assert isinstance(read(Nothing()), Blank)


def test_it_is_shown_as_it_was_read_in_the_language_spoken():
    with language("de"):
        assert (
            answer_type("interval")
            .preview(Text("-0,2 m bis 0,5 m"), QUESTION)
            .text.startswith("gelesen als von -0,2 m bis 0,5 m")
        )


def judged(typed, follow=()):
    wanted = Quantity(
        (-0.2, 0.5), 0.54, 0.01, (0.0, 0.0), dict, None, dict, list, list,
        lambda: [FollowThrough((-0.2, 0.5), (), lambda: [((0.0, 0.5), "It swings to both sides.")]), *follow],
    )  # fmt: skip
    return judging("interval").judge(read(typed), Expected(QUESTION, quantity=wanted))


def test_both_ends_count_in_whichever_order():
    assert judged("-0.200 m to 0.500 m") == Right()
    assert judged("0.500 m to -0.200 m") == Right()
    assert isinstance(judged("-0.200 m to 0.610 m"), Wrong)
    assert judged("0 m to 0.500 m") == Mistaken("It swings to both sides.")


def test_an_interval_follows_though_its_ends_come_the_other_way_round():
    turned = FollowThrough((0.3, -0.1), ("b",))
    assert judged("-0.100 m to 0.300 m", [turned]) == Follows(("b",))


def test_formulas_are_ends_too():
    assert isinstance(
        answer_type("interval").read(Text("-v*m to v*m"), replace(QUESTION, unit=unit("kg m/s"))), Formulas
    )
