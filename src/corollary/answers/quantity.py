"""A student's number and unit, read once and shown back: what it is in SI, and whether it is the kind of thing asked for."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Literal

from corollary.answers.arithmetic_answer import worked_out
from corollary.answers.components import are_axes, in_one_line, pieces_of, without_preamble
from corollary.answers.motion_words import motion_in_number, motion_in_numbers
from corollary.answers.number_words import in_digits
from corollary.answers.polar import length_and_angle
from corollary.answers.preamble import SIDES, answer_in
from corollary.answers.spread import WIDEST, in_brackets, without_spread
from corollary.answers.unit_meant import unit_meant
from corollary.formula.by_hand import by_hand
from corollary.formula.errors import ParseError, refused
from corollary.formula.numerals import LONGEST, TO_ASCII, Written, decimal_text, scan_number
from corollary.messages import catalogue, in_convention
from corollary.units.unit import ONE, PURE, Unit, called, show

_ = catalogue(__name__)

MOST_SIDES = 5
ROUND = str.maketrans("[]{}", "()()")
TABLE = re.compile(r"^\s*\|[^|]*\|[^|]+\|\s*$|\|\s*:?-{3,}", re.MULTILINE)  # of Markdown
TWICE = re.compile(
    r"\s*([^()=]*[^()=\s])\s*(?:\(|[,;]\s*(?:or|i\.e\.|that is)\s)\s*=?\s*([^()=]*[^()=\s])\s*\)?\s*"
)


@dataclass(frozen=True, slots=True)
class Reading:
    """A quantity as it was read. `unit` is None when none was written.

    `si` is the value in SI as a ratio times a power of pi, a bare number taken in the expected unit; `fit` compares it with
    what was expected, and `why` says what is amiss ("" when it fits); `as_read` is what the student sees: `8.6 N s`.
    `polar` are the length and the angle that this is a component of, where the vector was written so.
    """

    text: str
    value: Fraction
    figures: int
    least: int
    unit: Unit | None
    si: tuple[Fraction, int]
    fit: Literal["fits", "wrong dimension", "unit missing"]
    why: str
    as_read: str
    polar: tuple[Reading, Reading] | None = None


def read_quantity(text: str, expected: Unit | None) -> Reading | ParseError:
    """The number and unit a text stands for, or the calculation left standing in it. Without `expected` every unit fits."""
    if len(text) > LONGEST:
        return refused(_("this is longer than {most} characters", most=LONGEST), LONGEST)
    typed = motion_in_number(by_hand(text))
    normalized, skipped = answer_in(typed.translate(TO_ASCII))
    if asked := in_brackets(normalized):
        return _placed(asked, skipped, rewritten=text != typed)
    if TABLE.search(typed):
        return refused(_("a table is not read here"), None, _("write one number and a unit"))
    normalized, spread = without_spread(normalized)
    found = _alone(text, normalized, expected)
    if isinstance(found, ParseError):
        return _placed(found, skipped, rewritten=text != typed)
    if skipped and (other := _otherwise(typed.translate(TO_ASCII)[:skipped], found, expected)):
        why = _("{one} and {other} are not the same", one=other.as_read, other=found.as_read)
        return refused(why, None, _("write one number and a unit"))
    if spread and not _is_small(spread, found):
        why = _("an uncertainty of more than a tenth leaves the value open")
        return refused(why, None, _("write one number and a unit"))
    return found


def _alone(text: str, normalized: str, expected: Unit | None) -> Reading | ParseError:
    """The number, the calculation, or the number said twice, that a text is without what stands around it."""
    normalized = in_digits(normalized, pure=expected is not None and expected.dimension == ONE)
    found = _number_and_unit(text, normalized, expected)
    twice = _same_twice(normalized, expected) if isinstance(found, ParseError) else None
    if twice is not None:
        return twice
    if (
        isinstance(found, ParseError)
        and found.status == "refused"
        and not isinstance(worked := _worked(text, normalized, expected), ParseError)
    ):
        return worked
    return found


def _is_small(spread: str, found: Reading) -> bool:
    """Whether an uncertainty is at most a tenth of the value: in the value's unit, in one of its own, or in percent."""
    size = _number_and_unit(spread, spread, found.unit)
    if isinstance(size, ParseError):
        return False
    if size.unit is None or size.unit == found.unit:
        return size.value <= WIDEST * abs(found.value)
    if size.unit.text == "%":
        return size.value <= 100 * WIDEST
    return size.fit == "fits" and in_si(size) <= WIDEST * abs(in_si(found))


def _otherwise(before: str, last: Reading, expected: Unit | None) -> Reading | None:
    """A side before the last that is a quantity of its own, and not the same: `9 N = 8.6 N`."""
    sides = (_number_and_unit(side, side, expected) for side in SIDES.split(before)[-MOST_SIDES:])
    given = (
        side
        for side in sides
        if isinstance(side, Reading) and side.unit is not None and last.unit is not None
    )
    return next(
        (
            side
            for side in given
            if side.fit == last.fit and not math.isclose(in_si(side), in_si(last), rel_tol=0.05)
        ),
        None,
    )


def _same_twice(normalized: str, expected: Unit | None) -> Reading | ParseError | None:
    """`0.4 (40 %)`, `20 m/s (72 km/h)`: the first of the two, when both say the same; it is refused when they do not."""
    both = TWICE.fullmatch(normalized)
    if both is None:
        return None
    first, second = (
        found
        if isinstance(found := _number_and_unit(each, each, expected), Reading)
        else _worked(each, each, expected)
        for each in both.groups()
    )
    if (
        isinstance(first, ParseError)
        or isinstance(second, ParseError)
        or first.fit != "fits"
        or second.fit != "fits"
    ):
        return None
    if math.isclose(in_si(first), in_si(second), rel_tol=0.01):
        return first
    if first.unit is None or second.unit is None:
        return None
    why = _("{one} and {other} are not the same", one=first.as_read, other=second.as_read)
    return refused(why, None, _("write one number and a unit"))


def _number_and_unit(text: str, normalized: str, expected: Unit | None) -> Reading | ParseError:
    found = scan_number(normalized)
    if isinstance(found, ParseError):
        return found
    number, end = found
    rest = normalized[end:].strip().rstrip(".")
    if not rest:
        return _reading(text, number, None, expected)
    at = end + normalized[end:].index(rest[0])
    if rest[0] in "+-" or (rest[0] in "0123456789" and not re.match(r"1\s*/", rest)):
        return refused(_("one number is enough here"), at, _("work it out and write a number and a unit"))
    unit = unit_meant(rest.lstrip("*").strip(), expected)
    return unit.moved(at) if isinstance(unit, ParseError) else _reading(text, number, unit, expected)


def _worked(text: str, normalized: str, expected: Unit | None) -> Reading | ParseError:
    found = worked_out(normalized.translate(ROUND))
    if isinstance(found, ParseError):
        return found
    number = Written(Fraction(f"{found.value:.15g}"), 0, 0)
    return _reading(text, number, found.unit, expected, decimal_text(Fraction(f"{found.value:.6g}"), 0))


def in_si(reading: Reading) -> float:
    """The value in SI as the nearest double but one."""
    ratio, pi = reading.si
    return float(ratio) * math.pi**pi


def _placed(error: ParseError, skipped: int, *, rewritten: bool) -> ParseError:
    """The error at its place in what was typed, before which `skipped` characters were left out; at none in TeX rewritten."""
    return error.without_place() if rewritten else error.moved(skipped)


def read_quantities(
    text: str, expected: Unit | None, count: int, names: Sequence[str] = ()
) -> tuple[Reading, ...] | ParseError:
    """A vector of `count` components: `(3, 4) m/s`, `[3; 4]`, `3 m/s; 4 m/s`, `3 i + 4 j`, in a plane `5 m/s at 30 deg`.

    With `names`, components that the text names (`p_y = 4, p_x = 3`) are put in their order.
    """
    pieces = components_in(text, count, names)
    match pieces:
        case ParseError():
            return pieces
        case tuple():
            return _polar(*pieces, expected)
        case list():
            found: list[Reading] = []
            for piece in pieces:
                reading = read_quantity(piece, expected)
                if isinstance(reading, ParseError):
                    start = text.find(piece)
                    return reading.moved(start) if start >= 0 else reading.without_place()
                found.append(reading)
            return tuple(found)


def components_in(
    text: str, count: int, names: Sequence[str] = ()
) -> list[str] | tuple[str, str] | ParseError:
    """The texts of the components, or those of a length and an angle."""
    if len(text) > LONGEST:
        return refused(_("this is longer than {most} characters", most=LONGEST), LONGEST)
    if TABLE.search(text):
        return refused(_("a table is not read here"), None, _("write the components as (3; 4) m/s"))
    typed = motion_in_numbers(by_hand(in_one_line(text, count)))
    normalized, skipped = without_preamble(typed.translate(TO_ASCII))
    polar = length_and_angle(normalized)
    if isinstance(polar, tuple) and not (count == 2 and are_axes(names)):
        return refused(_("a length and an angle give a vector in a plane only"))
    pieces = pieces_of(normalized, count, names) if polar is None else polar
    return _placed(pieces, skipped, rewritten=text != typed) if isinstance(pieces, ParseError) else pieces


def _reading(
    text: str, number: Written, unit: Unit | None, expected: Unit | None, digits: str = ""
) -> Reading | ParseError:
    size = unit or expected or PURE
    if size.offset and expected is not None and expected.is_difference:
        size = replace(size, offset=Fraction(0))
    ratio, pi = size.to_si(number.value)
    if ratio and not Fraction(10) ** -305 < abs(ratio) < Fraction(10) ** 305:
        return refused(_("this quantity is too large or too small to be meant"))
    as_read = (
        f"{digits or decimal_text(number.value, number.figures)}{_space(unit)}{show(unit) if unit else ''}"
    )
    fit, why = "fits", ""
    pure = expected is None or (expected.dimension == ONE and expected.bare)  # 1 and rad are
    zero = not number.value and not size.offset  # 0 is 0 in every unit, but for a temperature
    if expected is not None and unit is None and not zero and not pure:
        fit = "unit missing"
        why = _(
            "the unit is missing; write for example {example}",
            example=in_convention(f"{as_read} {show(expected)}"),
        )
    elif expected is not None and size.dimension != expected.dimension:
        fit, why = "wrong dimension", _misfit(as_read, size, expected)
    return Reading(text, number.value, number.figures, number.least, unit, (ratio, pi), fit, why, as_read)


def _misfit(as_read: str, size: Unit, expected: Unit) -> str:
    wanted, found, example = called(expected.dimension), called(size.dimension), show(expected)
    if not example:
        return _(
            "{wanted} is expected; {as_read} is {found}",
            wanted=wanted,
            as_read=in_convention(as_read),
            found=found,
        )
    return _(
        "{wanted} is expected, for example in {example}; {as_read} is {found}",
        wanted=wanted,
        example=example,
        as_read=in_convention(as_read),
        found=found,
    )


def _space(unit: Unit | None) -> str:
    return "" if unit is None or unit.text == "deg" else " "


def _polar(its_length: str, its_angle: str, expected: Unit | None) -> tuple[Reading, ...] | ParseError:
    """A length and the angle above the first axis. The components are doubles: a student's own digits are fewer."""
    length, angle = read_quantity(its_length, expected), read_quantity(its_angle, None)
    if isinstance(length, ParseError):
        return length
    if isinstance(angle, ParseError):
        return refused(_("the angle: {why}", why=angle.why), None, angle.suggestion)
    if angle.unit is None or angle.unit.text not in ("deg", "rad", "mrad"):
        return refused(_("the angle needs its unit"), None, _("write for example 5 m/s at 30 deg"))
    ratio, pi = angle.si
    right = (
        {0: (1, 0), Fraction(1, 2): (0, 1), 1: (-1, 0), Fraction(3, 2): (0, -1)}.get(ratio % 2)
        if pi
        else None
    )
    turn = float(ratio % 2) * math.pi if pi else float(ratio)
    shares = right or (math.cos(turn), math.sin(turn))
    figures = max(3, min(length.figures, angle.figures))
    found: list[Reading] = []
    for share in shares:
        number = Written(length.value * Fraction(share), figures, min(figures, length.least))
        part = _reading(its_length, number, length.unit, expected)
        if isinstance(part, ParseError):
            return part
        found.append(replace(part, polar=(length, angle)))
    return tuple(found)
