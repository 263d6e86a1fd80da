"""What follows from which equations, against identities of the textbooks."""

from __future__ import annotations

from fractions import Fraction

import pytest

from corollary.formula.errors import Undefined
from corollary.formula.syntax import author_formula
from corollary.polynomials.ideal import Ideal
from corollary.polynomials.polynomial import TooLarge
from corollary.polynomials.polynomial_signs import Signs
from corollary.polynomials.translate import Translation

POSITIVE = (Fraction(0), None)


def follows(claim: str, *equations: str, **known: tuple[Fraction | None, Fraction | None]) -> bool:
    trees = [author_formula(text) for text in (claim, *equations)]
    translation = Translation(trees, known)
    asked, *given = [translation.equation(tree) for tree in trees]
    ideal = Ideal(translation.known, translation.spare, translation.divisors)
    for each in (*translation.relations, *given):
        ideal.add(each)
    return ideal.contains(asked)


@pytest.mark.parametrize(
    ("claim", "equations"),
    [
        ("(a + b)^2 = a^2 + 2*a*b + b^2", ()),
        ("sin(2*x) = 2*sin(x)*cos(x)", ()),
        ("cos(x) = 1 - 2*sin(x/2)^2", ()),
        ("sin(x + y) = sin(x)*cos(y) + cos(x)*sin(y)", ()),
        ("cos(pi/2 - x) = sin(x)", ()),
        ("1 + tan(x)^2 = 1/cos(x)^2", ()),
        ("cos(3*x) = 4*cos(x)^3 - 3*cos(x)", ()),
        ("abs(x)^2 = x^2", ()),
        ("exp(x + y - y) = exp(x)", ()),
        ("x^(-2) = 1/(x*x)", ()),
        ("z = 1", ("x + y = 3", "x - y = 1", "z = y")),
        ("x*y = 6", ("x + y = 5", "x^2 + y^2 = 13")),
        ("x = 0", ("x^3 = 0",)),
        ("r = 2", ("r*p = 2*p",)),
        ("v = sqrt(2*g*h)", ("p*v^2/2 = p*g*h",)),
        ("v = sqrt(2)*sqrt(g)*sqrt(h)", ("v^2 = 2*g*h",)),
        ("p = v", ("p^2 = v^2",)),
        ("p*v = g", ("sqrt(p^2*v^2) = g",)),
    ],
)
def test_what_follows(claim, equations):
    assert follows(claim, *equations, p=POSITIVE, v=POSITIVE, g=POSITIVE, h=POSITIVE)


@pytest.mark.parametrize(
    ("claim", "equations"),
    [
        ("(a + b)^2 = a^2 + b^2", ()),
        ("sin(2*x) = 2*sin(x)", ()),
        ("sqrt(x^2) = x", ()),
        ("r = 2", ("r*x = 2*x",)),
        ("x = y", ("x^2 = y^2",)),
        ("x = 2", ("x + y = 5", "x*y = 6")),
        ("p = -v", ("p^2 = v^2",)),
        ("exp(x) = 1 + x", ()),
        ("abs(x) = x", ()),
    ],
)
def test_what_does_not_follow(claim, equations):
    assert not follows(claim, *equations, p=POSITIVE, v=POSITIVE)


def test_what_is_known_of_a_range_counts():
    bounds = {"a": (Fraction(2), Fraction(10)), "b": (Fraction(-6), Fraction(3, 2))}
    assert follows("r = 1", "r*(a - b) = a - b", **bounds)
    assert not follows("r = 1", "r*(a + b) = a + b", **bounds)
    assert follows("r = 1", "r*(10 - x^2) = 10 - x^2", x=(Fraction(-3), Fraction(3)))
    assert not follows("r = 1", "r*(8 - x^2) = 8 - x^2", x=(Fraction(-3), Fraction(3)))


def test_signs():
    translation = Translation([author_formula("a*b*c + d^2*a")], {})
    polynomial = translation.fraction(author_formula("a*b + d^2*a")).top
    assert Signs({"a": POSITIVE, "b": POSITIVE}).of(polynomial) == 1
    assert Signs({"a": (None, Fraction(0)), "b": POSITIVE}).of(polynomial) == -1
    assert Signs({"a": POSITIVE}).of(polynomial) == 0
    assert Signs({}).of(polynomial - polynomial) == 0


def test_what_grows_is_not_decided():
    with pytest.raises(TooLarge):
        follows("(a + b + c + d + f)^64 = 1")
    with pytest.raises(TooLarge):
        follows("a*(a + b + c + d + f)^20*(a - b - c + d)^20 = 1")
    with pytest.raises(TooLarge):
        follows("cos(900*x) = 1")


def test_nothing_is_divided_by_zero():
    with pytest.raises(Undefined):
        follows("1/(a - a) = b")
