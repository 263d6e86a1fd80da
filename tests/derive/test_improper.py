"""Integrals up to infinity: their values, the same however infinity is typed, and a sentence where there is none."""

from __future__ import annotations

import math

import pytest
import sympy
from scipy.integrate import quad

from corollary.answers.evaluation import as_exact
from corollary.derive.improper import by_quadrature
from corollary.formula.ball import certified

ASKS = '## Way {#a .value unit="m" points=1}\nHow far?\n'
BODY = """
    T, s = variable("T"), unknown("s")
    w = function("w", T)
    return derivation(
        step(s, "Why.", law("Speed", "w = {speed}"), law("Way", "s = int(w, T, {low}, {high})"), answers="a"))
"""


def body(speed: str, low: str = "0", high: str = "oo") -> str:
    return BODY.format(speed=speed, low=low, high=high)


def value(solution) -> float:
    (find,) = [each for each in solution.unknowns if each.part == "a"]
    return certified(find.in_givens[0], {"v": as_exact(3.0), "t": as_exact(2.0)}).value


@pytest.mark.parametrize(
    ("speed", "low", "high", "integrand", "ends"),
    [
        ("v*exp(-T/t)", "0", "oo", lambda x: 3 * math.exp(-x / 2), (0, math.inf)),
        ("v*exp(-T/t)", "t", "inf", lambda x: 3 * math.exp(-x / 2), (2, math.inf)),
        ("v*exp(-T/t)", "0", "∞", lambda x: 3 * math.exp(-x / 2), (0, math.inf)),
        ("v*exp(-(T/t)^2)", "-oo", "oo", lambda x: 3 * math.exp(-((x / 2) ** 2)), (-math.inf, math.inf)),
        ("v*exp(T/t)", "-inf", "0", lambda x: 3 * math.exp(x / 2), (-math.inf, 0)),
        ("v/(1 + (T/t)^2)", "0", "oo", lambda x: 3 / (1 + (x / 2) ** 2), (0, math.inf)),
        ("v*t^2/T^2", "t", "oo", lambda x: 12 / x**2, (2, math.inf)),
        ("v*T/t*exp(-T/t)", "0", "oo", lambda x: 3 * x / 2 * math.exp(-x / 2), (0, math.inf)),
    ],
)
def test_the_value_is_that_of_quadrature(solved, speed, low, high, integrand, ends):
    found = value(solved(body(speed, low, high), asks=ASKS))
    assert found == pytest.approx(quad(integrand, *ends, epsabs=0, epsrel=1e-11)[0], rel=1e-9)


@pytest.mark.parametrize(
    ("speed", "words"),
    [
        (
            "v",
            "diverges: it has no finite value; correct what is integrated, or integrate up to a finite limit",
        ),
        ("v*exp(T/t)", "diverges"),
        ("v*t/(T + t)", "diverges"),
    ],
)
def test_an_integral_without_a_value_is_refused(refused, speed, words):
    _line, sentence = refused(body(speed), asks=ASKS)
    assert words in sentence
    assert "oo" in sentence


def test_an_oscillation_that_does_not_die_away_has_no_value(refused):
    _line, sentence = refused(body("v*cos(T/t)"), asks=ASKS)
    assert "diverges" in sentence


T = sympy.Symbol("T", real=True)


@pytest.mark.parametrize(
    ("integrand", "low", "high", "wanted"),
    [
        (sympy.exp(-(T**2)), -sympy.oo, sympy.oo, math.sqrt(math.pi)),
        (sympy.exp(-T * 10**9), 0, sympy.oo, 1e-9),  # no scale is known before
        (sympy.exp(-T / 10**9), 0, sympy.oo, 1e9),
        (1 / T**2, 2, sympy.oo, 0.5),
        (sympy.exp(-T) / sympy.sqrt(T), 0, sympy.oo, math.sqrt(math.pi)),
        (T**3 / (sympy.exp(T) - 1), 0, sympy.oo, math.pi**4 / 15),  # Planck's
        (sympy.exp(-T) * sympy.cos(5 * T), 0, sympy.oo, 1 / 26),
        (sympy.exp(-T), sympy.oo, 0, -1.0),
    ],
)
def test_quadrature_of_known_integrals(integrand, low, high, wanted):
    assert by_quadrature(sympy.Integral(integrand, (T, low, high))) == pytest.approx(wanted, rel=1e-10)
