"""TeX is read as what it shows."""

from __future__ import annotations

import pytest

from corollary.answers.quantity import Reading, read_quantity
from corollary.formula.ast import Expr
from corollary.formula.latex import latex
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula, parse
from corollary.formula.tex import without_tex


@pytest.mark.parametrize(
    ("typed", "plain"),
    [
        ("no tex", "no tex"),
        (r"$m \cdot v$", "m *v"),
        (r"\frac{m v}{M}", "((m v)/M)"),
        (r"\sqrt{2gh}", "sqrt(2gh)"),
        (r"30^{\circ}", "30°"),
        (r"8{,}6\,\text{Ns}", "8,6 Ns"),
        (r"\SI{8.6}{N s}", "8.6 N s"),
        (r"e^{-\frac{v_{\mathrm{rel}}}{2}}", "e^(-((v_{rel})/2))"),
    ],
)
def test_as_it_would_be_typed(typed, plain):
    assert without_tex(typed) == plain


@pytest.mark.parametrize(
    "formula",
    [
        "m*v/dt",
        "sqrt(2*g*h)",
        "-m*v*cos(theta)/M",
        "m0*exp(-v/u)",
        "m*v^2/2",
        "(m*v0 + M*u)/(m + M)",
        "2*d*sqrt(k/(m*(b^2*cos(alpha)^2 + d^2)))",
    ],
)
def test_what_a_formula_is_set_as_reads_back(formula):
    tree = author_formula(formula)
    letters = ["m", "v", "dt", "g", "h", "theta", "M", "m0", "u", "v0", "k", "b", "d", "alpha"]
    read = parse(f"${latex(tree)}$", letters)
    assert isinstance(read, Expr), read
    values = {name: 1.3 + place / 7 for place, name in enumerate(letters)} | {"pi": 3.14}
    assert _value(text(read), values) == pytest.approx(_value(formula, values))


def _value(formula: str, values: dict[str, float]) -> float:
    import math

    return eval(
        formula.replace("^", "**"), {"sqrt": math.sqrt, "cos": math.cos, "exp": math.exp}, dict(values)
    )


@pytest.mark.parametrize(
    "typed",
    [
        r"$8.6\,\mathrm{kg\,m/s}$",
        r"8.6 \frac{kg m}{s}",
        r"\Delta p = 8.6 kg \cdot m s^{-1}",
        r"8.6~\si{kg.m/s}",
    ],
)
def test_a_quantity_in_tex(typed):
    found = read_quantity(typed, None)
    assert isinstance(found, Reading), found
    assert float(found.si[0]) == 8.6
    assert (found.unit and found.unit.dimension.s) == -1


@pytest.mark.parametrize(
    ("before", "behind"),
    [(r"\frac{", "}{2}"), (r"\frac{1}{", "}"), (r"\sqrt{", "}"), (r"\hat{", "}"), (r"\dot{", "}"), (r"\text{", "}"),
     (r"\SI{", "}{m}"), (r"\SI{3}{", "}")],
)  # fmt: skip
def test_braces_however_deep_end_soon(before, behind):
    """What lies deeper than any formula is left as it stands, and no reader is exhausted by it."""
    typed = 1500 * before + "x" + 1500 * behind
    assert before.partition("{")[0] in without_tex(typed)


def test_a_sign_alone_behind_a_backslash_is_that_sign():
    assert without_tex(r"5 \% of \{x\|y\}") == "5 % of (x|y)"
