"""Cubic equations: three real roots in cosines, and sentences for what has no formula."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st
from tests.derive.conftest import problem_of

from corollary.derive.assumptions import Point
from corollary.derive.roots import real_roots
from corollary.derive.solve import solve
from corollary.grading.key import make_key
from corollary.problem.sampling import sample
from corollary.verify.verify import verify

FRONT = """\
code: X1.1
title: A floating sphere
given:
  L: {is: radius, value: 1.5, from: 1.1, to: 2.5, step: 0.1, unit: m}
  n: {is: ratio, value: 0.7, from: 0.4, to: 0.9, step: 0.1}
require: [L > 0, n > 0]
"""
ASKS = '## Depth {#a .value unit="m" points=1}\nHow deep?\n'
WHOLE = """\
from sympy import *
from corollary.author import *
from corollary.laws import law, wrong
def derive(L, n):
    x, y = unknowns("x y")
    return derivation(
        step(x, "Archimedes.", law("Depth", "LAW"), answers="a", WHERE),
    )
"""
NOWHERE = [Point({}, {}, {})]  # there are no letters but the unknown
SPHERE = "x^3 - 3*L^2*x + n*L^3 = 0"


def written(law: str, where: str) -> str:
    return WHOLE.replace("LAW", law).replace("WHERE", where)


@pytest.mark.parametrize(
    ("where", "low", "high"), [("x > L", 1, 2), ("And(x > 0, x < L)", 0, 1), ("x < 0", -2, 0)]
)
def test_each_of_three_real_roots_can_be_meant(make, where, low, high):
    bank = make(whole=written(SPHERE, f"where={where}"), asks=ASKS, front=FRONT)
    problem = problem_of(bank)
    solution = solve(bank, problem)
    for variant in sample(problem, 12):
        L, n = (float(variant.values[name]) for name in "Ln")
        (expected,) = (
            x.real
            for x in np.roots([1, 0, -3 * L**2, n * L**3])
            if low * L < x.real < high * L and abs(x.imag) < 1e-9
        )
        assert make_key(solution, variant)["a"].value == pytest.approx(expected, rel=1e-12)
    if "0" not in where.partition("x < ")[2]:  # what is asked has no sign
        checked = verify(bank, problem, 10)
        assert checked.ok, checked.complaints
        outcomes = {each.kind: each.outcome for each in checked.obligations}
        assert outcomes["value exists"] == "proven"
        assert outcomes["one root"] != "proven"  # nobody proves yet that these are all


def test_several_are_named_in_formulas(refused):
    line, sentence = refused(whole=written(SPHERE, "where=x > 0"), asks=ASKS, front=FRONT)
    assert line == 7
    assert sentence.startswith("part a: 2 answers (x = 2*L*cos(acos(-n/2)/3); x = ")
    assert "say which, with where or reject" in sentence


def test_no_formula_is_not_no_root(refused):
    _line, sentence = refused(
        whole=written("x^5 - 3*L^4*x - n*L^5 = 0", "where=x > 0"), asks=ASKS, front=FRONT
    )
    assert sentence.startswith("part a: x is a root of degree 5, for which there is no formula")


@pytest.mark.whole
@given(st.lists(st.fractions(-9, 9, max_denominator=8), min_size=4, max_size=4))
def test_the_roots_in_cosines_are_those_of_the_polynomial(coefficients):
    """Held against the eigenvalues of the companion matrix, and against the sign of the discriminant."""
    assume(coefficients[0])
    x = sympy.Symbol("x", real=True)
    a, b, c, d = (sympy.Rational(each.numerator, each.denominator) for each in coefficients)
    discriminant = 18 * a * b * c * d - 4 * b**3 * d + b**2 * c**2 - 4 * a * c**3 - 27 * a**2 * d**2
    found = real_roots(a * x**3 + b * x**2 + c * x + d, x, NOWHERE)
    assert bool(found) is bool(discriminant > 0)
    if found:
        mine = sorted(float(root[x]) for root in found)
        theirs = sorted(np.roots([float(each) for each in coefficients]).real)
        size = max(map(abs, theirs))
        assert all(
            math.isclose(one, other, rel_tol=1e-5, abs_tol=1e-5 * size)
            for one, other in zip(mine, theirs, strict=True)
        )
