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
        pytest.param(
            MECHANICS, "NEW.6", r"\beta = \arctan\left(\frac{v^{2}}{g\, r}\right) = ", marks=pytest.mark.whole
        ),
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
        # matrices, extrema, units of the givens
        (
            MECHANICS,
            "OSC.6",
            r"= \begin{pmatrix}k + c & -c \\ -c & k + c\end{pmatrix}$$"
            "\n"
            r"$$= \begin{pmatrix}26.00 & -6.000 \\ -6.000 & 26.00\end{pmatrix}\,\mathrm{N/m}",
        ),
        (
            CHAPTER,
            "X12.7",
            r"$$\frac{\mathrm{d} F_{y}}{\mathrm{d}\theta} = \frac{2\, m\, v_{0}\, \cos \theta}{\Delta t} = 0$$",
        ),
        (
            MATTER,
            "GAS.2",
            r"S = \frac{\pi\, d^{2}}{4} = \frac{\pi\, (8.0\,\mathrm{cm})^{2}}{4} = 50.27\,\mathrm{cm^{2}}",
        ),
        (MECHANICS, "GRA.4", r"= (20400\,\mathrm{km}) - (3400\,\mathrm{km}) = 17000\,\mathrm{km}"),
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


SHELF = """---
code: U1
title: A shelf
given:
  F: {is: pull, value: 300, from: 200, to: 400, step: 10, unit: N}
  A: {is: area, value: 2, from: 1, to: 3, step: 0.5, unit: m^2}
require:
  - F > 0
  - A > 0
---
A pull of {{F}} on an area of {{A}}, then three times the pressure.

## Pressure {#a .value unit="kPa" points=1}
How large is it?
"""
LAW = """A shelf.

## p: MEANING

Pull over area.

- law: Pressure, `p = F/A`

## (a) q

Three times as much.

- law: Sum, `q = 3*p`
- mistake: Twice as much. `q = 2*p`
- mistake: As much again. `q = 4*p`
"""


@pytest.mark.parametrize(
    ("meaning", "words", "value"),
    [
        ("pressure of one in mbar", "pressure of one", r"1.500\,\mathrm{mbar}"),
        ("pressure of one", "pressure of one", r"0.1500\,\mathrm{kPa}"),  # the part's
        ("pressure of one in A", "pressure of one in A", r"0.1500\,\mathrm{kPa}"),  # no unit of a pressure
    ],
)
def test_an_intermediate_result_stands_in_the_unit_that_its_author_names(
    tmp_path: Path, meaning: str, words: str, value: str
):
    for folder, text in (("problems", SHELF), ("solutions", LAW.replace("MEANING", meaning))):
        place = tmp_path / folder / "solids" / "shelf.md"
        place.parent.mkdir(parents=True)
        place.write_text(text, encoding="utf-8")
    bank = Bank(tmp_path)
    told = Solutions(bank).worked_solution(chapter(find(bank, "U1")))
    assert f"**First find $p$ ({words}).**" in told
    assert (
        rf"p = \frac{{F}}{{A}} = \frac{{(300\,\mathrm{{N}})}}{{(2.0\,\mathrm{{m^{{2}}}})}} = {value}$$"
        in told
    )
    assert rf"3\, ({value}) = 0.4500\,\mathrm{{kPa}}$$" in told
