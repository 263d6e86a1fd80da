"""A wrong sign in a law of drag fits the units and its own solution; an energy balance contradicts it, and what nothing checks is named."""

from __future__ import annotations

import re

import pytest

from corollary.derive.solve import solve
from corollary.grading.key import make_key
from corollary.problem.bank import Bank
from corollary.problem.reader import read_problem
from corollary.problem.variant import chapter
from corollary.verify.checked import Tally
from corollary.verify.unchecked import note_unchecked
from corollary.verify.verify import verify

PROBLEM = """\
---
code: X1.1
title: Honey
given:
  m: {is: mass, value: 2, from: 1, to: 4, step: 0.5, unit: kg}
  b: {is: drag, value: 0.5, from: 0.2, to: 1, step: 0.1, unit: kg/s}
  g: {is: gravity, value: 9.81, unit: m/s^2}
  t1: {is: time, value: 3, from: 1, to: 5, step: 0.5, unit: s}
require:
  - m > 0
  - b > 0
  - g > 0
  - t1 > 0
---
A ball of {{m}} falls through honey ({{b}}) for {{t1}}, with g = {{g}}.

## Speed {#a .value unit="m/s"}
?

## Way {#b .value unit="m"}
?
"""
SOLUTION = """\
from corollary.author import *
from corollary.laws import law

def derive(m, b, g, t1):
    t = variable("t")
    v = function("v", t)
    v1, s = unknowns("v1 s")
    return derivation(
        step(v1, "Newton.", law("Newton's second law", "NEWTON"), law("Start", "v(0) = 0"),
             law("Asked", "v1 = v(t1)"), answers="a"),
        step(s, "The way.", law("Way", "s = int(v, t, 0, t1)"), answers="b"),
        CONFIRM
    )
"""
SCENE_BEHIND = "# the scene"
BALANCE = 'confirm("Work of weight and drag.", law("Energy", "m*g*s = m*v1^2/2 + int(b*v^2, t, 0, t1)")),'


@pytest.fixture
def checked(tmp_path):
    def verified(newton: str, confirm: str, scene: str = ""):
        for folder in ("problems", "solutions"):
            (tmp_path / folder / "x").mkdir(parents=True, exist_ok=True)
        problem = tmp_path / "problems" / "x" / "honey.md"
        problem.write_text(PROBLEM, encoding="utf-8")
        text = SOLUTION.replace("NEWTON", newton).replace("CONFIRM", confirm)
        text += scene or (SCENE if confirm == SCENE_BEHIND else "")
        (tmp_path / "solutions" / "x" / "honey.py").write_text(text, encoding="utf-8")
        return verify(Bank(tmp_path), read_problem(problem), 2)

    return verified


def unchecked(found) -> list[str]:
    return [note for note in found.notes if "nothing but dimensions" in note]


@pytest.mark.whole
def test_a_wrong_sign_of_drag_contradicts_the_energy_balance(checked):
    assert checked("m*dv/dt = m*g - b*v", BALANCE).complaints == ()
    (complaint,) = checked("m*dv/dt = m*g + b*v", BALANCE).complaints
    assert complaint.startswith("honey.py:12: Energy does not hold for the answers")


def test_what_nothing_checks_is_named(checked):
    wrong = checked("m*dv/dt = m*g + b*v", "")
    assert wrong.complaints == ()
    (note,) = unchecked(wrong)
    assert note.startswith(
        "honey.py:9: nothing but dimensions checks the signs of Newton's second law (line 9)"
    )
    assert "Way (line 11)" in note


@pytest.mark.whole
def test_what_the_balance_checks_is_not_named(checked):
    (note,) = unchecked(checked("m*dv/dt = m*g - b*v", BALANCE))
    assert "checks the signs of Asked (line 9); confirm" in note  # the balance has the square of v1

    signed = BALANCE.replace("m*v1^2/2", "m*v1*v(t1)/2")
    assert unchecked(checked("m*dv/dt = m*g - b*v", signed)) == []


def test_a_balance_that_says_nothing_of_drag_leaves_it_unchecked(checked):
    idle = 'confirm("By definition.", law("Momentum", "m*v1 = m*v(t1)")),'
    (note,) = unchecked(checked("m*dv/dt = m*g - b*v", idle))
    assert "Newton's second law" in note


PUSHED = """\
from corollary.author import *
from corollary.laws import law

def derive(m, b, g, t1):
    a, v = unknowns("a v")
    return derivation(
        step(a, "Newton.", law("Newton's second law", "m*a = m*g - b*g*t1"), answers="a"),
        step(v, "Evenly.", law("Velocity", "v = a*t1 + g*t1"), answers="b"),
        CLAIMS
    )
"""


@pytest.mark.parametrize(
    ("claims", "left"),
    [
        ("", ["Newton's second law", "Velocity"]),
        ("limit(a, b, oo, -oo),", ["Newton's second law", "Velocity"]),  # it says nothing of m*g
        ("limit(a, b, oo, -oo), limit(a, b, 0, g),", ["Velocity"]),
        ("at(b=0, v=2*g*t1),", ["Newton's second law"]),  # nor does this of the second term
        ("at(b=0, v=2*g*t1), at(b=m/t1, a=0, v=g*t1),", []),
    ],
)
def test_limits_and_special_cases_check_the_signs_that_they_would_contradict(tmp_path, claims, left):
    for folder in ("problems", "solutions"):
        (tmp_path / folder / "x").mkdir(parents=True)
    path = tmp_path / "problems" / "x" / "honey.md"
    path.write_text(PROBLEM.replace('unit="m/s"', 'unit="m/s^2"').replace('unit="m"}', 'unit="m/s"}'))
    (tmp_path / "solutions" / "x" / "honey.py").write_text(PUSHED.replace("CLAIMS", claims))
    bank = Bank(tmp_path)
    tally = Tally()
    note_unchecked(bank, make_key(solve(bank, bank["X1.1"]), chapter(bank["X1.1"])), tally)
    named = re.findall(r"(Newton's second law|Velocity) \(line", " ".join(tally.notes))
    assert named == left


def test_a_letter_that_nobody_found_is_said(checked):
    (complaint,) = checked(
        "m*dv/dt = m*g - b*v", 'confirm("?", law("Energy", "m*g*s = E", E=unknown("E"))),'
    ).complaints
    assert "Energy: E is neither given nor found before" in complaint


SCENE = """
def scene(m, b, g, t1, answer):
    from math import acos
    acos(answer["a"] / 20.8)
    return [simulate("kick", {"m": m, "v": 1, "dt": 0.1}, impulse=m)]
"""


def test_a_scene_that_cannot_be_made_with_another_answer_needs_that_one(checked):
    """20.8 m/s is hardly more than the answer: a quarter more has no arc cosine, which is no fault of the author's."""
    (note,) = unchecked(checked("m*dv/dt = m*g - b*v", SCENE_BEHIND))
    assert "Newton's second law" not in note
    assert "Way (line 11)" in note


BEHIND = """
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.scene import Body, Scene

def scene(m, b, g, t1, answer):
    from math import exp
    way = SHARE * m * g / b * (t1 - m / b * (1 - exp(-b * t1 / m)))
    force = ForceFunction(0, lambda t, place, velocity: (SHARE * m * answer["b"],))
    return [simulate(Scene((Body(m, (0.0,), (0.0,)),), (force,), until=2.0), velocities=(2 * way,))]
"""


@pytest.mark.parametrize(("share", "named"), [("1.0", False), ("0.0", True)])
def test_an_answer_that_enters_a_force_is_checked_where_another_contradicts_the_scene(checked, share, named):
    """The way (b) drives the body (or nothing does), and what is expected never mentions it."""
    found = checked("m*dv/dt = m*g - b*v", "", BEHIND.replace("SHARE", share))
    assert found.complaints == ()
    assert any("Way (line 11)" in note for note in unchecked(found)) == named
