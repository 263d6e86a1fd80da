"""What a key expects of a part: of each sort what the question asks for, and nothing replayed before it is needed."""

from __future__ import annotations

import pytest

from corollary.answers.verdict import Right
from corollary.grading import expectations as module
from corollary.grading.expectations import domain, expected_of
from corollary.grading.from_json import from_json
from corollary.grading.judge import judge

SORTS = {"a": "quantity", "b": "quantity", "c": "quantity", "d": "option", "e": "claim", "h": "requirement"}


def test_of_each_part_just_what_is_asked_for(key):
    own = key("T1")
    for part in own.variant.problem.parts:
        expected = expected_of(own, part)
        given = [
            sort
            for sort in ("quantity", "option", "claim", "requirement")
            if getattr(expected, sort) is not None
        ]
        assert given == ([SORTS[part.id]] if part.id in SORTS else ["quantity"] if part.id == "i" else [])
        assert bool(expected.rubric) == (part.id == "f")


def test_a_right_answer_is_judged_without_a_replay(key, monkeypatch):
    def replayed(*_args):
        raise AssertionError("nothing has to be replayed for an answer that is right")

    own = key("X12.5")
    monkeypatch.setattr(module, "consequences", replayed)
    monkeypatch.setattr(module, "wrong_formulas", replayed)
    for answer in ("8.6 kg m/s", 8.6, "m*v"):
        ((verdict,), _) = judge(own, {"a": from_json(answer)})["a"]
        assert isinstance(verdict, Right)


def test_letters_live_on_the_grid_in_si_and_a_fixed_one_within_a_tenth(solution):
    box = domain(solution("T1").problem)
    assert box["m"] == (0.2, 0.9)
    assert box["v"] == pytest.approx((5.0, 20.0))
    assert box["theta"] == pytest.approx((0.3490658503988659, 1.2217304763960306))
    assert box["g"] == pytest.approx((8.829, 10.791))
