"""Formulas turned round: what undoes them, and what nobody would turn round by hand."""

from __future__ import annotations

import math

import pytest

from corollary.answers.evaluation import as_exact, number
from corollary.derive.paths import inverses
from corollary.formula.ast import Name
from corollary.formula.syntax import author_formula


@pytest.mark.parametrize(
    ("formula", "letter", "x"),
    [
        ("m*v", "v", 3.0),
        ("-p/M", "p", -2.5),
        ("(a + x)/b - c", "x", 0.7),
        ("sqrt(2*g*x)", "x", 1.3),
        ("x^2/(2*g)", "x", 4.0),
        ("x^2/(2*g)", "x", -4.0),
        ("a - b*x^2", "x", 0.5),
        ("pi*sqrt(x/k)", "x", 2.2),
        ("acos(1 - x/b)", "x", 0.4),
        ("a*cos(x)", "x", -0.6),
        ("a*sin(x)", "x", 2.1),
        ("b*exp(-x)", "x", 1.9),
        ("abs(x)*b", "x", -1.1),
        ("x^2 + b*x", "x", 0.9),
        ("c/x + x", "x", 0.8),
    ],
)
def test_one_of_the_branches_gives_the_letter_back(formula, letter, x):
    tree = author_formula(formula)
    values = {
        name: as_exact(value)
        for name, value in {"a": 2.0, "b": 1.7, "c": 0.9, "g": 9.8, "k": 5.0, "m": 0.3, "M": 8.0}.items()
    }
    values[letter] = as_exact(x)
    values["y"] = as_exact(number(tree, values))
    found = []
    for root in inverses(tree, letter, Name("y")):
        found.append(number(root, values))
    assert any(math.isclose(each, x, rel_tol=1e-12) for each in found)


@pytest.mark.parametrize("formula", ["x + sin(x)", "x^5 + x", "x*exp(x)"])
def test_what_takes_more_is_left(formula):
    assert inverses(author_formula(formula), "x", Name("y")) == ()
