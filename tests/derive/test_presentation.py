"""Worked solutions print formulas as the book has them, and what is printed has the value of the key."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from corollary.derive.solution import ClosedForms
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.grading.solutions import Solutions
from corollary.problem.bank import Bank, chapter_bank, find
from corollary.problem.sampling import sample
from corollary.problem.variant import chapter

EXAMPLES = Path(__file__).parents[2] / "examples" / "banks"
MECHANICS, FIELDS, MATTER = (
    Bank(EXAMPLES / f"corollary-{name}" / "src" / f"corollary_{name}")
    for name in ("mechanics", "fields", "matter")
)
CHAPTER = chapter_bank()


@pytest.mark.parametrize(
    ("bank", "code", "line"),
    [
        (CHAPTER, "X12.2", r"v_{2} = -\frac{m_{1}\, v_{1}}{m_{2}} = "),
        (CHAPTER, "X12.10", r"N = \left(M + m\right)\, g = "),
        (CHAPTER, "X12.10", r"u = \sqrt{\frac{2\, \mu\, N\, d}{M + m}} = \sqrt{2\, \mu\, g\, d} = "),
        (CHAPTER, "X12.12", r"v_{0} = \sqrt{2\, g\, L} = "),
        (CHAPTER, "X12.12", r"= \frac{\left(m - M\right)\, v_{0}}{m + M} = "),
        (CHAPTER, "S12.5el", r"v_{A,1} = \frac{\left(m_{A} - m_{B}\right)\, v_{A}}{m_{A} + m_{B}} = "),
        (
            CHAPTER,
            "S12.5pi",
            r"= -\frac{m_{A}\, m_{B}\, \left(v_{A} - v_{B}\right)^{2}}{2\, \left(m_{A} + m_{B}\right)}",
        ),
        (MECHANICS, "NEW.3", r"f = \mu\, N = \mu\, M\, g = 0.20\, (24.50\,\mathrm{N}) = 4.900\,\mathrm{N}"),
        (MECHANICS, "NEW.6", r"\beta = \arctan\left(\frac{v^{2}}{g\, r}\right) = "),
        (MECHANICS, "NEW.8", r"T = \frac{2\, \pi\, r}{v} = 2\, \pi\, \sqrt{\frac{L\, \cos \theta}{g}} = "),
        (MECHANICS, "GRA.4", r"r = \sqrt[3]{\frac{G\, M\, T^{2}}{4\, \pi^{2}}} = "),
        (MECHANICS, "KIN.7", r"T = t + w + u = "),
        (
            FIELDS,
            "OPT.3",
            r"b = \frac{a\, f}{f - a} = \frac{(45\,\mathrm{mm})\, (60\,\mathrm{mm})}{(60\,\mathrm{mm}) - (45\,\mathrm{mm})} = 180.0\,\mathrm{mm}",
        ),
        (FIELDS, "CIR.6", r"\tau = R\, C = "),
        (
            FIELDS,
            "OPT.1",
            r"\arcsin\left(\frac{\sin (50{}^{\circ})}{1.33}\right)".replace("{}^", r"\mathrm{{}^").replace(
                r"\circ}", r"\circ}}"
            ),
        ),
    ],
)
def test_the_line_of_the_book(bank: Bank, code: str, line: str):
    assert line in Solutions(bank).worked_solution(chapter(find(bank, code)))


@pytest.mark.parametrize(
    ("bank", "code"),
    [
        (CHAPTER, "X12.3"), (CHAPTER, "X12.10"), (CHAPTER, "X12.13"), (CHAPTER, "S12.5pi"), (MECHANICS, "NEW.6"), (MECHANICS, "GRA.5"),
        (MECHANICS, "OSC.6"), (FIELDS, "CIR.3"), (FIELDS, "OPT.4"), (MATTER, "GAS.2"), (MATTER, "HEA.1"),
    ],
)  # fmt: skip
def test_what_is_printed_has_the_value_of_the_formula_that_marks(bank: Bank, code: str):
    problem = find(bank, code)
    solution = Solutions(bank).of(problem)
    compared = 0
    for variant in sample(problem, 20, salt="printed"):
        at = dict(variant.si)
        for find_ in solution.unknowns:
            assert isinstance(find_.local, ClosedForms)
            for name, marks, prints in zip(find_.names, find_.local.trees, find_.printed, strict=True):
                at[name] = ready(marks, DOUBLES)(at)
                assert math.isclose(ready(prints, DOUBLES)(at), at[name], rel_tol=1e-9, abs_tol=1e-12)
                compared += marks != prints
            for name, prints in zip(find_.names, find_.printed_in_givens or (), strict=False):
                assert math.isclose(ready(prints, DOUBLES)(at), at[name], rel_tol=1e-9, abs_tol=1e-12)
    assert compared
