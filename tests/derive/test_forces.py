"""Forces on a body are held against the laws in which they stand: one too many, one too few, or a turned one is refused."""

from __future__ import annotations

import re

import pytest

from corollary.derive.load import NotDerivable
from corollary.derive.solve import solve
from corollary.derive.worked_solution import listed_forces
from corollary.grading.forces_on_body import as_people_say, free_body
from corollary.problem.bank import Bank
from corollary.problem.reader import read_problem
from corollary.problem.variant import chapter

PROBLEM = """\
---
code: F.1
title: A sledge
given:
  m: {is: mass, value: 40, from: 20, to: 60, step: 5, unit: kg}
  P: {is: pull, value: 120, from: 60, to: 160, step: 10, unit: N}
  beta: {is: angle of the rope, value: 30, from: 10, to: 40, step: 5, unit: deg}
  q: {is: push from behind, value: 0, from: 0, to: 40, step: 10, unit: N}
  g: {is: gravity, value: 9.81, unit: m/s^2}
require:
  - m > 0
  - P > 0
  - g > 0
  - q >= 0
---
A sledge.

## Normal force {#b .value unit="N"}
?

## Forces {#a .forces}
Which?

- (A) weight
- (B) normal force
- (C) pull of the rope
- (D) push
- (E) driving force
"""
SOLUTION = """\
from corollary.author import along, derivation, force, forces, mistake, step, unknowns
from corollary.laws import law, wrong


def derive(m, P, beta, q, g):
    N, f = unknowns("N f")
    return derivation(
        step(N, "Up and down.", law("Balance", "N + P*sin(beta) = m*g"), answers="b",
             mistakes=[mistake("The rope lifts.", wrong("N = m*g"))]),
        forces("a", "They are four.", FORCES,
               laws=[LAWS], mistakes={"e": "None."}),
    )
"""
GOOD = 'force("a", m*g, "down"), force("b", N, "up"), force("c", P, beta), force("d", q, "right")'
LAWS = (
    'along("up", law("Balance", "N + P*sin(beta) = m*g")), '
    'along("right", law("Newton\'s second law", "m*a = P*cos(beta) + q", a=f))'
)


def solved(folder, forces=GOOD, laws=LAWS, solution=SOLUTION):
    for room in ("problems", "solutions"):
        (folder / room / "x").mkdir(parents=True, exist_ok=True)
    place = folder / "problems" / "x" / "sledge.md"
    place.write_text(PROBLEM, encoding="utf-8")
    text = solution.replace("FORCES", forces).replace("LAWS", laws)
    (folder / "solutions" / "x" / "sledge.py").write_text(text, encoding="utf-8")
    problem = read_problem(place)
    return problem, solve(Bank(folder), problem)


def test_the_forces_of_the_laws_are_taken(tmp_path):
    problem, solution = solved(tmp_path)
    body = free_body(solution.forces["a"], chapter(problem))
    part = problem.part("a")
    assert (
        as_people_say(body, part) == "weight: down; normal force: up; pull of the rope: 30°"
    )  # nobody pushes


def test_the_worked_solution_says_where_each_points(tmp_path):
    problem, solution = solved(tmp_path)
    told = list(listed_forces(solution.forces["a"], problem.part("a")))
    assert told[0] == "- weight, down: $g\\, m$"
    assert told[2] == r"- pull of the rope, at $\beta$, counter-clockwise from the right: $P$"


@pytest.mark.parametrize(
    ("forces", "laws", "words"),
    [
        (GOOD.replace(', force("d", q, "right")', ""), LAWS, "along 'right'"),
        (GOOD.replace('"up"', '"down"'), LAWS, "along 'up'"),
        (GOOD + ', force("e", q, "left")', LAWS, "(?s)e acts; a mistake"),
        (GOOD.replace('force("c", P, beta)', 'force("c", P, "right")'), LAWS, "along 'up'"),
        (GOOD, LAWS.partition(", along")[0], r"in which \(d\) acts"),
        (GOOD.replace('"up"', '"upp"'), LAWS, "'upp' is not a direction"),
        (GOOD.replace('"up"', '"up the slope"'), LAWS, "add slope="),
        (GOOD.replace('force("d"', 'force("x"'), LAWS, "x is none of its options"),
    ],
)
def test_others_are_refused_at_their_line(tmp_path, forces, laws, words):
    with pytest.raises(NotDerivable, match=words) as found:
        solved(tmp_path, forces, laws)
    assert found.value.line == 10


@pytest.mark.parametrize(
    ("law", "same"),
    [
        ("N + P*tan(beta)/sqrt(1 + tan(beta)^2) = m*g", True),  # beta below 90°
        ("N + P*sin(beta) = (m*g)^2/(m*g)", True),
        ("N + P*2*tan(beta/2)/(1 + tan(beta/2)^2) - m*g = 0", True),
        ("N + P*sin(beta)*(1 + 1e-12) = m*g", False),
        ("2*N + 2*P*sin(beta) = 2*m*g", False),  # true of what is found, and no sum of these forces
    ],
)
def test_another_form_of_the_law_is_taken_and_another_law_refuted_by_numbers(tmp_path, law, same):
    laws = LAWS.replace('"Balance", "N + P*sin(beta) = m*g"', f'"Balance", "{law}"')
    if same:
        solved(tmp_path, laws=laws)
        return
    with pytest.raises(
        NotDerivable, match=r"points elsewhere; at m = 40.kg, .*N = 1/7 what its sides differ by is"
    ) as found:
        solved(tmp_path, laws=laws)
    shown = re.search(r"differ by is (\S+) and the sum of the forces (\S+) \(SI\)", str(found.value))
    assert shown is not None
    assert float(shown[1]) != float(shown[2])


def test_a_letter_that_laws_needed_besides_is_a_magnitude(tmp_path):
    """`also=[N]`: what nobody asks for has a formula as well."""
    solution = (
        SOLUTION.replace('N, f = unknowns("N f")', 'N, f, s = unknowns("N f s")')
        .replace(
            'law("Balance", "N + P*sin(beta) = m*g"), answers="b"',
            'law("Balance", "N + P*sin(beta) = m*g"), law("Same", "s = N"), also=[N], answers="b"',
            1,
        )
        .replace("step(N,", "step(s,", 1)
        .replace('wrong("N = m*g")', 'wrong("N = m*g"), instead="Balance"')
    )
    problem, solved_one = solved(tmp_path, solution=solution)
    known, (_, without_it) = free_body(solved_one.forces["a"], chapter(problem)), solved(tmp_path)
    assert known.forces == free_body(without_it.forces["a"], chapter(problem)).forces


def test_a_magnitude_that_is_not_found_before_is_named(tmp_path):
    with pytest.raises(NotDerivable, match="f is neither given nor derived before"):
        solved(tmp_path, 'force("a", f, "up")', 'along("up", law("Balance", "F = m*g", F=f))')
