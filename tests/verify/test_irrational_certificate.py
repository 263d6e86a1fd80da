"""Certificates of roots that are irrational: accepted by the kernel, or left out with the reason, and wrong ones never."""

from __future__ import annotations

import shutil
from dataclasses import replace

import pytest

from corollary.derive.solve import solve
from corollary.formula.syntax import author_formula
from corollary.problem.bank import Bank, find
from corollary.verify.certificate.script import certificate, unproven

PROBLEM = """\
---
code: X1.1
title: Lengths
given:
  L: {is: length, value: 1.5, from: 1.1, to: 2.5, step: 0.1, unit: m}
require: [L > 0]
---
## Length {#a .value unit="m"}
How long?
"""
SOLUTION = """\
from corollary.author import *
from corollary.laws import law

def derive(L):
    (x,) = unknowns("x")
    return derivation(step(x, "So.", law("Length", "LAW"), where=x > 0, answers="a"))
"""
GOLDEN, DIAGONAL = "x^2 - L*x - L^2 = 0", "x^2 = 2*L^2"


@pytest.fixture
def solved(tmp_path):
    def put(law: str, wrong: str = ""):
        for folder, text in (("problems/x.md", PROBLEM), ("solutions/x.py", SOLUTION.replace("LAW", law))):
            (tmp_path / folder).parent.mkdir()
            (tmp_path / folder).write_text(text, encoding="utf-8")
        bank = Bank(tmp_path)
        right = solve(bank, find(bank, "X1.1"))
        if not wrong:
            return right
        (one,) = right.unknowns
        return replace(right, unknowns=(replace(one, in_givens=(author_formula(wrong),)),))

    return put


@pytest.mark.parametrize("law", [GOLDEN, DIAGONAL])
def test_an_example_that_is_irrational_is_left_out_with_the_reason(solved, law):
    (step,) = certificate(solved(law))
    lemmas = {each.name: each for each in step.lemmas}
    assert lemmas["x_holds"].text
    assert lemmas["x_only"].text
    assert not lemmas["x_example"].text
    assert "irrational at the printed numbers" in lemmas["x_example"].why


@pytest.mark.client
@pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed (apt install coq)")
@pytest.mark.parametrize("law", [GOLDEN, DIAGONAL])
def test_the_kernel_accepts_that_an_irrational_root_fulfils_its_law(solved, law):
    """That there is no other is not always shown by these tactics, and is then said to be open."""
    right = solved(law)
    assert "x_holds" not in unproven(right, certificate(right))


@pytest.mark.client
@pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed (apt install coq)")
@pytest.mark.parametrize(
    ("law", "wrong"),
    [
        (DIAGONAL, "1.41421356237*L"),  # a rational near it
        (DIAGONAL, "sqrt(3)*L"),
        (GOLDEN, "1.618*L"),
    ],
)
def test_the_kernel_accepts_no_other_number_for_it(solved, law, wrong):
    found = solved(law, wrong)
    assert {"x_holds", "x_only"} <= unproven(found, certificate(found))


@pytest.mark.client
@pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed (apt install coq)")
def test_the_kernel_does_not_accept_the_root_that_the_condition_leaves_out(solved):
    """It fulfils the law, too, and is refused as what the law and the condition leave."""
    found = solved(GOLDEN, "(1 - sqrt(5))*L/2")
    assert unproven(found, certificate(found)) >= {"x_only"}
