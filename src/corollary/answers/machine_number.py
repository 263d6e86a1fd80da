"""Numbers that a student's program calculated, in the unit asked for, with the figures that they show."""

from __future__ import annotations

import math
from fractions import Fraction

from corollary.answers.answer import Numbers, Unclear
from corollary.formula.numerals import decimal_text
from corollary.messages import catalogue
from corollary.units.unit import Unit, show

_ = catalogue(__name__)

# A number whose shortest form has more digits than this was calculated, not typed: its digits are no claim of figures.
MOST_TYPED = 4
LARGEST_COUNTED = 10**9
LARGEST_IN_FULL = 10**12


def machine(value: float, unit: Unit) -> Numbers | Unclear:
    """A double."""
    if math.isnan(value):
        return Unclear(_("the result is not a number"), str(value))
    if math.isinf(value):
        return Unclear(_("the result is infinite"), str(value))
    digits = len(repr(value).replace(".", "").lstrip("-0").partition("e")[0].rstrip("0"))
    if value and value == int(value):
        digits = sure(digits, len(f"{abs(value):.0f}"))
    most = (2,) if digits == 1 else ()  # `0.20` is 0.2 for Python
    return Numbers(
        (value * unit.si + float(unit.offset),),
        (_typed(digits),),
        _with_unit(f"{value:.6g}", unit),
        most=most,
    )


def exact(value: Fraction, unit: Unit) -> Numbers:
    """A whole number or a fraction; one beyond all doubles is a number all the same, and wrong."""
    try:
        ratio, pi = unit.to_si(value)
        number = float(ratio) * math.pi**pi
    except OverflowError:
        number = math.inf if value > 0 else -math.inf
        return Numbers((number,), (0,), _("a number too large to show"))
    whole = str(abs(value.numerator)) if value.denominator == 1 and abs(value) < LARGEST_COUNTED else ""
    digits = sure(len(whole.rstrip("0")), len(whole)) if value else 0
    as_read = decimal_text(value, 6)
    if value.denominator == 1:
        as_read = str(value) if abs(value) < LARGEST_IN_FULL else f"{float(value):.6g}"
    return Numbers((number,), (_typed(digits),), _with_unit(as_read, unit))


def sure(least: int, most: int) -> int:
    """How many figures a number shows: zeros at the end of a whole number count as far as two, so 200 is 0.20 thousand."""
    return max(least, min(most, 2))


def _typed(digits: int) -> int:
    return digits if digits <= MOST_TYPED else 0


def _with_unit(number: str, unit: Unit) -> str:
    name = show(unit)
    return f"{number} {name}" if name not in {"", "1"} else number
