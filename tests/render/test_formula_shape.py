"""A formula with other numbers is converted as by itself, though it was converted once for all of its shape."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from corollary.render.mathml import mathml
from corollary.render.paper.typst import by_shape
from corollary.render.terminal_text import formula_text

FORMULAS = [
    r"F_r = \frac{J + m\, w}{\Delta t} = \frac{J + (0.55\,\mathrm{kg})\, (14.0\,\mathrm{m/s})}{(0.03\,\mathrm{s})}",
    r"w_{A} = \frac{u_{0}\, \left(1 - 0.63\right)}{2} \cdot 12.5\cdot 10^{-14}",
    r"x = 0{,}43\,\mathrm{m} + 120{,}5\,\mathrm{m}",
    r"\sqrt{ 12} + \sqrt{ 1.2} + \frac{ 10}{ 1.0}",
    r"x_{a 12} + y^{n + 25} + z^ 15 + q^{ 0.5} + e^{\frac{ 11}{ 22}}",
    r"\mathbf{v 12.5} + \text{in 30 parts of 1.5} + ( 30 \mathrm{s})",
    r"\begin{aligned} a &= 12.5 \\ b &= 30 \end{aligned}",
    r"v_ 12 = 12.5.6 + 3.25",
    r"( 20.0 m/s) = 72 km/h".replace(" m", "\N{NO-BREAK SPACE}m").replace(" k", "\N{NO-BREAK SPACE}k"),
    "٠٠ + 12.5",
    r"\frac{ 12.5",
]


@pytest.mark.parametrize("latex", FORMULAS)
@pytest.mark.parametrize("convert", [mathml, formula_text])
def test_a_formula_is_converted_as_by_itself(latex: str, convert: Callable[[str], str]):
    kept = by_shape(convert)
    other = latex.replace("2", "7").replace("3", "1")
    assert [kept(other), kept(latex), kept(other)] == [convert(other), convert(latex), convert(other)]


def test_formulas_of_one_shape_are_converted_once():
    converted = list[str]()

    def convert(latex: str) -> str:
        converted.append(latex)
        return latex

    kept = by_shape(convert)
    formulas = [
        rf"v = {v}\,\mathrm{{m/s}} + {u}\,\mathrm{{m/s}}"
        for v, u in ((1.5, 20.25), (17.5, 3.0), (0.25, 0.25))
    ]
    assert list(map(kept, formulas)) == formulas
    assert len(converted) == 1
    kept(r"v = 17\,\mathrm{m/s} + 0.25\,\mathrm{m/s}")
    assert len(converted) == 2, "whole numbers are another shape"
