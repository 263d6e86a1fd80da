"""What is said of numbers that are wrong, without giving the right ones away."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.answer import Numbers
from corollary.answers.expected import Quantity
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.questions import question_of
from corollary.answers.verdict import Right, Wrong
from corollary.problem.reader import read_problem
from corollary.units.unit import unit

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
LINE = PROBLEM.part("a")
PLANE = replace(LINE, answer_types=("vector",), components=("x", "y"))


def said(part, scale, truth, *typed):
    wanted = Quantity(truth, scale, 0.01, (0.0,) * len(truth), dict, None, dict, list, list, list)
    verdict = judge_numbers(Numbers(typed, (4,) * len(typed), ""), wanted, question_of(PROBLEM, part))
    assert isinstance(verdict, Wrong)
    return verdict.why


@pytest.mark.parametrize(
    ("times", "words"),
    [
        (150.0, "powers of ten"),
        (-150.0, "powers of ten"),
        (1 / 150.0, "powers of ten"),
        (50.0, "does not follow from the numbers"),
        (0.02, "does not follow from the numbers"),
        (-3.0, "Neither the sign nor the size"),
        (1.03, "Close, but outside what rounding explains"),
        (0.97, "Close, but outside what rounding explains"),
        (1.07, "does not follow from the numbers"),
    ],
)
def test_how_far_off_a_number_is(times, words):
    assert words in said(LINE, 8.6, (8.6,), 8.6 * times)


def test_a_component_fits_when_it_is_as_near_as_the_whole_must_be():
    """The vector is 500 long and may be off by 1 %, that is by 5 along each axis."""
    assert said(PLANE, 500.0, (300.0, 400.0), 304.0, 250.0) == ("Component x fits; look at the other again.")
    assert "fit" not in said(PLANE, 500.0, (300.0, 400.0), 306.0, 250.0).replace("does not follow", "")
    assert "rounding" in said(PLANE, 500.0, (300.0, 400.0), 304.0, 396.0)


def test_all_but_one_fit():
    space = replace(PLANE, components=("A", "B", "C"))
    assert said(space, 13.0, (3.0, 4.0, 12.0), 3.0, 4.0, 9.0) == (
        "Components A and B fit; look at the other again."
    )
    assert said(space, 13.0, (3.0, 4.0, 12.0), 3.0, 1.0, 9.0) == (
        "Component A fits; look at the others again."
    )


def test_a_temperature_is_near_as_it_is_written_in_degrees_celsius():
    """20 °C may be 20.1 °C at one percent; 21 °C is as far off as 21 m from 20 m, though 294 K and 293 K are near."""
    room = replace(LINE, unit=unit("degC"))
    wanted = Quantity((293.15,), 293.15, 0.01, (0.0,), dict, None, dict, list, list, list)
    question = question_of(PROBLEM, room)
    near = judge_numbers(Numbers((293.25,), (4,), ""), wanted, question)
    far = judge_numbers(Numbers((294.15,), (4,), ""), wanted, question)
    assert isinstance(near, Right)
    assert isinstance(far, Wrong)
