"""Formulas: MathML that says what the LaTeX says, whatever the LaTeX is."""

from __future__ import annotations

import re
import time
from base64 import b64decode
from io import BytesIO
from xml.etree.ElementTree import fromstring

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from corollary.render.mathml import ATTRIBUTES, TAGS, formula, mathml
from corollary.render.page import USUAL, font, font_file

APPLY = "\u2061"
PIECES = [
    *"{}_^&$%#~ \\xF2.(=<>'\"",
    *("\u00a0", "−", "°", r"\\", r"\frac", r"\sqrt", r"\left(", r"\right)", r"\begin{cases}", r"\end{cases}"),
    *(r"\text{", r"\mathrm{", r"\sin", r"\unicode{x", r"\vec ", r"\limits", r"\href{"),
]


def bare(latex: str) -> str:
    """The MathML without its attributes."""
    return re.sub(r' [a-z]+="[^"]*"', "", mathml(latex))


@pytest.mark.parametrize(
    ("latex", "holds"),
    [
        (r"\cos\theta", f"<mi>cos</mi><mo>{APPLY}</mo><mi>θ</mi>"),
        (r"\sin(x)", f"<mi>sin</mi><mo>{APPLY}</mo><mo>(</mo>"),
        (r"\sin^2 x", f"<msup><mi>sin</mi><mn>2</mn></msup><mo>{APPLY}</mo><mi>x</mi>"),
        (r"2v\sin x", "<mi>v</mi><mspace></mspace><mi>sin</mi>"),
        (r"\operatorname{sgn}x", f"<mi>sgn</mi><mo>{APPLY}</mo>"),
        (r"F_{\mathrm{net}}", "<mi>net</mi>"),
        (r"\mathbf{v}\boldsymbol{\omega}", "<mi>𝐯</mi><mrow><mi>𝝎</mi></mrow>"),
        (r"f'(x)", "<mrow><mi>f</mi><mo>′</mo></mrow>"),
        ("20.0\u00a0m/s", "<mn>20.0</mn><mspace></mspace><mtext>m/s</mtext>"),
        ("−5\u00a0kg m/s", "<mo>−</mo><mn>5</mn><mspace></mspace><mtext>kg\u00a0m/s</mtext>"),
        ("50%", "<mi>%</mi>"),
        ("30°", "<mn>30</mn><mo>°</mo>"),
        (
            r"\begin{aligned}a&=b\\c&=d\end{aligned}",
            "<mtr><mtd><mi>a</mi></mtd><mtd><mi></mi><mo>=</mo><mi>b</mi></mtd></mtr>",
        ),
        (r"\lim_{t\to0}x", "<munder><mo>lim</mo>"),
    ],
)
def test_what_is_meant_is_written(latex, holds):
    assert holds in bare(latex)


def test_letters_stand_upright_or_slanted_as_in_print():
    upright = '<mi mathvariant="normal">'
    assert f"{upright}s</mi>" in mathml(r"\mathrm{s}")
    assert f"{upright}Δ</mi><mi>p</mi>" in mathml(r"\Delta p")


def test_a_sign_after_an_operator_is_a_sign():
    assert '<mo>=</mo><mo form="prefix">−</mo>' in mathml("x=-1")
    assert "prefix" not in mathml("x-1")
    assert "prefix" not in mathml("(x)-1")


NO_LATEX = [
    r"\frac{a",
    "a_b_c",
    r"\left(",
    "x^",
    r"\def\a{\a\a}\a",
    r"\newcommand{\a}{b}\a",
    "{" * 99,
    "x" * 9999,
]


@pytest.mark.parametrize("latex", NO_LATEX)
def test_what_is_no_latex_is_shown_as_it_stands(latex):
    shown = fromstring(mathml(latex))
    assert (shown.tag, shown.get("class"), shown.text) == ("code", "latex", latex)


@pytest.mark.parametrize(
    "latex",
    [
        r"\href{javascript:alert(1)}{x}",
        r"\style{position:fixed}{x}",
        r"\class{note}{x}",
        r"\text{<img src=x onerror=alert(1)>}",
        r"\text{&#x3c;script&#x3e;}",
        r"\hspace{9999em}x",
        r"\rule{9999em}{9999em}",
        r"\color{white}{x}",
        "<script>",
    ],
)
def test_a_formula_can_neither_run_nor_hide_nor_push_the_page_away(latex):
    for element in fromstring(mathml(latex)).iter():
        assert element.tag in TAGS | {"code"}
        element.attrib.pop("alttext", None)
        assert not {"href", "style", "mathcolor"} & element.attrib.keys()
        assert not any("9999" in value or "note" in value for value in element.attrib.values())


@settings(max_examples=200, deadline=None)
@given(st.lists(st.sampled_from(PIECES), max_size=25).map("".join))
def test_whatever_is_typed_gives_well_formed_and_harmless_mathml(latex):
    for element in fromstring(mathml(latex)).iter():
        assert element.tag in TAGS | {"code"}
        assert element.attrib.keys() <= ATTRIBUTES | {"mathvariant", "mathsize", "alttext", "class"}


@pytest.mark.parametrize(
    "latex", [r"\sqrt" * 600, r"\left(" * 500, "x_{" * 50 + "}" * 50, "&" * 3999, r"\frac" * 800]
)
def test_hostile_formulas_are_answered_soon(latex):
    start = time.process_time()
    mathml(latex)
    assert time.process_time() - start < 1.0


def test_the_font_has_the_letters_of_mechanics():
    pytest.importorskip("brotli", reason="woff2 is compressed with brotli")
    from fontTools.ttLib import TTFont

    face = TTFont(BytesIO(b64decode(font("mathematics.woff2"))))
    tree = formula(
        r"\Delta p = \int_{t_0}^{t_1} \mathbf{F}\cdot\vec v\,dt \approx \sqrt{2gh}, \sum_i \dot x_i \ge \hbar\ell"
    )
    assert tree is not None
    needed = {letter for element in tree.iter() for letter in element.text or ""}
    assert len(needed) > 20
    assert {ord(letter) for letter in needed} <= face.getBestCmap().keys()
    assert "MATH" in face
    assert face["name"].getDebugName(1) == "Corollary Mathematics"


def test_pages_of_usual_formulas_carry_the_half_of_the_font_that_has_their_letters():
    pytest.importorskip("brotli", reason="woff2 is compressed with brotli")
    from fontTools.ttLib import TTFont

    usual = mathml(
        r"\Delta p = \int_{t_0}^{t_1} F\,dt \approx \sqrt{2gh}\cos\alpha, \dot x_i \ge 3~\mathrm{kg\,m/s}"
    )
    assert font_file(usual, formulas=False) == "mathematics_usual.woff2"
    for other in (r"\mathbf{F} = m", r"\hbar \ne \Omega", r"\ell \in \mathbb{R}"):
        assert font_file(usual + mathml(other), formulas=False) == "mathematics.woff2"
    face = TTFont(BytesIO(b64decode(font("mathematics_usual.woff2"))))
    letters = face.getBestCmap().keys()
    italic = {ord("𝑎") + place for place in range(26) if place != 7} | {
        ord("𝛼") + place for place in range(25)
    }
    signs = {code for code in range(0x20, 0x2300) if USUAL.fullmatch(chr(code))}
    assert len(signs) > 140
    assert signs <= letters
    assert italic <= letters
    assert "MATH" in face
