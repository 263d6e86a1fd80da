"""Wide formulas come in pieces that a narrow screen may put below each other; nothing of them is lost or set otherwise."""

from __future__ import annotations

import re
from xml.etree.ElementTree import fromstring

import pytest

from corollary.render.mathml import displayed


def pieces(latex: str) -> list[str]:
    """The letters of each formula element, in their order."""
    found = fromstring(displayed(latex))
    return ["".join(math.itertext()).replace("\u2061", "") for math in found.iter("math")]


def test_a_short_formula_is_one():
    assert pieces("p = m v") == ["p=mv"]
    assert "tabindex" not in displayed("p = m v")
    assert '<math display="block" alttext="p = m v">' in displayed("p = m v")


LONG = r"F = \frac{m v}{t} = \frac{0.47\,\mathrm{kg} \cdot 13.5\,\mathrm{m/s}}{0.02\,\mathrm{s}} = 317.2\,\mathrm{N}"


def test_a_long_chain_breaks_before_its_relations():
    found = pieces(LONG)
    assert [piece[0] for piece in found] == ["F", "=", "=", "="]
    assert "".join(found) == "".join(pieces("x" + LONG))[1:]


def test_an_operator_at_the_start_of_a_line_stays_between_two_things():
    long = r"K = aaaaaaaaaaaaaaaa + bbbbbbbbbbbbbbbbbb - cccccccccccccccc"
    assert [piece[:1] for piece in pieces(long)] == ["K", "=", "+", "−"]
    assert displayed(long).count('form="infix"') == 3
    assert "infix" not in displayed(r"K = -aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa").split("=</mo>")[1]


def test_equations_side_by_side_are_parted_before_they_are_broken():
    found = fromstring(displayed(r"a_x = bbbbbbbbbb + cccccccccc \quad a_y = dddddddddd + eeeeeeeeee"))
    first, second = found.findall("span")
    assert "".join(first.itertext()).startswith("ax=b")
    assert "".join(second.itertext()).startswith("ay=d")


@pytest.mark.parametrize(
    "latex",
    [
        r"f\left(aaaaaaaaaaaaaaaa = bbbbbbbbbbbbbbbbbbbbb + c\right)",
        "f(aaaaaaaaaaaaaaaa = bbbbbbbbbbbbbbbbbbbbbbbb + c)",
        "|aaaaaaaaaaaaaaaaaaaaaa + bbbbbbbbbbbbbbbbbbbbbbbbbb|",
        r"\frac{aaaaaaaaaaaaaaaaaaaaaaaa + bbbbbbbbbbbbbbbbbbbb}{c}",
        r"\begin{cases} aaaaaaaaaaaaaaaaaaaa & x < 0 \\ b & x \ge 0 \end{cases}",
    ],
)
def test_what_belongs_together_is_not_broken_but_scrolls_and_is_reached_by_keyboard(latex):
    assert len(pieces(latex)) == 1
    assert re.search(r'<div class="formula" tabindex="0" role="group" aria-label="[^"]+">', displayed(latex))


def test_products_break_between_brackets():
    found = pieces(r"(2.0\,\mathrm{kg})(0.9899\,\mathrm{m/s})^2 (3.0\,\mathrm{kg})(4.56\,\mathrm{m/s})")
    assert all(piece.startswith("(") and piece.count("(") == 1 for piece in found)
    assert len(found) == 4


def test_what_is_no_formula_is_shown_as_it_is():
    assert displayed("\\frac{") == '<div class="formula"><code class="latex">\\frac{</code></div>\n'
