"""A variable that formulas are asked of, such as the time in U(t): its unit and its domain; no number is ever dealt for it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from fractions import Fraction

from corollary.formula.rational_pi import RationalPi
from corollary.units.unit import Unit, show

PLACES = 20  # of the domain: formulas are tried at the inner ones
PRINTED, STRIDE = 8, 7
"""The place for the printed numbers, and how far it is from one variant's place to the next one's: without a common factor."""


@dataclass(frozen=True, slots=True)
class Variable:
    """`first` and `last` are the ends of the domain, in the variable's own unit; `above`: the first end does not belong to it."""

    symbol: str
    meaning: str
    unit: Unit
    first: Fraction
    last: Fraction
    above: bool
    line: int

    def value(self, index: int | None) -> RationalPi:
        """A value in SI within the domain, at which the formulas of a variant are tried; one after the other over all of it."""
        place = PRINTED if index is None else 1 + (PRINTED + STRIDE * (index + 1)) % (PLACES - 1)
        return RationalPi(*self.unit.to_si(self.first + (self.last - self.first) * Fraction(place, PLACES)))

    @property
    def ends(self) -> tuple[float, float]:
        """The ends of the domain in SI."""
        pairs = (self.unit.to_si(end) for end in (self.first, self.last))
        low, high = (float(ratio) * math.pi**pi for ratio, pi in pairs)
        return low, high

    @property
    def domain(self) -> str:
        """As it is printed: `0 < t ≤ 10 s`."""
        low, high = (f"{float(end):.6g}".replace("-", "−") for end in (self.first, self.last))
        symbol = show(self.unit)
        return f"{low} {'<' if self.above else '≤'} {self.symbol} ≤ {high} {symbol}".rstrip()
