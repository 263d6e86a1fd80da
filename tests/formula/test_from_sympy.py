"""The closed forms of the chapter's exercises, held against formulas worked out by hand, on the whole of the grid."""

from __future__ import annotations

from fractions import Fraction
from math import cos, pi, radians, sin, sqrt, tan

import pytest
import sympy

from corollary.derive.solve import solve
from corollary.formula.ball import certified
from corollary.formula.from_sympy import tree
from corollary.formula.plain_text import text
from corollary.formula.rational_pi import RationalPi
from corollary.problem.bank import chapter_bank, find
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter

BANK = chapter_bank()


def kick(m, v, w, dt):
    return {"a": [m * v], "b": [m * v], "c": [m * v / dt], "d": [m * (v + w) / dt]}


def wall(m, v0, theta, dt):
    turned = 2 * m * v0 * sin(theta)
    return {"a": [0, turned], "b": [0, -turned], "c": [0, turned / dt], "d": [pi / 2]}


def snowball(M, Ms, m, v, theta):
    flat = v * cos(theta)
    return {
        "a": [m * flat, m * v * sin(theta)], "b": [-m * flat / M], "b2": [0], "c": [-m * flat / M], "c2": [m * flat / (m + Ms)],
    }  # fmt: skip


def bullet(m, M, mu, d, g):
    u = sqrt(2 * mu * g * d)
    v = (m + M) / m * u
    return {"a": [v], "b": [(m + M) * u**2 / 2 - m * v**2 / 2]}


def cradle(m, h0, r, k, v0, g):
    u = sqrt(2 * g * h0)
    return {
        "a": [u], "b": [0, u], "c": [h0], "d": [h0 / 4], "e": [u * (1 - r) / 2, u * (1 + r) / 2],
        "f1": [0, v0, 0], "f2": [0, 0, v0], "h1": [pi * sqrt(m / (2 * k))], "h2": [v0 * sqrt(m / (2 * k))],
    }  # fmt: skip


@pytest.mark.parametrize(
    ("code", "by_hand"),
    [("X12.5", kick), ("X12.7", wall), ("X12.8", snowball), ("X12.10", bullet), ("P12.14", cradle)],
)
def test_against_formulas_worked_out_by_hand(code, by_hand):
    """To a few ulp: the certified value is exact, the formula by hand takes at most a dozen rounded operations."""
    solution = solve(BANK, find(BANK, code))
    tried = 0
    for variant in [chapter(solution.problem), *sample(solution.problem, 40, salt="hand")]:
        for part, wanted in by_hand(**variant.si).items():
            found = solution.answer(part)
            assert found is not None
            assert found.in_givens is not None
            values = [certified(tree, variant.exact) for tree in found.in_givens]
            assert all(value.proven for value in values)
            assert [value.value for value in values] == pytest.approx(wanted, rel=3e-15, abs=0)
            tried += 1
    assert tried >= 41 * 2


@pytest.mark.parametrize(
    ("made", "value"), [(sympy.cot, 1 / tan(0.75)), (sympy.csc, 1 / sin(0.75)), (sympy.sec, 1 / cos(0.75))]
)
def test_cofunctions_that_sympy_makes_are_formulas(made, value):
    """Such as cot(x) of tan(pi/2 - x)."""
    assert certified(tree(made(sympy.Symbol("x"))), {"x": RationalPi(Fraction(3, 4))}).value == pytest.approx(
        value, rel=3e-16
    )


def test_by_hand_is_by_hand():
    """The numbers of one variant with a pocket calculator: 8.6 kg m/s in 0.1 s; 2.1 kg, hit by 0.1 kg, slide 10 cm."""
    assert kick(0.43, 20, 20, 0.1)["c"] == pytest.approx([86.0])
    assert bullet(0.1, 2.0, 0.5, 0.1, 9.8)["a"] == pytest.approx([20.79], abs=0.005)
    assert wall(0.2, 8, radians(30), 0.01)["c"] == pytest.approx([0, 160.0])


def test_differences_are_written_as_they_are_by_hand():
    a, b, c = sympy.symbols("a b c")
    assert text(tree(a - b)) == "a - b"
    assert text(tree(a + b)) == "a + b"
    assert text(tree(b - a)) in ("b - a", "-a + b")
    assert text(tree(a - b / c)) == "a - b/c"


def test_a_number_to_a_negative_power_with_letters_stands_below():
    A, t, T = sympy.symbols("A t T", positive=True)
    assert text(tree(A * 2 ** (-t / T))) == "A/2^(t/T)"
    assert text(tree(2 ** (-t / T))) == "1/2^(t/T)"
    assert text(tree(A * sympy.exp(-t / T))) == "A*exp(-t/T)"
