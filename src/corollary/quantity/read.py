"""A student's number and unit, read once and shown back: what it is in SI, and whether it is the kind of thing asked for."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from fractions import Fraction
from typing import Literal

from corollary.quantity.number import LONGEST, PLAIN, Written, decimal_text, scan_number
from corollary.quantity.trouble import Trouble, asked, refused, sentence
from corollary.quantity.unit import PURE, Unit, called, read_unit, show

REPEATED_LEFT = re.compile(r"\s*[^\W\d][^\s=≈+*/^();,]{0,15}\s*[=≈]")
DIRECTIONS = {"i": 0, "j": 1, "k": 2, "î": 0, "ĵ": 1, "k̂": 2, "x̂": 0, "ŷ": 1, "ẑ": 2}
ALONG = re.compile(r"(?P<letter>k̂|x̂|ŷ|ẑ|[îĵijk])(?=\s*(?:[+\-)]|$))|(?P<last>k̂|x̂|ŷ|ẑ|[îĵijk])\s+(?=\D)")
POLAR = re.compile(r"\s+at(?: an angle of)?\s+|\s*∠\s*", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class Reading:
    """A quantity as it was read. `unit` is None when none was written.

    `si` is the value in SI as a ratio times a power of pi, a bare number taken in the expected unit; `fit` compares it with
    what was expected, and `why` says what is amiss ("" when it fits); `shown` is what the student sees: `8.6 N s`.
    """

    text: str
    value: Fraction
    figures: int
    least: int
    unit: Unit | None
    si: tuple[Fraction, int]
    fit: Literal["fits", "wrong dimension", "unit missing"]
    why: str
    shown: str


def read_quantity(text: str, expected: Unit | None) -> Reading | Trouble:
    """The number and unit a text stands for. Without `expected` every unit fits, and none is missing."""
    if len(text) > LONGEST:
        return refused(f"this is longer than {LONGEST} characters", LONGEST)
    plain, skipped = _without_left(text.translate(PLAIN))
    found = scan_number(plain)
    if isinstance(found, Trouble):
        return _moved(found, skipped)
    number, end = found
    rest = plain[end:].strip().rstrip(".")
    if not rest:
        return _reading(text, number, None, expected)
    at = skipped + end + plain[end:].index(rest[0])
    if rest[0] in "+-" or (rest[0] in "0123456789" and not re.match(r"1\s*/", rest)):
        return refused("one number is enough here", at, "work it out and write a number and a unit")
    unit = read_unit(rest.lstrip("*").strip())
    if isinstance(unit, Trouble):
        return _moved(unit, at)
    return _reading(text, number, unit, expected)


def in_si(reading: Reading) -> float:
    """The value in SI as the nearest double but one."""
    ratio, pi = reading.si
    return float(ratio) * math.pi**pi


def describe(reading: Reading | Trouble) -> str:
    """One line for the student: `read as 8.6 N s`, or what to do."""
    if isinstance(reading, Trouble):
        return f"not read: {sentence(reading)}"
    return f"read as {reading.shown}" + (f": {reading.why}" if reading.why else "")


def read_quantities(text: str, expected: Unit | None, count: int) -> tuple[Reading, ...] | Trouble:
    """A vector of `count` components: `(3, 4) m/s`, `[3; 4]`, `3 m/s; 4 m/s`, `3 i + 4 j`, in a plane `5 m/s at 30 deg`."""
    if len(text) > LONGEST:
        return refused(f"this is longer than {LONGEST} characters", LONGEST)
    plain, skipped = _without_left(text.translate(PLAIN))
    if POLAR.search(plain):
        return _polar(plain, expected) if count == 2 else refused("a length and an angle give a vector in a plane only")
    pieces = _directed(plain, count) if ALONG.search(plain) else _listed(plain, skipped, count)
    if isinstance(pieces, Trouble):
        return pieces
    found = []
    for piece in pieces:
        reading = read_quantity(piece, expected)
        if isinstance(reading, Trouble):
            start = plain.find(piece)
            return _moved(reading, skipped + start) if start >= 0 else refused(reading.why, None, reading.suggestion)
        found.append(reading)
    return tuple(found)


def _reading(text: str, number: Written, unit: Unit | None, expected: Unit | None) -> Reading | Trouble:
    size = unit or expected or PURE
    ratio = number.value * size.factor
    if ratio and not Fraction(10) ** -305 < abs(ratio) < Fraction(10) ** 305:
        return refused("this quantity is too large or too small to be meant")
    shown = f"{decimal_text(number.value, number.figures)}{_space(unit)}{show(unit) if unit else ''}"
    fit, why = "fits", ""
    plain = expected is None or (expected.dimension, expected.factor, expected.pi) == (PURE.dimension, 1, 0)  # as 1 and rad are
    if expected is not None and unit is None and number.value and not plain:  # 0 is 0 in every unit
        fit, why = "unit missing", f"the unit is missing; write for example {shown} {show(expected)}"
    elif expected is not None and size.dimension != expected.dimension:
        sort = f"{called(expected.dimension)} is expected" + (f", for example in {show(expected)}" if show(expected) else "")
        fit, why = "wrong dimension", f"{sort}; {shown} is {called(size.dimension)}"
    return Reading(text, number.value, number.figures, number.least, unit, (ratio, size.pi), fit, why, shown)


def _space(unit: Unit | None) -> str:
    return "" if unit is None or unit.text == "deg" else " "


def _without_left(plain: str) -> tuple[str, int]:
    """The text after a repeated `p =`, and how much was left out."""
    left = REPEATED_LEFT.match(plain)
    return (plain[left.end() :], left.end()) if left else (plain, 0)


def _moved(trouble: Trouble, by: int) -> Trouble:
    position = None if trouble.position is None else trouble.position + by
    return Trouble(trouble.status, trouble.why, position, trouble.suggestion, trouble.choices)


def _unwrapped(plain: str) -> tuple[str, str] | None:
    """What stands in the outer brackets, and the unit behind them; None without brackets."""
    found = re.fullmatch(r"\s*[(\[](?P<inside>[^()\[\]]*)[)\]]\s*(?P<unit>[^0-9]?.*)", plain, re.DOTALL)
    return (found["inside"], found["unit"].strip()) if found else None


def _listed(plain: str, skipped: int, count: int) -> list[str] | Trouble:
    inside, unit = _unwrapped(plain) or (plain, "")
    tries = (";",) if ";" in inside else (r",\s+", ",", r"(?<=[0-9])\s+(?=[+\-]?[0-9])")
    splits = [re.split(mark, inside) for mark in tries]
    pieces = next((pieces for pieces in splits if len(pieces) == count), None)
    if pieces is None and ";" not in inside and any(len(each) == 2 * count for each in splits):
        return asked("the commas can part the components or be decimal commas", skipped, "(1.5; 2.5)", "(1,5; 2,5)")
    if pieces is None:
        return refused(f"{count} components are expected", skipped, "write them as (3; 4) m/s")
    behind = re.fullmatch(r"[^A-Za-z°%]*?([A-Za-z°%].*)", pieces[-1].strip())
    if not unit and behind and not re.search(r"[^\W\d_]", "".join(pieces[:-1]).replace("e", "")):
        pieces[-1], unit = pieces[-1].strip().removesuffix(behind[1]), behind[1]  # `3; 4 m/s`: one unit for all
    return [f"{piece.strip()} {unit}".strip() for piece in pieces]


def _directed(plain: str, count: int) -> list[str] | Trouble:
    """`3 i - 4 j` cut at its directions; a direction left out is 0."""
    inside, unit = _unwrapped(plain) or (plain, "")
    components: dict[int, str] = {}
    at = 0
    for found in ALONG.finditer(inside):
        letter = found["letter"] or found["last"]
        piece = re.sub(r"^\s*([+-]?)\s*", r"\1", inside[at : found.start()]).strip().rstrip("*").strip()
        axis = DIRECTIONS[letter]
        if axis in components or axis >= count:
            return refused(f"{letter} does not belong here", None, "write one term for each direction, such as 3 i + 4 j")
        components[axis] = piece + "1" if piece in ("", "+", "-") else piece
        at = found.end()
    unit = unit or inside[at:].strip()
    units = [re.sub(r"^[+-]?[0-9.,e ]*", "", piece) for piece in components.values()] if not unit else [unit]
    missing = f"0 {units[0]}".strip()
    return [f"{components[axis]} {unit}".strip() if axis in components else missing for axis in range(count)]


def _polar(plain: str, expected: Unit | None) -> tuple[Reading, ...] | Trouble:
    """A length and the angle above the first axis. The components are doubles: a student's own digits are fewer."""
    pieces = POLAR.split(plain)
    if len(pieces) != 2:
        return refused("a length and one angle are expected", None, "write for example 5 m/s at 30 deg")
    length, angle = read_quantity(pieces[0], expected), read_quantity(pieces[1], None)
    if isinstance(length, Trouble):
        return length
    if isinstance(angle, Trouble):
        return refused(f"the angle: {angle.why}", None, angle.suggestion)
    if angle.unit is None or angle.unit.text not in ("deg", "rad", "mrad"):
        return refused("the angle needs its unit", None, "write for example 5 m/s at 30 deg")
    ratio, pi = angle.si
    right = {0: (1, 0), Fraction(1, 2): (0, 1), 1: (-1, 0), Fraction(3, 2): (0, -1)}.get(ratio % 2) if pi else None
    turn = float(ratio % 2) * math.pi if pi else float(ratio)
    shares = right or (math.cos(turn), math.sin(turn))
    figures = max(3, min(length.figures, angle.figures))
    found = []
    for share in shares:
        number = Written(length.value * Fraction(share), figures, min(figures, length.least))
        part = _reading(plain, number, length.unit, expected)
        if isinstance(part, Trouble):
            return part
        found.append(part)
    return tuple(found)
