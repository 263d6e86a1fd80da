"""Whether two formulas are the same function, by the identity of polynomials: a proof, and not a comparison at points."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from corollary.formula.ast import Expr
from corollary.formula.errors import Undefined
from corollary.polynomials.polynomial import TooLarge
from corollary.polynomials.translate import Translation


def identical(one: Expr, other: Expr, domain: Mapping[str, tuple[float, float]]) -> bool | None:
    """True: the same wherever both have values. False: quotients of polynomials, and not the same. None: not decided this way.

    `domain` has bounds of the letters in SI, by which the root of a square is what was squared. pi counts as a letter, which
    is right, for no polynomial with fractions vanishes at it.
    """
    bounds = {name: (Fraction(low), Fraction(high)) for name, (low, high) in domain.items()}
    try:
        translation = Translation((one, other), bounds)
        gap = translation.fraction(one) - translation.fraction(other)
    except (TooLarge, Undefined, KeyError):
        return None
    if gap.top.is_zero():
        return True
    return None if translation.meanings else False
