"""Dimensions of quantities, in the seven base units of the SI."""

from __future__ import annotations

import math
from dataclasses import dataclass, field, fields
from fractions import Fraction
from operator import attrgetter

ZERO = Fraction(0)
DIFFERENCE = "delta_"  # how the name of a unit for differences of temperatures begins


@dataclass(frozen=True, slots=True)
class Dimension:
    """Powers of the base units; an angle has none. Fractions occur in contact constants (N/m^1.5)."""

    kg: Fraction = ZERO
    m: Fraction = ZERO
    s: Fraction = ZERO
    A: Fraction = ZERO
    K: Fraction = ZERO
    mol: Fraction = ZERO
    cd: Fraction = ZERO

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(*(a + b if b else a for a, b in zip(_all(self), _all(other), strict=True)))

    def __truediv__(self, other: Dimension) -> Dimension:
        return Dimension(*(a - b if b else a for a, b in zip(_all(self), _all(other), strict=True)))

    def __pow__(self, power: int | Fraction) -> Dimension:
        return Dimension(*(a * power if a else a for a in _all(self)))

    def powers(self) -> dict[str, Fraction]:
        """The powers that are not zero: {"kg": 1, "m": 1, "s": -2}."""
        return {name: power for name, power in zip(BASE, _all(self), strict=True) if power}

    @classmethod
    def of(cls, base_units: str) -> Dimension:
        """From a product of base units such as `kg m s^-2`; an empty text or `1` is a plain number. Raises ValueError."""
        found = ONE
        for factor in base_units.split():
            name, _, power = factor.partition("^")
            if name not in BASE and name != "1":
                raise ValueError(f"{base_units!r} is not a product of base units: use {', '.join(BASE)}")
            found = found * (cls(**{name: Fraction(power or 1)}) if name != "1" else ONE)
        return found


BASE = tuple(field.name for field in fields(Dimension))
ONE = Dimension()
_all = attrgetter(*BASE)


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit and its size: one of it is `factor` times pi**`pi` in SI (a degree is pi/180, a percent 1/100).

    `offset` is its zero in SI: 0 °C is 273.15 K. It counts where the unit stands alone, never in a product. `angle` is the power of
    a plane angle in it: 1 of rad/s, -1 of N m/rad, 2 of sr, which no dimension says.
    """

    text: str
    dimension: Dimension
    factor: Fraction = Fraction(1)
    pi: int = 0
    offset: Fraction = ZERO
    angle: Fraction = field(default=ZERO, compare=False)  # the text tells it

    @property
    def si(self) -> float:
        """Its size in SI as a double."""
        return float(self.factor) * math.pi**self.pi

    @property
    def bare(self) -> bool:
        """Whether a number in it is the number in SI."""
        return self.factor == 1 and not self.pi and not self.offset

    @property
    def is_angle(self) -> bool:
        """True for degrees, radians and their kin."""
        return self.dimension == ONE and self.angle == 1

    @property
    def is_pure(self) -> bool:
        """True for plain numbers: ratios, counts and shares, and no angles."""
        return self.dimension == ONE and not self.is_angle

    def measures(self, other: Unit) -> bool:
        """True if quantities in this unit are of the kind of those in the other. Radians may be left out, and stand in a product
        that has others (`rad^2 m/s^2`); a squared angle is no angle and no plain number."""
        if self.dimension != other.dimension:
            return False
        if self.angle in (0, other.angle):
            return True
        return not other.angle and (self.dimension != ONE or self.angle == 1)

    @property
    def is_difference(self) -> bool:
        """Whether it measures a difference of temperatures: 20 °C are then 20 K."""
        return self.text.startswith(DIFFERENCE)

    def to_si(self, number: Fraction) -> tuple[Fraction, int]:
        """A number of this unit in SI, exactly: a ratio, and a power of pi to multiply it with."""
        return number * self.factor + self.offset, self.pi

    def from_si(self, value: float) -> float:
        """A value in SI as a number of this unit."""
        return (value - float(self.offset)) / self.si


PURE = Unit("1", ONE)
