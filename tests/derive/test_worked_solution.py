"""The worked solution: the law as the textbook has it, its letters here, the numbers, the unit, and why."""

from __future__ import annotations

import re

import pytest

from corollary.derive.solve import solve
from corollary.derive.worked_solution import worked_solution
from corollary.grading.key import make_key
from corollary.grading.neglect import neglects
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
    assert first.startswith("### (a) Change of momentum")
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


def test_refused_roots_other_ways_choices_and_programs():
    bullet, cradle = told("X12.10"), told("P12.14")
    assert "*Another way.* The same from the bullet's speed alone" in bullet
    assert "*Another root of these laws is refused:*" in cradle
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
