"""The unit to ask for a number in, so that an LMS that rounds what is typed to four decimals takes nothing away that counts."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.formula.errors import ParseError
from corollary.units.table import PREFIXES
from corollary.units.unit import Unit, read_unit, show

LEAST_REACH = 5e-3
"""A hundred times what rounding to four decimals can move: hardly anybody's mark hangs on it."""
LEAST, MOST = 0.1, 1e6
"""Between them a number is typed as it is, without an exponent."""
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


@dataclass(frozen=True, slots=True)
class TypedScale:
    """`power` of ten that one typed stands for, in the unit of the part; `text` is what is asked for: mN, or 10⁻³ kg m/s."""

    power: int
    text: str

    def typed(self, value: float) -> float:
        """What is typed for a value in the unit of the part."""
        return value / 10**self.power if self.power > 0 else value * 10**-self.power


def typed_scale(unit: Unit, values: Sequence[float], reach: float) -> TypedScale:
    """Powers are multiples of three, none for temperatures, whose unit has a zero of its own."""
    size = max(map(abs, values), default=0.0) or reach
    if unit.offset or (reach >= LEAST_REACH and LEAST <= size < MOST) or not size:
        return TypedScale(0, show(unit))
    power = 3 * math.floor(math.log10(size) / 3)
    while reach / 10.0**power < LEAST_REACH:
        power -= 3
    return TypedScale(
        power, _prefixed(unit, power) or f"10{str(power).translate(SUPERSCRIPTS)} {show(unit)}".strip()
    )


def _prefixed(unit: Unit, power: int) -> str:
    """The unit with a prefix, where one symbol has it; "" where none does."""
    wanted = float(unit.si) * 10.0**power
    symbol = unit.text
    for stem in (symbol, symbol[1:]):
        for prefix in PREFIXES:
            found = read_unit(prefix + stem) if stem else None
            if found is None or isinstance(found, ParseError) or found.dimension != unit.dimension:
                continue
            if math.isclose(float(found.si), wanted, rel_tol=1e-9) and found.text == prefix + stem:
                return show(found)
    return ""
