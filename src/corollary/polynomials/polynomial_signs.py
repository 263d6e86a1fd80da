"""Signs of polynomials: bounds of the letters, and which polynomials therefore are never zero."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from corollary.polynomials.polynomial import Polynomial

Bounds = tuple[Fraction | None, Fraction | None]
"""The least and the largest value a letter has; None: no bound. (0, None) is a letter that is positive, never zero."""


def sign_of(bounds: Bounds) -> int:
    """1 or -1 of a letter that has one sign, 0 of one that may have either or be zero."""
    low, high = bounds
    if low is not None and (low > 0 or (low == 0 and high is None)):
        return 1
    if high is not None and (high < 0 or (high == 0 and low is None)):
        return -1
    return 0


class Signs(dict[str, Bounds]):
    """The bounds of letters by their names; a letter is given its own before any polynomial with it is asked about."""

    def __init__(self, bounds: Mapping[str, Bounds]) -> None:
        super().__init__(bounds)
        self._found: dict[str, int] = {}

    def of(self, polynomial: Polynomial) -> int:
        """1 or -1 of a polynomial that has one sign wherever the letters lie within their bounds; 0 where that is not known."""
        written = str(polynomial)  # it has no hash
        if written not in self._found:
            self._found[written] = self._sign(polynomial)
        return self._found[written]

    def _sign(self, polynomial: Polynomial) -> int:
        terms = [
            (tuple(map(int, exponents)), int(coefficient))
            for exponents, coefficient in polynomial.to_dict().items()
        ]
        bounds = [self.get(name, (None, None)) for name in polynomial.context().names()]
        return _by_terms(terms, list(map(sign_of, bounds))) or _by_bounds(terms, bounds)


def _by_terms(terms: list[tuple[tuple[int, ...], int]], signs: list[int]) -> int:
    """The sign that all terms share; squares of letters without a sign may vanish, but not all terms."""
    shared, certain = 0, False
    for exponents, coefficient in terms:
        own = 1 if coefficient > 0 else -1
        strict = True
        for exponent, letter in zip(exponents, signs, strict=True):
            if not exponent:
                continue
            if letter:
                own *= letter if exponent % 2 else 1
            elif exponent % 2:
                return 0
            else:
                strict = False
        if shared and own != shared:
            return 0
        shared, certain = own, certain or strict
    return shared if certain else 0


def _by_bounds(terms: list[tuple[tuple[int, ...], int]], bounds: list[Bounds]) -> int:
    """The sign of all values between the bounds, each term taken on its own."""
    low = high = Fraction(0)
    for exponents, coefficient in terms:
        least = most = Fraction(coefficient)
        for exponent, (below, above) in zip(exponents, bounds, strict=True):
            if not exponent:
                continue
            if below is None or above is None:
                return 0
            ends = [below**exponent, above**exponent]
            if exponent % 2 == 0 and below < 0 < above:
                ends.append(Fraction(0))
            corners = [end * side for end in (min(ends), max(ends)) for side in (least, most)]
            least, most = min(corners), max(corners)
        low, high = low + least, high + most
    return 1 if low > 0 else -1 if high < 0 else 0
