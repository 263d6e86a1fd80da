"""The worked solution: the law as the textbook has it, its letters here, the numbers, the unit, and why."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise

import pytest
from tests.chapter_problems import PROBLEMS
from tests.shares import share

from corollary.derive.solve import solve
from corollary.derive.worked_solution import asked_steps, worked_solution
from corollary.formula.ast import names
from corollary.grading.key import make_key
from corollary.grading.neglect import neglects
from corollary.grading.solutions import Solutions
from corollary.messages import language
from corollary.problem.bank import chapter_bank, find
from corollary.problem.variant import at, chapter

BANK = chapter_bank()


def told(code: str, index: int | None = None) -> str:
    problem = find(BANK, code)
    solution = solve(BANK, problem)
    variant = chapter(problem) if index is None else at(problem, index)
    key = make_key(solution, variant)
    return worked_solution(
        solution, variant, key.values, key.choices, [(each.most, each.share) for each in neglects(key)]
    )


def test_law_letters_number_and_unit():
    text = told("X12.5")
    first = text[: text.index("### (b)")]
    assert first.startswith("*Letters:* $m$ (mass of the ball), ")
    assert "\n\n### (a) Change of momentum" in first
    assert "Change of momentum (12.29)" in first
    assert r"$$\Delta p = m\, v_{1} - m\, v_{0}$$" in first  # the textbook
    assert r"$$\Delta p = m\, v - m \cdot 0$$" in first  # its letters here, nothing simplified
    assert r"m\, v = (0.43\,\mathrm{kg})\, (20.0\,\mathrm{m/s}) = 8.600\,\mathrm{kg\,m/s}$$" in first
    assert "The ball is at rest before the kick" in first
    assert "*Check:* It points the way the ball goes" in first


def test_a_find_nobody_asks_about_is_told_too():
    text = told("X12.5")
    assert r"**First find $\Delta p_{r}$.**" in text
    assert text.index("**First find") < text.index("### (d)")


def test_other_numbers_are_another_story():
    assert told("X12.5", 1) != told("X12.5", 2)
    assert told("X12.5", 1) == told("X12.5", 1)


def with_parts(code: str, *asked: str) -> str:
    """As a set tells it that asks these parts."""
    problem = find(BANK, code)
    parts = tuple(part for part in problem.parts if part.id in asked)
    return Solutions(BANK).worked_solution(chapter(replace(problem, parts=parts, written=problem)))


def test_what_a_set_leaves_out_is_not_told():
    text = with_parts("X12.8", "a", "b")
    assert re.findall(r"### \((.+?)\)", text) == ["a", "b"]
    for left_out in ("b2", "u_{1}", "V_{1}", "Newton's first law", "your son's mass"):
        assert left_out not in text
    assert text.rstrip().endswith("since you are far heavier.")
    assert "First find" not in with_parts("X12.5", "a")  # nobody asks for it, and only (d) needs it


def test_what_is_left_out_and_needed_is_a_step_and_no_answer():
    text = with_parts("X12.8", "c")
    assert re.findall(r"### \((.+?)\)", text) == ["c"]
    order = [text.index(words) for words in ("**First find $p_{x}$", "**First find $V$.**", "### (c)")]
    assert order == sorted(order)
    assert "u_{1}" not in text


@pytest.mark.parametrize(
    "code",
    share((problem.code for problem in PROBLEMS if len(problem.parts) > 1), first=12),
)
def test_each_part_alone_is_told_from_what_is_given(code):
    """No equation has a letter of something that is left out and not found first."""
    solution, problem = Solutions(BANK).of(find(BANK, code)), find(BANK, code)
    for part in problem.parts:
        shown = asked_steps(solution, {part.id})
        found = {name for find in shown.values() for name in (*find.names, *find.aside)}
        hidden = {name for find in solution.unknowns for name in find.names} - found
        for find_ in shown.values():
            assert find_.part in ("", part.id)
            assert not hidden & {name for law in find_.laws for here in law.here for name in names(here)}
        text = with_parts(code, part.id)
        assert re.findall(r"^### \((.+?)\)", text, re.MULTILINE) in ([], [part.heading_letter])


def test_refused_roots_other_ways_choices_and_programs():
    bullet, cradle = told("X12.10"), told("P12.14")
    assert "*Another way.* The same from the bullet's speed alone" in bullet
    assert "*Another root of these laws is rejected:*" in cradle
    assert "Measured in the simulated scene *cradle* (velocities)" in cradle
    assert "```python\ndef cradle(N, m, k, q, v0, dt):" in cradle
    assert "- Says that the law of the contact decides" in cradle


@pytest.mark.parametrize("code", ["X12.5", "X12.7", "X12.8", "X12.10", "P12.14"])
def test_every_part_is_told_and_every_formula_closes(code):
    text = told(code)
    for part in find(BANK, code).parts:
        assert f"### ({part.id}) {part.title}" in text
    assert text.count("$$") % 2 == 0
    assert "{{" not in re.sub(r"\$\$.*?\$\$", "", text, flags=re.DOTALL)
    for formula in re.findall(r"\$\$(.*?)\$\$", text, flags=re.DOTALL):
        assert formula.count("{") == formula.count("}")
        assert len(re.findall(r"\\left\b", formula)) == len(re.findall(r"\\right\b", formula))
        assert "nan" not in formula


CHAINS = re.compile(r"\$\$(.+?)\$\$", re.DOTALL)


def bare(side: str) -> str:
    return re.sub(r"\\left|\\right|[(){} ]", "", side)


@pytest.mark.parametrize("code", [problem.code for problem in PROBLEMS if problem.givens])
def test_no_line_says_that_something_is_itself(code):
    solution = Solutions(BANK).of(find(BANK, code))
    key = make_key(solution, chapter(solution.problem))
    text = worked_solution(
        solution, key.variant, key.values, key.choices, [(0.0, 0.0)] * len(solution.neglected)
    )
    for chain in CHAINS.findall(text):
        for relation in chain.split(r"\qquad"):
            sides = [bare(side) for side in relation.split(" = ")]
            assert all(one != other for one, other in pairwise(sides)), chain
            assert not any(one == "0" and other.startswith(r"0\,") for one, other in pairwise(sides))


def test_an_angle_is_told_in_degrees_too():
    assert r"= 1.571\,\mathrm{rad} = 90.00\mathrm{{}^{\circ}}$$" in told("X12.7")
    assert r"{}^{\circ}}$$" in told("E12.3.2")


WARMED = """\
code: X1.1
title: Warmed
given:
  V1: {is: volume, value: 20, from: 10, to: 50, step: 1, unit: ml}
  T1: {is: cold, value: 20, from: 10, to: 25, step: 1, unit: °C}
  T2: {is: hot, value: 70, from: 50, to: 95, step: 1, unit: °C}
  p: {is: pressure, value: 1013, from: 980, to: 1030, step: 1, unit: hPa}
require:
  - V1 > 0
  - T1 > 0 K
  - T2 > T1
  - p > 0
"""
ASKS = '## V {#a .value unit="ml"}\n?\n\n## W {#b .value unit="J"}\n?\n\n## T {#c .value unit="°C"}\n?\n'
BODY = """\
from corollary.author import *
from corollary.laws import *

def derive(V1, T1, T2, p):
    V, W, T = unknowns("V W T")
    return derivation(
        step(V, "It grows.", law("Charles", "V/T2 = V1/T1"), answers="a"),
        step(W, "Evenly.", law("Work", "W = p*(V - V1)"), answers="b"),
        step(T, "As the bath.", law("Bath", "T = T2"), answers="c"),
    )
"""


def test_what_was_answered_goes_on_in_the_unit_of_its_part(solved):
    solution = solved(whole=BODY, asks=ASKS, front=WARMED)
    key = make_key(solution, chapter(solution.problem))
    text = re.sub(r"\\left|\\right", "", worked_solution(solution, key.variant, key.values, key.choices, []))
    assert r"(1013\,\mathrm{hPa})\, ((23.41\,\mathrm{ml}) - (20\,\mathrm{ml})) = 0.3456" in text
    assert r"$$T = T_{2} = 70.00\,\mathrm{{}^{\circ}C}$$" in text


def test_what_was_found_when_it_was_solved_is_spoken_in_the_readers_language(translated):
    translated("corollary.derive", {"{root} contradicts {condition}": "{condition} malpermesas {root}"})
    english = told("P12.14")
    with language("eo"):
        other = told("P12.14")
    assert r"$v_{A} = u_{0}$, $v_{B} = 0$ contradicts $v_{B} \geq v_{A}$." in english
    assert r"$v_{B} \geq v_{A}$ malpermesas $v_{A} = u_{0}$, $v_{B} = 0$." in other
    assert "contradicts" not in other
