"""Functions and figures judged by a formula: what is right passes, and of what is wrong is said what is off, where and by how much."""

from __future__ import annotations

import math
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from corollary.answers.verdict import Mistaken, Right, Unread, Wrong
from corollary.api import judge
from corollary.derive.solution import Solution
from corollary.derive.statements import Fault
from corollary.formula.value import Items, Real
from corollary.grading.program_run import ProgramRun
from corollary.grading.programs.formula_judges import plot_judge
from corollary.grading.programs.judge_programs import asks, judge_code, plot_of
from corollary.grading.solutions import Solutions
from corollary.grading.verdict_text import sentence
from corollary.problem.bank import Bank, find
from corollary.problem.variant import chapter
from corollary.sandbox.job import Axes, CallResult, DrawnLine

BANK = Bank(Path(__file__).parents[2] / "author" / "bank")
PROBLEM = find(BANK, "ONE.6")
VARIANT, SECRET = chapter(PROBLEM), b"course"
V, A = 20.0, 5.0  # it stands after 4 s


@cache
def solution() -> Solution:
    return Solutions(BANK).of(PROBLEM)


def way(v: float, a: float, t: float) -> float:
    """As a textbook has it, with a case for rest."""
    return v * t - a * t**2 / 2 if t < v / a else v**2 / (2 * a)


# functions


def returned(program, student: str = "ada"):
    part = PROBLEM.part("a")
    found = {}
    for ask in asks(solution(), VARIANT, part, SECRET, student):
        value = program(**dict(ask.arguments))
        several = value if isinstance(value, tuple) else (value,)
        found[ask.key] = CallResult(Items(tuple(map(Real, several)), (len(several),)), "", "")
    return judge_code(solution(), VARIANT, part, ProgramRun(found, (), True), SECRET, student)


@pytest.mark.parametrize("student", ["ada", "bob", "cleo"])
def test_a_right_function_is_right_for_everybody(student):
    assert isinstance(returned(way, student), Right)


def test_students_are_asked_for_other_arguments_and_all_for_the_corners():
    part = PROBLEM.part("a")
    calls = {
        name: [dict(ask.arguments) for ask in asks(solution(), VARIANT, part, SECRET, name)]
        for name in ("ada", "bob")
    }
    assert calls["ada"] != calls["bob"]
    for several in calls.values():
        assert all(10 <= each["v"] <= 40 and 2 <= each["a"] <= 9 for each in several)
        assert [each["t"] for each in several[-2:]] == [0.0, 30.0]


@pytest.mark.parametrize(
    ("program", "kind", "words"),
    [
        (lambda v, a, t: v * t - a * t**2 / 2, Mistaken, "Your car rolls back"),
        (lambda v, a, t: v * t, Mistaken, "not that at the first speed"),
        (lambda v, a, t: 7.0, Wrong, "It returns the same for all arguments: 7."),
        (lambda v, a, t: -way(v, a, t), Wrong, "Every result has the opposite sign."),
        (lambda v, a, t: 100 * way(v, a, t), Wrong, "Every result is 100 times what it should be."),
        (lambda v, a, t: way(v, a, t) if t else 1.0, Wrong, "Right but for a special case: "),
        (lambda v, a, t: way(v, a, t) if t else math.nan, Unread, "the result is not a number"),
        (lambda v, a, t: math.inf, Unread, "the result is infinite"),
        (lambda v, a, t: way(v, a, t) * (1 + 0.01 * t), Wrong, "which is off by"),
        (lambda v, a, t: (way(v, a, t), v), Wrong, "It returns 2 numbers; return one number."),
        (lambda v, a, t: way(v, a, t) * (1 + 1e-5), Wrong, "times what it should be|off by"),
    ],
)
def test_what_is_off_in_a_function_is_said(program, kind, words):
    found = returned(program)
    assert isinstance(found, kind), found
    assert any(each in sentence(found) for each in words.split("|")), found


@pytest.mark.parametrize(
    ("source", "kind"),
    [
        ("def place(v, a, t):\n    t = min(t, v/a)\n    return v*t - a*t**2/2", Right),
        ("import numpy as np\ndef place(v, a, t):\n    t = min(t, v/a)\n    return np.array([v*t - a*t**2/2])", Right),
        ("def place(v, a, t):\n    return f'{v*t} m'", Unread),
        ("def place(v, a, t):\n    return None", Unread),
        ("def place(v, a):\n    return v", Unread),
        ("def place(v, a, t):\n    return [v, a, t]", Wrong),
        ("seen = []\ndef place(v, a, t):\n    seen.append(t)\n    return len(seen)*v*t", Wrong),
        ("place = 80", Unread),
    ],
)  # fmt: skip
def test_a_program_as_handed_in(source, kind):
    graded = judge(solution(), {"a": source})
    assert isinstance(graded.parts[0].verdict, kind), graded.parts[0]


# figures


def axes(x, y, xlabel: str, ylabel: str, kind: str = "line") -> Axes:
    line = DrawnLine(tuple(map(float, x)), tuple(map(float, y)), "", kind)
    return Axes("", xlabel, ylabel, (0, 1), (0, 1), "linear", "linear", (), (line,))


def of_figure(part: str, *drawn: Axes):
    plot = plot_of(solution(), PROBLEM.part(part))
    return plot_judge(plot)({"v": V, "a": A}, list(drawn))


T = np.linspace(0, 5, 200)
SPEED = np.where(T < 4, V - A * T, 0.0)


@pytest.mark.parametrize(
    ("x", "y", "labels"),
    [
        (T, SPEED, ("t [s]", "v [m/s]")),
        (T * 1000, SPEED, ("time in ms", "speed v (m/s)")),
        (T, SPEED * 3.6, ("t/s", "v [km/h]")),
        (T[::-1], SPEED[::-1], ("$t$ (s)", "$v$ (m/s)")),
        ([0, 4, 5], [20, 0, 0], ("t [s]", "v [m/s]")),  # straight lines need no points between
    ],
)
def test_the_curve_is_right_in_any_unit_that_its_labels_name(x, y, labels):
    assert of_figure("b", axes(x, y, *labels)) is None


@pytest.mark.parametrize(
    ("x", "y", "labels", "words"),
    [
        (T, SPEED + 3, ("t [s]", "v [m/s]"), "Your curve lies 3 m/s too high everywhere."),
        (T, SPEED - 3, ("t [s]", "v [m/s]"), "Your curve lies 3 m/s too low everywhere."),
        (T, SPEED * 3.6, ("t [s]", "v [m/s]"), "Your curve is 3.6 times as high as it should be everywhere."),
        (T * 1000, SPEED, ("t [s]", "v [m/s]"), "the numbers do not have the unit of the label"),
        (T, 0 * T + 20, ("t [s]", "v [m/s]"), "Your curve is constant: it is 20 m/s everywhere."),
        (SPEED, T, ("t [s]", "v [m/s]"), "changed places"),
        (T, SPEED, ("v [m/s]", "t [s]"), "Label"),
        (T, SPEED, ("t", "v"), "the axes are not labelled so. Label each axis with its quantity and unit"),
        (T, SPEED, ("t [s]", ""), "the axes are not labelled so"),
        (T, V - A * T, ("t [s]", "v [m/s]"), "Your car rolls back"),
        (T[T < 3], SPEED[T < 3], ("t [s]", "v [m/s]"), "Draw it from 0 s to 5 s."),
        (T, np.where((T > 1) & (T < 2), np.nan, SPEED), ("t [s]", "v [m/s]"), "are no numbers"),
        (T, SPEED**2 / 20, ("t [s]", "v [m/s]"), "your curve is at"),
        (np.minimum(T + 1, 6), SPEED, ("t [s]", "v [m/s]"), "shifted along the horizontal axis by 1 s"),
    ],
)
def test_what_is_off_in_a_curve_is_said(x, y, labels, words):
    found = of_figure("b", axes(x, y, *labels))
    assert isinstance(found, Fault), found
    assert words in found.sentence


@pytest.mark.parametrize(
    ("places", "words"),
    [
        ([0.0, 5.0], "too few for the whole curve"),  # at the ends alone
        ([0.0, 1.0, 2.5, 3.5, 5.0], "too few for the whole curve"),
    ],
)
def test_points_that_are_right_may_be_too_few(places, words):
    x = np.array(places)
    y = np.where(x < 4, V - A * x, 0.0)
    found = of_figure("b", axes(x, y, "t [s]", "v [m/s]", "points"))
    assert isinstance(found, Fault)
    assert words in found.sentence


def test_nothing_drawn_is_no_curve():
    assert isinstance(of_figure("b", axes([], [], "t [s]", "v [m/s]")), Fault)


S = np.array([4.0, 9.0, 16.0, 25.0, 36.0])
NOISE = np.array([1.01, 0.99, 1.02, 0.98, 1.0])


@pytest.mark.parametrize(
    ("slope", "start", "bend", "words"),
    [
        (10.0, 0.0, 0.0, None),
        (10.2, 0.0, 0.0, None),
        (5.0, 0.0, 0.0, "The slope of your line is off by 50 %."),
        (10.0, 60.0, 0.0, "Your line meets the vertical axis at 60 m²/s²"),
        (10.0, 0.0, 0.2, "no straight line"),
        (-10.0, 0.0, 0.0, "The slope of your line is off by 200 %."),
    ],
)
def test_a_line_through_points_is_judged_by_slope_and_intercept(slope, start, bend, words):
    points = DrawnLine(tuple(S), tuple(10 * S * NOISE), "", "points")
    line = DrawnLine(tuple(S), tuple(start + slope * S + bend * (S - 16) ** 2), "", "line")
    drawn = Axes("", "s [m]", "v² [m²/s²]", (0, 1), (0, 1), "linear", "linear", (), (points, line))
    found = of_figure("c", drawn)
    if words is None:
        assert found is None
    else:
        assert isinstance(found, Fault), found
        assert words in found.sentence, found.sentence


def test_points_alone_have_no_line():
    found = of_figure("c", axes(S, 10 * S * NOISE, "s [m]", "v² [m²/s²]", "points"))
    assert isinstance(found, Fault)
    assert found.sentence == "Draw the line through your points, too."
