"""A problem with constants of nature: by name in laws, in students' formulas, with their source in the worked solution."""

from __future__ import annotations

import math

import pytest
import scipy.constants

from corollary.api import judge, key, solve
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, find
from corollary.problem.diagnostic import Malformed
from corollary.problem.reader import read_problem
from corollary.problem.variant import chapter, written
from corollary.verify.verify import verify

PROBLEM = """\
---
code: N1.1
title: A satellite
constants: [G, g_n]
given:
  M: {is: mass of the planet, value: 6e24, from: 2e24, to: 9e24, step: 1e23, unit: kg}
  r: {is: radius of the orbit, value: 7000, from: 6000, to: 9000, step: 10, unit: km}
  rho: {is: density of the air there, value: 9.80, unit: kg/m^3}
require: [M > 0, r > 0]
---
{{M}} {{r}} {{rho}}

## Speed {#a .value unit="km/s"}
How fast?

## As a formula {#b .expression unit="m/s"}
In symbols.
"""
SOLUTION = """\
from corollary.author import *
from corollary.laws import law, wrong


def derive():
    v, w = unknowns("v w")
    return derivation(
        step(v, "Gravity turns it.", law("Orbit", "v^2/r = G*M/r^2"), answers="a", where=v >= 0, mistakes=[
            mistake("That is the speed of escape.", wrong("v^2 = 2*G*M/r"), where=v >= 0),
            mistake("The weight at the ground.", wrong("v^2 = g_n*r"), where=v >= 0),
        ]),
        step(w, "The same.", law("Orbit", "w^2/r = G*M/r^2"), answers="b", where=w >= 0),
    )
"""


@pytest.fixture
def problem(tmp_path):
    for name, text in (("problems/satellite.md", PROBLEM), ("solutions/satellite.py", SOLUTION)):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text, encoding="utf-8")
    return find(Bank(tmp_path), "N1.1")


def test_it_is_solved_marked_and_verified(problem):
    solution = solve(problem)
    speed = math.sqrt(scipy.constants.G * 6e24 / 7e6)
    assert key(solution)["a"].value == pytest.approx(speed, rel=1e-9)
    grade = judge(solution, {"a": f"{speed / 1000:.4g}", "b": "sqrt(G*M/r)"})
    assert [part.points for part in grade.parts] == [1, 1]
    assert verify(Bank(problem.path.parents[1]), problem, count=5).complaints == ()


def test_the_worked_solution_says_where_the_value_is_from(problem):
    told = Solutions(Bank(problem.path.parents[1])).worked_solution(chapter(problem))
    assert "Newtonian constant of gravitation (CODATA 2022, ± 1.5e-15 m³/(kg s²))" in told
    assert "6.674" in told


def test_a_constant_keeps_its_printed_zeros(problem):
    assert written(chapter(problem), "rho").startswith("9.80")


@pytest.mark.parametrize(
    ("constants", "words"),
    [
        ("[G, q]", "constants: q is not known; choose one of c, h, hbar"),
        ("[G, r]", "r is not known"),
        ("R", None),
    ],
)
def test_only_what_is_known_is_a_constant(problem, constants, words):
    path = problem.path
    path.write_text(PROBLEM.replace("[G, g_n]", constants), encoding="utf-8")
    if words is None:
        assert read_problem(path).given("R").unit.text == "J/(mol*K)"
        return
    with pytest.raises(Malformed, match=words):
        read_problem(path)
