"""A formula with two readings is the one that measures what is asked for."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.formula import fitting, formula
from corollary.answers.questions import question_of
from corollary.formula.ast import Expr
from corollary.formula.errors import ParseError
from corollary.formula.text import text
from corollary.problem.reader import read_problem
from corollary.units.unit import unit

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
QUESTION = question_of(PROBLEM, PROBLEM.part("a"))


@pytest.mark.parametrize(
    ("typed", "its_unit", "meant"),
    [
        ("1/m v", "m/(s*kg)", "1/m*v"),
        ("1/m v", "s/(kg*m)", "1/(m*v)"),
        ("v cos 2/m", "m/(s*kg)", "v*cos(2)/m"),
    ],
)
def test_the_dimension_decides(typed, its_unit, meant):
    assert isinstance(formula(typed, QUESTION), ParseError)
    found = fitting(typed, replace(QUESTION, unit=unit(its_unit)))
    assert isinstance(found, Expr)
    assert text(found) in (meant, f"({meant.partition('*')[0]})*{meant.partition('*')[2]}")


def test_none_that_fits_is_none():
    assert fitting("1/m v", replace(QUESTION, unit=unit("J"))) is None


def test_words_around_a_formula_are_left_out():
    for typed in ("p = m v", "Answer: m v", "p_1 - p_0 = m*v", r"$\Delta p = m\,v$", "≈ m v."):
        found = formula(typed, QUESTION)
        assert isinstance(found, Expr)
        assert text(found) == "m*v"
