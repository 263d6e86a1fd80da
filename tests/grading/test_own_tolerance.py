"""A part may say how far answers may be off, and why, and from where to where they may lie."""

from __future__ import annotations

import pytest

from corollary.answers.verdict import word
from corollary.derive.solve import solve
from corollary.formula.value import Text
from corollary.grading.assign import admitted
from corollary.grading.judge import judge
from corollary.grading.key import make_key
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.reader import read_problem
from corollary.problem.variant import at, chapter

PROBLEM = """\
---
code: T.1
title: A ride
given:
  d: {is: way, value: 12, from: 1, to: 40, step: 1, unit: km}
  t: {is: time, value: 40, from: 20, to: 60, step: 5, unit: min}
require:
  - d > 0
  - t > 0
---
Read the way off the diagram.

## Speed {#a .value unit="km/h" ATTRIBUTES}
?
"""
SOLUTION = """\
from corollary.author import *
from corollary.laws import *

def derive(d, t):
    (v,) = unknowns("v")
    return derivation(
        step(v, "Way by time.", law("Speed", "v = d/t"), answers="a",
             mistakes=[mistake("Four per cent more.", wrong("v = d/t*1.04"))]))
"""
READ_OFF = 'tolerance="5 %" because="it is read off a diagram"'


def solved(folder, attributes=""):
    for room in ("problems", "solutions"):
        (folder / room / "x").mkdir(parents=True, exist_ok=True)
    place = folder / "problems" / "x" / "ride.md"
    place.write_text(PROBLEM.replace("ATTRIBUTES", attributes), encoding="utf-8")
    (folder / "solutions" / "x" / "ride.py").write_text(SOLUTION, encoding="utf-8")
    problem = read_problem(place)
    return problem, solve(Bank(folder), problem)


@pytest.mark.parametrize(
    ("typed", "without", "with_one"), [("18.8", "mistaken", "right"), ("20.5", "wrong", "wrong")]
)
def test_what_is_read_off_a_diagram_may_be_off_more(tmp_path, typed, without, with_one):
    for attributes, expected in (("", without), (READ_OFF, with_one)):
        problem, solution = solved(tmp_path, attributes)
        ((verdict, *_), _) = judge(make_key(solution, chapter(problem)), {"a": Text(typed)})["a"]
        assert word(verdict) == expected


def test_a_mistake_within_the_tolerance_is_none_that_can_be_told(tmp_path):
    problem, solution = solved(tmp_path, READ_OFF)
    _key, reason = admitted(solution, chapter(problem))
    assert "cannot be told from the truth" in reason


def test_numbers_with_an_answer_that_is_not_plausible_are_not_dealt(tmp_path):
    problem, solution = solved(tmp_path, 'plausible="10 to 30"')
    assert admitted(solution, chapter(problem))[0] is not None
    for index in range(0, 300, 20):
        variant = at(problem, index)
        speed = variant.si["d"] / variant.si["t"] * 3.6
        key, reason = admitted(solution, variant)
        assert (key is None) == (not 10 <= speed <= 30)
        assert key is not None or reason == f"part a: {speed:.4g} km/h is not plausible"


@pytest.mark.parametrize(
    ("attributes", "said"),
    [
        ('tolerance="5 %"', "say a share from 1 % to 20 %, and why"),
        ('because="it is read off"', "say a share from 1 % to 20 %, and why"),
        ('tolerance="50 %" because="why not"', "say a share from 1 % to 20 %"),
        ('tolerance="0.5 m/s" because="why not"', "say a share from 1 % to 20 %"),
        ('plausible="30"', 'say from where to where, in the unit of the part: plausible="0.1 to 30"'),
        ('plausible="30 to 10"', "say from where to where"),
        ('hint="Divide {{d}} by it."', "the hint of part a has a hole"),
    ],
)
def test_what_cannot_be_meant_is_said(tmp_path, attributes, said):
    with pytest.raises(Malformed, match=said):
        solved(tmp_path, attributes)
