"""Products of vectors in laws, held against numpy."""

from __future__ import annotations

import numpy as np
import pytest
import sympy

from corollary.formula.latex import latex
from corollary.laws.law import law, sides

R, F, V = (2, -3, 5), (7, 1, -4), (1, 4, 2)


def value(formula: str, **letters: object) -> list[float]:
    stated = law("Product", formula, x=sympy.Symbol("x"), **letters)
    return [float(right) for _left, right in sides(stated)]


def test_cross_and_dot_are_numpys():
    x = sympy.symbols("x y z")
    torque = law("Torque", "M = cross(r, F)", M=x, r=R, F=F)
    assert [right for _left, right in sides(torque)] == list(np.cross(R, F))
    assert value("x = dot(F, r)", F=F, r=R) == [np.dot(F, R)]
    assert value("x = dot(v, cross(r, F))", v=V, r=R, F=F) == [np.dot(V, np.cross(R, F))]
    assert value("x = norm(r - F)", r=R, F=F) == [pytest.approx(np.linalg.norm(np.subtract(R, F)))]
    double = law("Double", "M = cross(v, cross(r, F))", M=x, v=V, r=R, F=F)
    assert [right for _left, right in sides(double)] == list(np.cross(V, np.cross(R, F)))


def test_in_a_plane_the_cross_product_is_a_number():
    assert value("x = cross(r, F)", r=R[:2], F=F[:2]) == [2 * 1 - (-3) * 7]


def test_they_are_set_as_a_book_does():
    stated = law("Torque", "M = cross(r, F) + 2*dot(r, F)*r", M=sympy.symbols("x y z"), r=R, F=F)
    bold = {letter: rf"\vec{{{letter}}}" for letter in stated.vectors}
    assert (
        latex(stated.textbook, bold)
        == r"\vec{M} = \vec{r} \times \vec{F} + 2\, \vec{r} \cdot \vec{F}\, \vec{r}"
    )


@pytest.mark.parametrize(
    ("formula", "said"),
    [
        ("x = cross(r, a)", "take vectors"),
        ("x = dot(3, r)", "take vectors"),
        ("x = dot(r)", "dot takes 2 vectors, not 1"),
        ("x = norm( a)", "take vectors"),
    ],
)
def test_what_is_no_vector_is_said(formula, said):
    letters = {"x": sympy.Symbol("x"), "r": R, "a": 3}
    with pytest.raises(ValueError, match=said):
        law(
            "Product",
            formula,
            **{
                letter: value
                for letter, value in letters.items()
                if letter in formula.replace("norm", "").replace("cross", "")
            },
        )
