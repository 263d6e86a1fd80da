"""Mistakes that coincide with the truth: at the printed numbers, on a part of the grid, for all numbers, or nowhere."""

from __future__ import annotations

import pytest
from tests.derive.conftest import make, problem_of
from tests.derive.test_cases import ASKS, FRONT

from corollary.derive.solve import solve
from corollary.grading.mistakes import visible_mistakes

__all__ = ["make"]

PROBLEM = """\
---
code: X1.1
title: Two carts
given:
  m: {is: mass, value: 2, from: 1, to: 9, step: 0.5, unit: kg}
  M: {is: the other mass, value: 2, from: 1, to: 9, step: 0.5, unit: kg}
  v: {is: speed, value: 1, from: 1, to: 9, step: 0.5, unit: m/s}
  theta: {is: angle, value: 45, from: 10, to: 80, step: 1, unit: deg}
---
Carts of {{m}} and {{M}} at {{v}}, {{theta}}.

## Asked {#a .value unit="%s"}
What is it?
"""
SOLUTION = """\
return derivation(
    step(p, "On the way.", law("First", "p = %s"), mistakes=[mistake("It is not so.", wrong("p = %s"))]),
    step(F, "Asked.", law("Second", "F = %s"), answers="a"),
)
"""
DOUBLED = """    step(q, "Twice.", law("Twice", "q = 2*p")),\n"""


@pytest.fixture
def verified_at(verified, monkeypatch):
    """`verified_at(truth, wrong, asked, unit)`: the mistake is at a step nobody asks about."""
    monkeypatch.setattr(
        "tests.verify.conftest.OPENING",
        '"""A cart."""\n\nfrom corollary.author import *\nfrom corollary.laws import *\n\n'
        'def derive(m, M, v, theta):\n    p, q, F = unknowns("p q F")\n',
    )
    return lambda truth, wrong, asked, unit: verified(
        SOLUTION % (truth, wrong, asked), problem=PROBLEM % unit, count=20
    )


SEVERAL = """\
return derivation(
    step(p, "Two laws.", law("First", "p = q*v"), law("Second", "q = m"), also=[q],
         mistakes=[mistake("It is not so.", law("First", "p = q*v%s"), law("Second", "q = %s"), instead=["First", "Second"])]),
    step(F, "Asked.", law("Third", "F = p/v"), answers="a"),
)
"""
VECTOR = """\
return derivation(
    step(p, "On the way.", law("First", "p = m*v"), mistakes=[mistake("It is not so.", wrong("p = M*v"))]),
    step((F, q), "Both.", law("Second", "F = 3*m*v"), law("Third", "q = p"), answers="a"),
)
"""
CASES_WHOLE = """\
import sympy
from corollary.author import *
from corollary.laws import *

def derive(m, g, alpha, mus, muk):
    F, a, N, k = unknowns("F a N k")
    slope = m*g*sympy.sin(alpha)
    return derivation(
        step(N, "Nothing moves off the slope.", law("Normal force", "N = m*g*cos(alpha)")),
        cases(
            case("it rests", slope <= mus*N,
                step(k, "At most.", law("Left", "k = mus*N"), mistakes=[mistake("None.", wrong("k = max(mus*N, m*g*sin(alpha))"))]),
                step(F, "It balances.", law("At rest", "F = min(k, m*g*sin(alpha))"), answers="a")),
            case("it slides", slope > mus*N,
                step(k, "Friction.", law("Left", "k = muk*N"), mistakes=[mistake("Twice.", wrong("k = muk*min(2*N, m*g*sin(alpha)/mus)"))]),
                step(F, "Kinetic friction.", law("Kinetic friction", "F = k"), answers="a")),
        ),
        step(a, "Newton.", law("Newton's second law", "m*a = m*g*sin(alpha) - F"), answers="b", scale=g),
    )
"""

SHOWN = {  # the printed numbers have m = M, v = 1 m/s, theta = 45°
    "the other mass": ("m*v", "M*v", "p/m", "m/s"),
    "a share squared": ("m*v*(m/M)^2", "m*v*(m/M)", "p/m", "m/s"),
    "sine for cosine": ("m*v*sin(theta)", "m*v*cos(theta)", "p/m", "m/s"),
    "no value where the masses are equal": ("m*v", "m*v*sqrt(M/m - 1.01)", "p/m", "m/s"),
}


@pytest.mark.parametrize("name", SHOWN)
def test_a_coincidence_at_the_printed_numbers_drops_nothing(verified_at, name):
    """The mistake stays, and numbers for which it looks right are drawn again."""
    checked = verified_at(*SHOWN[name])
    assert not [each for each in (*checked.complaints, *checked.notes) if "It is not so." in each]
    assert [
        each for each in checked.obligations if each.kind == "mistake apart" and "It is not so." in each.claim
    ]


def test_where_it_coincides_with_the_truth_numbers_are_drawn_again(verified_at):
    """On half of the grid the two masses are in the other order."""
    checked = verified_at("m*v", "m*v*max(1, M/m)", "p/m", "m/s")
    assert checked.ok, checked.complaints
    assert 0.3 < checked.redrawn < 0.8
    assert "the mistake 'It is not so.' cannot be told from the truth" in checked.why[0][0]


def test_one_that_shows_in_few_corners_alone_is_no_mistake_to_be_told(verified_at):
    (said,) = verified_at("m*v", "m*v*max(1, M/(m*8.9))", "p/m", "m/s").complaints
    assert said.startswith(
        "cart.md:5: 100 % of the draws may not be assigned (part a: the mistake 'It is not so.'"
    )


@pytest.mark.parametrize(("second", "seen"), [("M", True), ("2*m", False)])
def test_a_mistake_of_several_laws(verified_at, monkeypatch, second, seen):
    """The printed masses are equal: q = M with p = q v coincides there; q = 2 m with p = q v/2 does everywhere."""
    half = "" if seen else "/2"
    body = SEVERAL % (half, second)
    monkeypatch.setattr("tests.verify.test_hidden_mistakes.SOLUTION", body.replace("%", "%%") + "# %s %s %s")
    checked = verified_at("", "", "", "kg")
    assert checked.ok == seen, checked.complaints
    assert seen or "gives the same p as the step itself for all numbers, by algebra" in checked.complaints[0]


def test_one_component_of_a_vector_is_enough(verified_at, monkeypatch, problem):
    monkeypatch.setattr("tests.verify.test_hidden_mistakes.SOLUTION", VECTOR + "# %s %s %s")
    monkeypatch.setattr(
        "tests.verify.test_hidden_mistakes.PROBLEM", PROBLEM.replace(".value", '.vector components="x y"')
    )
    checked = verified_at("", "", "", "kg*m/s")
    assert checked.ok, checked.complaints
    assert any("It is not so." in each.claim for each in checked.obligations if each.kind == "mistake apart")


def test_within_a_case_only_its_own_numbers_count(make):
    """The printed block rests; of one that slides the mistake differs, and of one at rest never."""
    bank = make(whole=CASES_WHOLE, asks=ASKS, front=FRONT)
    solution = solve(bank, problem_of(bank))
    rests, slides = (each.solution for each in solution.regimes)
    assert not visible_mistakes(rests)
    assert [each.mistake.text for each in visible_mistakes(slides)] == ["Twice."]


def test_a_mistake_that_is_the_truth_is_complained_of(verified_at):
    (said,) = verified_at("m*v", "v*m", "p/m", "m/s").complaints
    assert said == (
        "cart.py:9: the mistake 'It is not so.' gives the same p as the step itself for all numbers, by algebra: "
        "correct its law, or leave it out"
    )


def test_the_truth_by_another_formula_is_the_truth(verified_at):
    (said,) = verified_at("m*v*sin(2*theta)", "2*m*v*sin(theta)*cos(theta)", "p/m", "m/s").complaints
    assert said.startswith(
        "cart.py:9: the mistake 'It is not so.' gives the same p as the step itself for all"
    )


def test_a_mistake_without_a_value_is_complained_of(verified_at):
    (said,) = verified_at("m*v", "m*v*sqrt(-M/m)", "p/m", "m/s").complaints
    assert "'It is not so.' has no value for all 57 numbers tried" in said


def test_a_mistake_that_cancels_is_noted(verified_at, monkeypatch):
    """It is a mistake, and whoever makes it is right all the same."""
    monkeypatch.setattr(
        "tests.verify.test_hidden_mistakes.SOLUTION", SOLUTION.replace("    step(F", DOUBLED + "    step(F")
    )
    checked = verified_at("m*v", "2*m*v", "q*v/p", "m/s")
    assert checked.ok, checked.complaints
    (said,) = [each for each in checked.notes if "It is not so." in each]
    assert said.startswith(
        "cart.py:9: the mistake 'It is not so.' changes p, and leaves part a as it is for all numbers"
    )


def test_a_mistake_on_the_way_to_nothing_is_noted(verified_at):
    checked = verified_at("m*v", "2*m*v", "m*v", "kg*m/s")
    (said,) = [each for each in checked.notes if "It is not so." in each]
    assert "is never met: no part is made of p" in said
