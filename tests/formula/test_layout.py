"""Formulas set as a textbook sets them: written here by hand, and equal in value to what they are made of."""

from __future__ import annotations

import math

import pytest

from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.layout import Layout, LetterOrder
from corollary.formula.plain_text import text
from corollary.formula.syntax import author_formula

LAWS = [
    "f = mu*N",
    "N = m*g",
    "m*g*h = m*v^2/2",
    "p = m1*v1 + m2*v2",
    "1/f = 1/a + 1/b",
    "q = p + rho*g*h",
    "U = U0*exp(-t/tau)",
]
POINTS = [
    {
        "mu": 0.3, "N": 19.6, "m": 2.0, "g": 9.8, "h": 1.5, "v": 5.0, "p": 3.0, "rho": 7.0, "q": 4.0, "U0": 9.0, "t": 2.0, "tau": 3.0,
        "m1": 2.0, "m2": 5.0, "v1": 3.0, "v2": -1.0, "f": 2.0, "a": 1.5, "b": 3.0, "k": 50.0, "theta": 0.5, "r": 0.5, "G": 2.0, "M": 3.0,
        "T": 4.0,
    }
]  # fmt: skip
LAYOUT = Layout(LetterOrder(map(author_formula, LAWS), {"N": author_formula("m*g")}), POINTS)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize(
    ("solved", "book"),
    [
        ("m*g*mu", "mu*m*g"),
        ("g*h*rho + p", "p + rho*g*h"),
        ("v1*(m1 - m2)/(m1 + m2)", "(m1 - m2)*v1/(m1 + m2)"),
        ("2*m1*v1*m2/(m1 + m2)", "2*m1*m2*v1/(m1 + m2)"),
        ("-f*a/(a - f)", "f*a/(f - a)"),
        ("-(m1 - m2)/(f - a)", "(m2 - m1)/(f - a)"),
        ("sqrt(2*m/k)/2", "sqrt(m/(2*k))"),
        ("3*sqrt(2)*sqrt(g)*sqrt(h)", "3*sqrt(2*g*h)"),
        ("sqrt(18*g*h)", "3*sqrt(2*g*h)"),
        ("2^(1/3)*G^(1/3)*M^(1/3)*T^(2/3)/(2*pi^(2/3))", "(G*M*T^2/(4*pi^2))^(1/3)"),
        ("sqrt(1/(k*m))", "1/sqrt(m*k)"),
        ("m*(r - 1)*(r + 1)*v^2", "m*v^2*(r^2 - 1)"),
        ("(1/2 - r/2)*v", "v*(1 - r)/2"),
        ("abs(f - a)*mu", "mu*(f - a)"),
        ("abs(a - f)*mu", "mu*(f - a)"),
        ("-v1 - v", "-(v + v1)"),
        ("g*sin(theta)*m", "m*g*sin(theta)"),
    ],
)
def test_the_form_of_the_book(solved: str, book: str):
    made = LAYOUT.set(author_formula(solved))
    assert sorted(text(made)) == sorted(text(author_formula(book)))  # the same signs…
    assert text(made) == text(author_formula(book))
    value = ready(author_formula(solved), DOUBLES)(POINTS[0])
    assert math.isclose(ready(made, DOUBLES)(POINTS[0]), value, rel_tol=1e-12)


@pytest.mark.parametrize(
    ("dearer", "cheaper"),
    [
        ("U0 - U0*exp(-t/tau)", "U0*(1 - exp(-t/tau))"),
        ("-f*a/(a - f)", "f*a/(f - a)"),
        ("m1*v1/m2 + v1", "(m1 + m2)*v1/m2"),
        ("(2*m*v^2/2)/(m*g)", "v^2/g"),
        ("1/(1/a + 1/b)", "a*b/(a + b)"),
        ("m*v - m*(-r)", "m*(v + r)"),
        ("(r - 1)*(r + 1)", "r^2 - 1"),
        ("sqrt(2*m/k)/2", "sqrt(m/(2*k))"),
        ("rho*2*h", "2*rho*h"),
        ("(a*b*v + h*f*v + a*b*h)/(a*b)", "v + h + h*f*v/(a*b)"),
    ],
)
def test_a_reader_pays_less_for_the_form_of_the_book(dearer: str, cheaper: str):
    assert LAYOUT.total(author_formula(cheaper)) < LAYOUT.total(author_formula(dearer))
