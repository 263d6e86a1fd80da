"""Three real roots of a cubic equation in cosines, where Cardano's formula has complex numbers on its way."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy

from corollary.derive.known import Point, Root, at


def real_roots(equation: sympy.Expr, unknown: sympy.Symbol, points: Sequence[Point]) -> list[Root]:
    """The roots of `equation` = 0 in the unknown (Viète, 1615); none where it is no cubic, or at some point not all are real and apart."""
    if degree_in(equation, unknown) != 3:
        return []
    a, b, c, d = sympy.Poly(_top(equation), unknown).all_coeffs()
    middle = -b / (3 * a)
    slope = sympy.factor((3 * a * c - b**2) / (3 * a**2))
    start = sympy.factor((2 * b**3 - 9 * a * b * c + 27 * a**2 * d) / (27 * a**3))
    size = 2 * sympy.sqrt(-slope / 3)
    cosine = sympy.simplify(-4 * start / size**3)
    for point in points:
        value = at(cosine, point)
        if not (value.is_real and value.is_finite and abs(value) < 1):
            return []
    third = sympy.acos(cosine) / 3
    return [{unknown: middle + size * sympy.cos(third - 2 * sympy.pi * turn / 3)} for turn in range(3)]


def degree_in(equation: sympy.Expr, unknown: sympy.Symbol) -> int:
    """The degree of `equation` = 0 without its denominators; 0 where it is no polynomial in the unknown."""
    top = _top(equation)
    return int(sympy.Poly(top, unknown).degree()) if top.is_polynomial(unknown) else 0


def _top(equation: sympy.Expr) -> Any:
    return sympy.fraction(sympy.together(equation))[0]
