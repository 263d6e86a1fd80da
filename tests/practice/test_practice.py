"""Exercises to practise on: other numbers each turn, answers judged part by part, the worked solution step by step."""

from __future__ import annotations

import pytest

from corollary.practice.offline import known
from corollary.practice.practice import practice
from corollary.problem.bank import chapter_bank


@pytest.fixture(scope="module")
def some():
    return practice(chapter_bank(), ["X12.5", "P12.14", "S12.0"])


def test_a_turn_has_numbers_of_its_own_and_the_same_when_it_is_asked_again(some):
    given = [some.pose("X12.5", turn).key.variant.values for turn in range(5)]
    assert len({tuple(each.values()) for each in given}) == 5
    some.posed.clear()
    assert some.pose("X12.5", 3).key.variant.values == given[3]


def test_an_answer_is_read_and_then_judged(some):
    """0.43 kg at 20 m/s: 8.6 kg m/s; over 0.1 s that is 86 N."""
    kick = some.pose("X12.5", 0)
    assert kick.preview("a", "8,6 Ns").text == "read as 8.6 N s (2 figures)"
    assert not kick.preview("a", "8.6 J").ok
    right = kick.judged("a", {"a": "8.6 kg m/s"})
    assert known(right.verdict)
    assert not known(kick.judged("a", {"a": "86 kg m/s"}).verdict)
    follows = kick.judged("c", {"b": "9.2 N s", "c": "92 N"})
    assert known(follows.verdict)
    assert "follows" in follows.feedback
    energy = kick.judged("a", {"a": "86 J"})
    assert "8.6" not in energy.feedback


def test_the_worked_solution_comes_step_by_step(some):
    steps = some.pose("X12.5", 0).worked_steps
    assert len(steps) == 5
    assert "8.600" in steps[0]
    assert "86.00" in steps[2]
    assert "### (a)" in steps[0]
    assert "### (b)" not in steps[0]


def test_what_is_chosen_is_a_code_a_name_or_a_topic():
    assert {each.topic for each in practice(chapter_bank(), ["impulse"]).problems} == {"impulse"}
    assert [each.code for each in practice(chapter_bank(), ["kicking_a_ball"]).problems] == ["X12.5"]
    with pytest.raises(LookupError, match="its topics are"):
        practice(chapter_bank(), ["optics"])


def test_what_is_left_out_cannot_be_posed():
    found = practice(chapter_bank(), ["impulse"], {"X12.5"})
    with pytest.raises(LookupError, match=r"X12\.5"):
        found.pose("X12.5", 0)
    with pytest.raises(LookupError, match="no problem is left"):
        practice(chapter_bank(), ["X12.5"], {"X12.5"})
