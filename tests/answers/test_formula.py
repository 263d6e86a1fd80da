"""A formula with two readings is the one that stops early, where that alone measures what is asked for; else it is asked about."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest

from corollary.answers.answer import Formulas, Unclear
from corollary.answers.formula import fitting, formula
from corollary.answers.questions import question_of
from corollary.answers.registry import answer_type
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import Expr
from corollary.formula.errors import ParseError
from corollary.formula.plain_text import text
from corollary.formula.syntax import parse
from corollary.formula.value import Text
from corollary.problem.reader import read_problem
from corollary.units.unit import unit

PROBLEM = read_problem(Path(__file__).with_name("two_letters.md"))
QUESTION = question_of(PROBLEM, PROBLEM.part("a"))


@pytest.mark.parametrize(
    ("typed", "its_unit", "meant"),
    [
        ("1/m v", "m/(s*kg)", "1/m*v"),
        ("v cos 2/m", "m/(s*kg)", "v*cos(2)/m"),
    ],
)
def test_the_dimension_decides(typed, its_unit, meant):
    assert isinstance(formula(typed, QUESTION), ParseError)
    found = fitting(typed, replace(QUESTION, unit=unit(its_unit)))
    assert isinstance(found, Expr)
    assert text(found) in (meant, f"({meant.partition('*')[0]})*{meant.partition('*')[2]}")


@pytest.mark.parametrize(
    ("typed", "its_unit", "meant"),
    [
        ("1/m v", "s/(kg*m)", "1/(m*v)"), ("v/2m", "m/(s*kg)", "v/(2*m)"), ("v/2m", "kg*m/s", "(v/2)*m"), ("√2v^2", "m/s", "sqrt(2*v^2)"),
        ("sqrt2v^2", "m/s", "sqrt(2*v^2)"), ("v ln m/m", "m/s", "v*ln(m/m)"), ("v*e^-m/m", "m/s", "v*exp((-m)/m)"), ("m v/2m", "m/s", "m*v/(2*m)"),
    ],
)  # fmt: skip
def test_what_only_a_bracket_would_settle_is_asked_about_with_the_readings_that_fit(typed, its_unit, meant):
    found = fitting(typed, replace(QUESTION, unit=unit(its_unit)))
    assert isinstance(found, Unclear)
    assert [text(each.trees[0]) for each in found.readings if isinstance(each, Formulas)] == [meant]
    assert not found.benefit


def test_none_that_fits_is_none():
    assert fitting("1/m v", replace(QUESTION, unit=unit("J"))) is None


def test_words_around_a_formula_are_left_out():
    for typed in ("p = m v", "Answer: m v", "Δp = p_1 - p_0 = m*v", r"$\Delta p = m\,v$", "≈ m v."):
        found = formula(typed, QUESTION)
        assert isinstance(found, Expr)
        assert text(found) == "m*v"


@pytest.mark.parametrize(
    ("its_unit", "meant"), [("m/(s*kg)", "v*cos(2)/m"), ("kg*m/s", None), ("m^2/s^2", None)]
)
def test_an_answer_with_two_readings_is_taken_as_what_fits_or_asked_about(its_unit, meant):
    part = replace(PROBLEM.part("a"), answer_types=("expression",), unit=unit(its_unit))
    found = answer_type("expression").read(Text("v cos 2/m"), question_of(PROBLEM, part))
    assert isinstance(found, Formulas if meant else Unclear)
    assert not meant or text(found.trees[0]) == meant


def test_what_is_wrongly_written_is_not_read_in_another_way():
    part = replace(PROBLEM.part("a"), answer_types=("expression",))
    found = answer_type("expression").read(Text("m v)"), question_of(PROBLEM, part))
    assert isinstance(found, Unclear)
    assert "bracket" in found.why


@pytest.mark.parametrize(
    ("text", "value"),
    [("e^(-x)/y", math.exp(-2) / 3), ("e^{-x}/y", math.exp(-2) / 3), ("e**(-x)/y", math.exp(-2) / 3), ("(x*y)^(1)/2", 3.0), ("x^(1)/2", 1.0)],
)  # fmt: skip
def test_written_brackets_end_the_exponent(text, value):
    tree = parse(text, ["x", "y"])
    assert not isinstance(tree, ParseError)
    assert ready(tree, DOUBLES)({"x": 2.0, "y": 3.0}) == pytest.approx(value)
