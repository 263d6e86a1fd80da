"""The slips that everybody makes: a sign, a factor, a power of ten, units, degrees for radians, components exchanged."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.answers.direction import DIRECTED, SIZE
from corollary.answers.expected import Values
from corollary.messages import N_, catalogue
from corollary.units.unit import ONE, Dimension, Unit

_ = catalogue(__name__)

# None of these says the factor: who may try again should find the reason, not multiply.
TEN = N_("The power of ten is off; check prefixes such as g and kg, ms and s.")
TEN_OF_RATIO = N_("The power of ten is off; check that what was divided had the same unit.")
TEN_OF_FORMULA = N_("a power of ten is off: look at the units")
CONSTANT = N_("A constant factor is wrong: look for halves, for squares, and for what happens twice.")
CONSTANT_OF_FORMULA = N_(
    "a constant factor is wrong: look for halves, for squares, and for what happens twice"
)
SIGN_AND_CONSTANT = N_("the sign and a constant factor are wrong")
ROOT = N_("a constant factor is wrong: look at what stands under a root")
SPEEDS = N_("km/h and m/s have been mixed.")
ENERGY, LENGTH = Dimension.of("kg m^2 s^-2"), Dimension.of("m")
OF_ROTATION = frozenset(map(Dimension.of, ("s^-1", "s^-2")))
WITH_DIRECTION = DIRECTED | {
    ENERGY,
    *map(
        Dimension.of,
        ("m", "kg m^2 s^-1", "s^-1", "s^-2", "A", "kg m s^-3 A^-1", "kg s^-2 A^-1"),
    ),
}
"""What may have a direction along a line or about an axis; an energy has none, a torque has."""
TORQUE = re.compile(r"N\W?m|m\W?N")
EXTENT = re.compile(
    r"\b(?:how (?:far|high|long|deep)|distance|length|height|radius|frequency|rate"
    r"|abstand|länge|höhe|frequenz|avstand|lengde|høyde|frekvens)\b",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class Ratio:
    """A factor that answers are often off by, and what it tells of a number and of a formula ("": nothing)."""

    factor: float
    number: str = ""
    formula: str = ""

    def of_number(self) -> str:
        """What the student reads."""
        return _(self.number)

    def of_formula(self) -> str:
        """What the student reads, in the middle of a sentence."""
        return _(self.formula)


RATIOS = (
    Ratio(-1.0, "", N_("the sign is the other way round")),
    Ratio(2.0, CONSTANT, CONSTANT_OF_FORMULA),
    Ratio(0.5, CONSTANT, CONSTANT_OF_FORMULA),
    Ratio(-2.0, "", SIGN_AND_CONSTANT),
    Ratio(-0.5, "", SIGN_AND_CONSTANT),
    Ratio(4.0, "", CONSTANT_OF_FORMULA),
    Ratio(0.25, "", CONSTANT_OF_FORMULA),
    Ratio(1e1, TEN),
    Ratio(1e-1, TEN),
    Ratio(1e2, TEN),
    Ratio(1e-2, TEN),
    Ratio(1e3, TEN, TEN_OF_FORMULA),
    Ratio(1e-3, TEN, TEN_OF_FORMULA),
    Ratio(1e4, TEN),
    Ratio(1e-4, TEN),
    Ratio(1e6, TEN),
    Ratio(1e-6, TEN),
    Ratio(math.pi / 180, "", N_("an angle was converted to radians once too often")),
    Ratio(180 / math.pi, "", N_("an angle is in degrees where radians are needed")),
    Ratio(2**0.5, "", ROOT),
    Ratio(0.5**0.5, "", ROOT),
    Ratio(
        3.6,
        SPEEDS,
        N_("a speed is in km/h where m/s is needed"),
    ),
    Ratio(
        1 / 3.6,
        SPEEDS,
        N_("a speed was converted from km/h once too often"),
    ),
)


def is_directed(unit: Unit) -> bool:
    """True of what points one way or the other wherever it is met: a velocity, a force, a torque; not of a length or an angle, which
    may be a position as well as a size."""
    if unit.dimension in OF_ROTATION:
        return "rad" in unit.text or "deg" in unit.text
    return has_direction(unit) and unit.dimension not in (LENGTH, ONE)


def has_direction(unit: Unit, title: str = "") -> bool:
    """True if a sign says which way: of a velocity or a force, not of an energy, a mass, a ratio, nor where the `title` asks for a
    speed or a magnitude."""
    if SIZE.search(title) or EXTENT.search(title):
        return False
    if unit.dimension == ENERGY:
        return TORQUE.search(unit.text) is not None
    return unit.dimension in WITH_DIRECTION or (unit.dimension == ONE and unit.text in {"rad", "deg"})


def slips(
    values: Values, unit: Unit, title: str = "", signed: Sequence[bool] = ()
) -> Iterator[tuple[Values, str]]:
    """What the values become by each slip that needs nothing but them, and what the student reads.

    `signed` says which of them have a sign to get wrong (empty: each). Of an angle no factor is a slip: halves, doubles and tenths
    of angles are what guessing tries.
    """
    signed = signed or (True,) * len(values)
    if any(values) and all(has for value, has in zip(values, signed, strict=True) if value):
        sign = _("The sign is wrong: ask what a positive and what a negative value would mean here.")
        if has_direction(unit, title):
            sign = (
                _("The sign is wrong: check which direction is positive.")
                if len(values) == 1
                else _(
                    "Every component has the wrong sign: check which way the axes point, or what acts on what."
                )
            )
        yield tuple(-x for x in values), sign
    if len(values) > 1:
        for place, value in enumerate(values):
            if value and signed[place]:
                turned = (*values[:place], -value, *values[place + 1 :])
                yield turned, _("The sign of one component is wrong.")
        if len(values) == 2 and values[0] != values[1]:
            yield (values[1], values[0]), _("The two components are interchanged.")
    if unit.dimension == ONE:
        degrees = _("That looks like degrees where radians are asked for; write the unit, as in 30 deg.")
        yield tuple(map(math.degrees, values)), degrees
        yield tuple(map(math.radians, values)), _("That looks like radians written as degrees.")
    if any(values) and not unit.is_angle:
        for ratio in RATIOS:
            if ratio.number:
                of_ratio = unit.dimension == ONE and ratio.number == TEN
                sentence = _(TEN_OF_RATIO) if of_ratio else ratio.of_number()
                yield tuple(ratio.factor * x for x in values), sentence


def common_factor(values: Values, right: Values) -> float:
    """The number by which all values are off; 1 where there is none."""
    index = max(range(len(right)), key=lambda place: abs(right[place]))
    factor = values[index] / right[index] if right[index] else 1.0
    alike = all(math.isclose(x, factor * y, rel_tol=1e-9) for x, y in zip(values, right, strict=True))
    return factor if alike else 1.0


def ratio_of_formulas(ratio: float, *, signed: bool = True) -> str:
    """What a constant ratio of the student's formula to the right one tells; "" where it tells nothing, as a sign does of what has
    none."""
    for known in RATIOS:
        if known.formula and (signed or known.factor > 0) and abs(ratio / known.factor - 1) < 1e-9:
            return known.of_formula()
    return _("a constant was rounded") if abs(ratio - 1) < 0.01 else ""
