"""The library of misconceptions: what each makes of a law, against the wrong law written out by hand."""

from __future__ import annotations

import pytest
import sympy

from corollary.author import function, unknowns, variable
from corollary.formula.plain_text import text
from corollary.laws import law, wrong
from corollary.laws.law import own_letters, sides
from corollary.misconceptions import (
    celsius_for_kelvin,
    diameter_for_radius,
    half_forgotten,
    left_out,
    not_squared,
    radius_for_diameter,
    sign_reversed,
    sine_for_cosine,
    squared,
    swapped,
    upside_down,
)

LETTERS = {
    name: sympy.Symbol(name, real=True)
    for name in ["K", "m", "v", "F", "theta", "A", "r", "d", "t", "g", "a", "p", "V", "n", "R", "T", "u", "w"]
}


def known(make):
    with own_letters(LETTERS):
        return make()


@pytest.mark.parametrize(
    ("misconception", "by_hand"),
    [
        (lambda: half_forgotten("K = m*v^2/2"), "K = m*v^2"),
        (lambda: not_squared("K = m*v^2/2", "v"), "K = m*v/2"),
        (lambda: squared("p = m*v", "v"), "p = m*v^2"),
        (lambda: sign_reversed("p = m*u - m*w", "w", "the velocity before"), "p = m*u + m*w"),
        (lambda: left_out("F - m*g = m*a", "g", "the weight"), "F = m*a"),
        (lambda: upside_down("t = d/v"), "t = v/d"),
        (lambda: swapped("m*u = n*w", "m", "n", "the masses"), "n*u = m*w"),
        (lambda: sine_for_cosine("A = F*cos(theta) + F*sin(theta)^2"), "A = F*sin(theta) + F*cos(theta)^2"),
        (lambda: diameter_for_radius("A = pi*r^2", "r"), "A = 4*pi*r^2"),
        (lambda: radius_for_diameter("A = pi*d^2/4", "d"), "A = pi*d^2/16"),
        (lambda: celsius_for_kelvin("p*V = n*R*T", "T"), "p*V = n*R*(T - 273.15)"),
    ],
)
def test_what_it_makes_of_a_law(misconception, by_hand):
    made, expected = known(misconception), known(lambda: wrong(by_hand))
    ((left, right),), ((wanted_left, wanted_right),) = sides(*made.rule.laws), sides(expected)
    assert sympy.expand(left - right - (wanted_left - wanted_right)) == 0
    assert made.text.endswith(".")


@pytest.mark.parametrize(
    ("misconception", "words"),
    [
        (lambda: not_squared("p = m*v", "v"), "stays as it is"),
        (lambda: sine_for_cosine("p = m*v"), "stays as it is"),
        (lambda: squared("p = m*v", "g"), "g does not occur in"),
        (lambda: swapped("p = m*v", "m", "g", "the masses"), "g does not occur in"),
        (lambda: half_forgotten("m*v^2/2"), "is not a law"),
        (lambda: half_forgotten("p = q*v"), "what does q mean"),
    ],
)
def test_a_law_that_cannot_be_mistaken_so(misconception, words):
    with pytest.raises(ValueError, match=words):
        known(misconception)


def test_a_law_with_an_integral_is_bent_as_any_other():
    with own_letters({"b": sympy.Symbol("b", positive=True)}):
        t = variable("t")
        function("v", t)
        unknowns("s t1")
        (bent,) = half_forgotten("s = int(v, t, 0, t1)/2").rule.laws
        assert text(bent.textbook) == text(law("Way", "s = 2*(int(v, t, 0, t1)/2)").textbook)
