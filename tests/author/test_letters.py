"""Letters known by name: a law's letter that is a given or an unknown of the problem means just that."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.answers.evaluation import number
from corollary.derive.load import NotDerivable, load
from corollary.derive.solve import solve
from corollary.formula.ball import RationalPi
from corollary.laws import law
from corollary.laws.law import own_letters
from corollary.problem.bank import Bank, chapter_bank, find

PROBLEM = """\
---
code: O1.1
title: A spring
given:
  A: {is: amplitude, value: 2, from: 1, to: 5, step: 1, unit: cm}
  w: {is: angular frequency, value: 3, from: 1, to: 9, step: 1, unit: rad/s}
  t: {is: time, value: 2, from: 1, to: 4, step: 1, unit: s}
  m: {is: mass, value: 2, from: 1, to: 4, step: 1, unit: kg}
require: [A > 0, w > 0, m > 0]
---
{{A}} {{w}} {{t}} {{m}}

## Place {#a .value unit="cm"}
Where?

## Energy {#b .value unit="J"}
How much?
"""
SOLUTION = """\
from corollary.author import *
from corollary.laws import law, wrong


def derive(A):
    x, E, v = unknowns("x E v")
    return derivation(
        step(x, "It swings.", law("Oscillation", "x = A*cos(w*t)"), answers="a",
             mistakes=[mistake("A sine begins at rest.", wrong("x = A*sin(w*t)"))]),
        step(E, "All of it is kinetic once.", law("Speed", "v = A*w"), law("Energy", "E = m*v^2/2"), answers="b",
             also=[v],
             mistakes=[mistake("Half is missing.", wrong("E = m*v^2")), mistake("No square.", wrong("v = A/w^(-1)*2"))]),
    )
"""


@pytest.fixture
def bank(tmp_path):
    def with_solution(solution):
        for name, text in (("problems/spring.md", PROBLEM), ("solutions/spring.py", solution)):
            (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / name).write_text(text, encoding="utf-8")
        return Bank(tmp_path)

    return with_solution


def solved(bank):
    return solve(bank, find(bank, "O1.1"))


def test_a_letter_is_the_given_or_the_unknown_of_that_name(bank):
    place, energy = solved(bank(SOLUTION)).unknowns
    assert str(place.in_givens) == str(solved(bank(SOLUTION.replace(
        '"x = A*cos(w*t)"', '"y = B*cos(q*t)", y=x, B=A, q=__import__("sympy").Symbol("w", positive=True, real=True)'
    ))).unknowns[0].in_givens)  # fmt: skip
    assert len(energy.mistakes) == 2


def test_a_misconception_takes_the_place_of_the_law_of_the_same_quantity(bank):
    """The second one of the energy is about v = A w; the first about E."""
    _place, energy = solved(bank(SOLUTION)).unknowns
    (right,), (half,), (twice,) = (energy.local.trees, *(each.rule.trees for each in energy.mistakes))
    at = {name: RationalPi(Fraction(value)) for name, value in {"A": 3, "w": 2, "m": 5, "t": 1}.items()}
    assert number(right, at) == 5 * 36 / 2
    assert number(half, at) == 5 * 36
    assert number(twice, at) == 5 * (2 * 6) ** 2 / 2


def test_a_letter_that_is_neither_is_named_with_its_line(bank):
    here = bank(SOLUTION.replace("A*cos(w*t)", "A*cos(q*t)"))
    with pytest.raises(
        NotDerivable,
        match=r"spring\.py:8: .*Oscillation: what does q mean in .*neither a given nor an unknown",
    ):
        load(here, find(here, "O1.1"))


def test_outside_of_a_derivation_no_letter_is_known():
    with pytest.raises(ValueError, match="what does F, J, t mean"):
        law("Impulse", "J = F*t")


def test_the_equations_of_the_chapter_are_numbered_in_its_bank_alone(tmp_path):
    """A copy in another bank names the same laws, without numbers that lead nowhere; numbers of an author's own stay."""
    chapter = chapter_bank()
    model = chapter["X12.5"]
    for room, file in (("problems", model.path), ("solutions", chapter.solution(model))):
        (tmp_path / room / "x").mkdir(parents=True)
        (tmp_path / room / "x" / file.name).write_bytes(file.read_bytes())
    own = Bank(tmp_path)
    numbered = {law.name: law.source for find in solve(chapter, model).unknowns for law in find.laws}
    bare = {law.name: law.source for find in solve(own, own["X12.5"]).unknowns for law in find.laws}
    assert numbered["Mean force"] == "(12.22)"
    assert bare.keys() == numbered.keys()
    assert set(bare.values()) == {""}
    with own_letters({}, numbered=False):
        assert law("Mine", "a = b", source="(3.1)", a=1, b=1).source == "(3.1)"
