"""Products of vectors, derivatives and integrals in formulas."""

from __future__ import annotations

import pytest

from corollary.formula.latex import latex
from corollary.formula.operators import read_operators, scalar_part
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula

SIZES = {"r": 3, "F": 3, "u": 2}


@pytest.mark.parametrize(
    ("formula", "index", "written"),
    [
        ("norm(u)", 0, "sqrt(u[0]*u[0] + u[1]*u[1])"),
        ("dot(r, F)", 0, "r[0]*F[0] + r[1]*F[1] + r[2]*F[2]"),
        ("cross(r, F)", 0, "r[1]*F[2] - r[2]*F[1]"),
        ("cross(r, F)", 1, "r[2]*F[0] - r[0]*F[2]"),
        ("cross(r, F)", 2, "r[0]*F[1] - r[1]*F[0]"),
    ],
)
def test_a_component_is_written_out(formula, index, written):
    found = text(scalar_part(author_formula(formula, operators=True), index, SIZES))
    assert found.replace(" ", "") == written.replace(" ", "")


@pytest.mark.parametrize(
    ("formula", "tex"), [("dot(r, F)", r"\cdot"), ("cross(r, F)", r"\times"), ("norm(u)", "|")]
)
def test_each_has_its_sign(formula, tex):
    assert tex in latex(author_formula(formula, operators=True))


@pytest.mark.parametrize(
    ("formula", "tex"),
    [
        ("cross(r, F)", r"r \times F"),
        ("cross(r - u, F)", r"\left(r - u\right) \times F"),
        ("int(F, t, 0, T)", r"\int_{0}^{T} F \,\mathrm{d}t"),
        ("int(F + r, t, 0, T)", r"\int_{0}^{T} \left(F + r\right) \,\mathrm{d}t"),
    ],
)
def test_a_sum_stands_in_brackets_and_a_letter_does_not(formula, tex):
    letters = {"r", "u", "F", "t", "T"}
    assert latex(read_operators(author_formula(formula, operators=True), letters, frozenset())) == tex


LETTERS = {"m", "v", "x", "t", "dq"}


@pytest.mark.parametrize(
    ("formula", "read"),
    [
        ("m*dv/dt", "m*derivative(v, t, 1)"),
        ("d2x/dt2", "derivative(x, t, 2)"),
        ("d(m*v)/dt", "derivative(m*v, t, 1)"),
        ("dq/dt", "dq/dt"),  # a letter of its own
        ("dz/dt", "dz/dt"),  # of nothing known
        ("m/t", "m/t"),
    ],
)
def test_what_stands_above_and_below_a_line_is_derived_where_it_is_no_letter_of_its_own(formula, read):
    found = read_operators(author_formula(formula, operators=True), LETTERS, frozenset())
    assert text(found).replace(" ", "") == read.replace(" ", "")


@pytest.mark.parametrize("formula", ["d2x/dt", "dx/dt2"])
def test_as_often_above_as_below(formula):
    with pytest.raises(ValueError, match="as often above the line as below it"):
        read_operators(author_formula(formula, operators=True), LETTERS, frozenset())


def test_only_what_binds_less_than_the_sign_stands_in_brackets():
    assert latex(author_formula("dot(r, F)", operators=True)) == r"r \cdot F"
    assert latex(author_formula("cross(r, F + u)", operators=True)) == r"r \times \left(F + u\right)"
