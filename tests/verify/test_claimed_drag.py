"""A wrong sign in a law of drag fits the units and its own solution; an energy balance contradicts it."""

from __future__ import annotations

import pytest

from corollary.problem.bank import Bank
from corollary.problem.reader import read_problem
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
BALANCE = 'confirm("Work of weight and drag.", law("Energy", "m*g*s = m*v1^2/2 + int(b*v^2, t, 0, t1)")),'


@pytest.fixture
def checked(tmp_path):
    def verified(newton: str, confirm: str):
        for folder in ("problems", "solutions"):
            (tmp_path / folder / "x").mkdir(parents=True, exist_ok=True)
        problem = tmp_path / "problems" / "x" / "honey.md"
        problem.write_text(PROBLEM, encoding="utf-8")
        text = SOLUTION.replace("NEWTON", newton).replace("CONFIRM", confirm)
        (tmp_path / "solutions" / "x" / "honey.py").write_text(text, encoding="utf-8")
        return verify(Bank(tmp_path), read_problem(problem), 2)

    return verified


@pytest.mark.whole
def test_a_wrong_sign_of_drag_contradicts_the_energy_balance(checked):
    assert checked("m*dv/dt = m*g - b*v", BALANCE).complaints == ()
    (complaint,) = checked("m*dv/dt = m*g + b*v", BALANCE).complaints
    assert complaint.startswith("honey.py:12: Energy does not hold for the answers")


def test_a_letter_that_nobody_found_is_said(checked):
    (complaint,) = checked(
        "m*dv/dt = m*g - b*v", 'confirm("?", law("Energy", "m*g*s = E", E=unknown("E"))),'
    ).complaints
    assert "Energy: E is neither given nor found before" in complaint
