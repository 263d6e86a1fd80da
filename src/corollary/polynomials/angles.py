"""Sines and cosines of sums and multiples as polynomials in those of the angles they are made of."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any, Protocol

from corollary.polynomials.polynomial import TooLarge
from corollary.polynomials.rational_function import RationalFunction
from corollary.polynomials.signs import Bounds, Signs

MOST_MULTIPLES = 8
POSITIVE: Bounds = (Fraction(0), None)


class LetterMaker(Protocol):
    """What makes a letter, and holds what is true of it."""

    known: Signs
    relations: list[Any]

    def number(self, value: Fraction) -> RationalFunction: ...
    def made(self, meaning: tuple[object, ...], bounds: Bounds = ...) -> tuple[RationalFunction, bool]: ...


class Angles:
    """An angle is taken apart into terms; the sine and the cosine of each (of its half, when `parts` is 2) get a letter."""

    def __init__(self, letters: LetterMaker, parts: int) -> None:
        self._letters, self._parts = letters, parts

    def of(self, function: str, angle: RationalFunction) -> RationalFunction:
        """sin or cos of an angle. Raises TooLarge for a multiple that is too high."""
        cosine, sine = self._letters.number(Fraction(1)), self._letters.number(Fraction(0))
        for coefficient, term in _terms(angle):
            more_cosine, more_sine = self._term(coefficient, term)
            cosine, sine = (
                cosine * more_cosine - sine * more_sine,
                sine * more_cosine + cosine * more_sine,
            )
        return sine if function == "sin" else cosine

    def _term(
        self, coefficient: Fraction, term: RationalFunction
    ) -> tuple[RationalFunction, RationalFunction]:
        name = str(term.top) if term.bottom.is_one() else ""
        if name == "pi" and (2 * coefficient).denominator == 1:
            quarter = int(2 * coefficient) % 4
            return tuple(self._letters.number(Fraction((1, 0, -1, 0)[(quarter - up) % 4])) for up in (0, 1))  # type: ignore[return-value]
        multiple = coefficient * self._parts
        if multiple.denominator > 1:
            return self._letter("cos", coefficient, term, ""), self._letter("sin", coefficient, term, "")
        if abs(multiple) > MOST_MULTIPLES:
            raise TooLarge
        base = Fraction(1, self._parts)
        one = self._letter("cos", base, term, name), self._letter("sin", base, term, name)
        cosine, sine = self._letters.number(Fraction(1)), self._letters.number(Fraction(0))
        for _again in range(abs(int(multiple))):
            cosine, sine = cosine * one[0] - sine * one[1], sine * one[0] + cosine * one[1]
        return cosine, (-sine if multiple < 0 else sine)

    def _letter(
        self, function: str, coefficient: Fraction, term: RationalFunction, name: str
    ) -> RationalFunction:
        low, high = self._letters.known.get(name, (None, None))
        acute = low is not None and high is not None and low > 0 and float(coefficient * high) < math.pi / 2
        bounds = POSITIVE if acute else (None, None)
        key = str(coefficient), str(term)
        cosine, new = self._letters.made(("cos", *key), bounds)
        sine, _ = self._letters.made(("sin", *key), bounds)
        if new:
            one = self._letters.number(Fraction(1))
            self._letters.relations.append((cosine * cosine + sine * sine - one).top)
        return sine if function == "sin" else cosine


def _terms(angle: RationalFunction) -> list[tuple[Fraction, RationalFunction]]:
    """The angle as a sum of multiples; as one where something stands below the line."""
    top, bottom = angle.top, angle.bottom
    if not bottom.is_constant():
        content, primitive = top.primitive() if not top.is_zero() else (0, top)
        return [(Fraction(int(content)), RationalFunction(primitive, bottom))]
    below, context = int(bottom.coeffs()[0]), top.context()
    return [
        (
            Fraction(int(coefficient), below),
            RationalFunction(context.term(coeff=1, exp_vec=exponents), context.constant(1)),
        )
        for exponents, coefficient in top.to_dict().items()
    ]
