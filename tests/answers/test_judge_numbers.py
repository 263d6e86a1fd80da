"""What is said of numbers that are wrong, without giving the right ones away."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.answer import Numbers
from corollary.answers.expected import Quantity
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type
from corollary.answers.verdict import Right, Slip, Wrong
from corollary.formula.value import Text
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
        (1.03, "Close, but rounding does not explain it"),
        (0.97, "Close, but rounding does not explain it"),
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


@pytest.mark.parametrize(
    ("celsius", "typed", "verdict"),
    [
        (20.0, "293 K", Right()),
        (20.0, "293.2 K", Right()),
        (20.0, "293.15 K", Right()),
        (20.0, "292 K", None),
        (20.0, "294 K", None),
        (20.0, "293.4 K", None),
        (20.0, "68 °F", Right()),
        (20.0, "68.0 °F", Right()),
        (20.0, "69 °F", None),
        (5.2, "278.4 K", Right()),
        (5.2, "278 K", Right()),
        (5.2, "279 K", None),
        (-5.2, "268 K", Right()),
        (-5.2, "-5.2 °C", Right()),
        (0.5, "273.7 K", Right()),
        (0.5, "273.6 K", Right()),
        (0.5, "274 K", Right()),
        (0.5, "32.9 °F", Right()),
        (0.0, "273 K", Right()),
        (0.0, "32 °F", Right()),
        (37.0, "98.6 °F", Right()),
        (20.0, "20.2 °C", None),
    ],
)
def test_a_temperature_is_rounded_in_the_unit_in_which_it_was_typed(celsius, typed, verdict):
    """Whole kelvins are 293 K for 20 °C, and 0.15 K off; so many degrees Celsius off is wrong."""
    assert of_temperature(celsius, typed) == verdict


@pytest.mark.parametrize("typed", ["2.9e2 K", "3e2 K"])
def test_kelvins_in_two_figures_tell_no_temperature(typed):
    assert of_temperature(20.0, typed) == Slip(
        "Rounded too far to tell: give three significant figures.", once=False, nothing=True
    )


def test_degrees_are_counted_in_degrees_where_kelvins_are_asked_for():
    """20 °C are two figures of a temperature that is 293.15 K, not two figures of 293."""
    warm = replace(LINE, unit=unit("K"))
    wanted = Quantity((297.0,), 297.0, 0.005, (0.0,), dict, None, dict, list, list, list)
    question = question_of(PROBLEM, warm)
    found = judge_numbers(answer_type("value").read(Text("20 °C"), question), wanted, question)
    assert isinstance(found, Wrong)


def of_temperature(celsius: float, typed: str):
    """The verdict, without its words where it is wrong."""
    room = question_of(PROBLEM, replace(LINE, unit=unit("degC")))
    kelvin = celsius + 273.15
    wanted = Quantity(
        (kelvin,), abs(celsius), 0.005, (0.0,), dict, None, dict, list, list, list, residue=(1e-7,)
    )
    verdict = judge_numbers(answer_type("value").read(Text(typed), room), wanted, room)
    return None if isinstance(verdict, Wrong) else verdict
