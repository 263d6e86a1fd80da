"""Formulas as TeX sets them."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.formula.ast import Name, Number, Product
from corollary.formula.latex import latex, letter, vector
from corollary.formula.syntax import author_formula


@pytest.mark.parametrize(
    ("name", "tex"),
    [
        ("m_A", "m_{A}"),
        ("mA", "m_{A}"),
        ("v_A0", "v_{A,0}"),
        ("vA0", "v_{A,0}"),
        ("vAx", "v_{A,x}"),
        ("dt", r"\Delta t"),
        ("dv", r"\Delta v"),
        ("d", "d"),
        ("D", "D"),
        ("mu", r"\mu"),
        ("theta", r"\theta"),
        ("thetamax", r"\theta_{\mathrm{max}}"),
        ("Ms", "M_{s}"),
        ("v0", "v_{0}"),
        ("vrel", r"v_{\mathrm{rel}}"),
        ("mdot", r"\dot{m}"),
        ("lam", r"\lambda"),
        ("lamA", r"\lambda_{A}"),
        ("lamp", r"l_{\mathrm{amp}}"),
        ("eps", r"\varepsilon"),
        ("epsx", r"\varepsilon_{x}"),
        ("Delta_t", r"\Delta t"),
        ("delta", r"\delta"),
        ("U0", "U_{0}"),
        ("xp", "x_{p}"),
        ("v_{B,1}", "v_{B,1}"),
        ("omega0", r"\omega_{0}"),
    ],
)
def test_letters(name, tex):
    assert letter(name) == tex


@pytest.mark.parametrize(
    ("formula", "tex"),
    [
        ("m*v/dt", r"\frac{m\, v}{\Delta t}"),
        (
            "m_A*v_A0 + m_B*v_B0 = (m_A + m_B)*v",
            r"m_{A}\, v_{A,0} + m_{B}\, v_{B,0} = \left(m_{A} + m_{B}\right)\, v",
        ),
        ("pi/2", r"\frac{\pi}{2}"),
        ("m/180", r"\frac{m}{180}"),
        ("-(1/2)*m*v^2", r"-\frac{1}{2}\, m\, v^{2}"),
        ("sqrt(2*g*h)", r"\sqrt{2\, g\, h}"),
        ("((m - M)/(m + M))^2*L", r"\left(\frac{m - M}{m + M}\right)^{2}\, L"),
        ("2*m*v*sin(theta)", r"2\, m\, v\, \sin \theta"),
        ("sin(theta)*v", r"\sin(\theta)\, v"),
        ("sin(theta)^2*v", r"\sin^{2}(\theta)\, v"),
        ("sin(theta)^2 + cos(2*theta)", r"\sin^{2} \theta + \cos\left(2\, \theta\right)"),
        ("2*3*m", r"2 \cdot 3\, m"),
        ("1.50*m", r"1.50\, m"),
        ("1.2e-5*m", r"1.2 \cdot 10^{-5}\, m"),
        ("exp(-x/2)", r"e^{-\frac{x}{2}}"),
        ("exp(x)^2", r"\left(e^{x}\right)^{2}"),
        ("abs(v - w) >= 1.5", r"\left|v - w\right| \geq 1.5"),
        ("a*(-b) - (-c)", r"a\, \left(-b\right) - \left(-c\right)"),
        ("a - (b + c)", r"a - \left(b + c\right)"),
        ("atan2(y, x)", r"\mathrm{atan2}\left(y, x\right)"),
        ("ln(m0/m1)", r"\ln\left(\frac{m_{0}}{m_{1}}\right)"),
        ("sin(30*(pi/180))", r"\sin\left(30{}^{\circ}\right)"),
        ("(a^b)^c", r"\left(a^{b}\right)^{c}"),
        ("x != 0", r"x \neq 0"),
    ],
)
def test_the_form_is_kept(formula, tex):
    assert latex(author_formula(formula)) == tex


def test_letters_can_be_given():
    assert latex(author_formula("m*v"), {"v": r"\vec{v}_{0}"}) == r"m\, \vec{v}_{0}"


@pytest.mark.parametrize(
    ("name", "tex"),
    [
        ("JAB", r"{\vec{J}_{A,B}}"),
        ("v1", r"{\vec{v}_{1}}"),
        ("dp_r", r"\Delta {\vec{p}_{r}}"),
        ("mu", r"\vec{\mu}"),
        ("pdot", r"\vec{\dot{p}}"),
    ],
)
def test_the_arrow_of_a_vector_stands_over_its_letter_alone(name, tex):
    assert vector(name) == tex


def test_numbers_in_products_keep_apart():
    assert latex(Product((Name("x"), Number(Fraction(-3))))) == r"x\, \left(-3\right)"
    assert latex(Number(Fraction(-1, 3))) == r"-\frac{1}{3}"
