"""What is tried as a wrong example is wrong also where the laws leave a direction free."""

from __future__ import annotations

from types import SimpleNamespace

from corollary.answers.example.judging import samples
from corollary.units.unit import unit


def test_a_wrong_example_is_no_multiple_of_the_right_one():
    right, wrong, *_unread = samples([-1 / 3, -1 / 3], SimpleNamespace(unit=unit("1")))
    assert (right.verdict, wrong.verdict) == ("right", "wrong")
    assert wrong.answer[0] / right.answer[0] != wrong.answer[1] / right.answer[1]
