"""Modules beside a solution: imported, read anew when they change, forgotten afterwards, and part of what marks depend on."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from corollary.derive.load import NotDerivable, source
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank
from corollary.problem.problem import Problem
from corollary.problem.variant import chapter

PROBLEM = """\
---
code: {code}
title: A cart
given:
  m: {{is: mass, value: 0.5, unit: kg}}
  v: {{is: speed, value: 3, unit: m/s}}
---
A cart.

## Momentum {{#a .value unit="kg*m/s"}}
How large?
"""
SOLUTION = """\
from corollary.author import derivation, unknowns
from momenta import momentum_step


def derive(m, v):
    p, = unknowns("p")
    return derivation(momentum_step(p))
"""
HELPER = """\
from corollary.author import step
from corollary.laws import law
from formulas import FORMULA


def momentum_step(p):
    return step(p, "So.", law("Momentum", FORMULA), answers="a")
"""


def bank(folder: Path, formula: str) -> tuple[Bank, Problem]:
    for name, text in {
        "problems/carts/cart.md": PROBLEM.format(code="X1.1"),
        "solutions/carts/cart.py": SOLUTION,
        "solutions/carts/momenta.py": HELPER,
        "solutions/carts/formulas.py": f"FORMULA = {formula!r}\n",
    }.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    here = Bank(folder)
    return here, here["X1.1"]


def momentum(here: Bank, problem: Problem) -> float:
    """By a new command: what is cached counts, what is in memory does not."""
    return Solutions(here).key(chapter(problem)).truths["a"].values[0]


def test_a_module_beside_a_solution_is_imported_and_read_anew(tmp_path):
    here, problem = bank(tmp_path, "p = m*v")
    assert momentum(here, problem) == 1.5
    before = source(here, problem)
    bank(tmp_path, "p = v*m + m*v")
    assert momentum(here, problem) == 3.0
    assert source(here, problem) != before
    assert not list(tmp_path.rglob("*.pyc"))


def test_two_banks_may_have_modules_of_one_name(tmp_path):
    one, other = bank(tmp_path / "one", "p = m*v"), bank(tmp_path / "other", "p = 2*m*v")
    assert [momentum(*one), momentum(*other), momentum(*one)] == [1.5, 3.0, 1.5]
    assert not {"momenta", "formulas"} & sys.modules.keys()
    assert not any("one" in each and "solutions" in each for each in sys.path)


def test_a_module_that_fails_is_named(tmp_path):
    here, problem = bank(tmp_path, "p = m*v")
    (tmp_path / "solutions" / "carts" / "formulas.py").write_text("FORMULA = 1/0\n")
    with pytest.raises(NotDerivable, match=r"cart.py:2: cannot be loaded: ZeroDivisionError"):
        momentum(here, problem)
