"""Vectors as they are typed: components in one unit or several, a length at an angle, two values around a middle."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from corollary.answers.components import are_axes, in_one_line, pieces_of, unread_side, without_preamble
from corollary.answers.doubts import TABLE
from corollary.answers.motion_words import motion_in_numbers
from corollary.answers.polar import length_and_angle
from corollary.answers.quantity import Reading, placed, read_quantity, reading_of
from corollary.answers.question import Question
from corollary.formula.by_hand import by_hand
from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.formula.numerals import LONGEST, TO_ASCII, Written
from corollary.messages import catalogue
from corollary.units.unit import Unit, show

_ = catalogue(__name__)

BOTH_SIGNS = re.compile(
    r"\s*\(?(?P<middle>[-+]?[0-9.,]+)\s*(?P<own>[°%A-Za-zµ][^±]*?)?\s*(?:±|\+/-|\+-)\s*(?P<half>[0-9.,]+)\)?\s*(?P<unit>[°%A-Za-zµ].*?)?\s*"
)


def read_quantities(
    text: str,
    expected: Unit | None,
    count: int,
    names: Sequence[str] = (),
    question: Question | None = None,
) -> tuple[Reading, ...] | ParseError:
    """A vector of `count` components: `(3, 4) m/s`, `[3; 4]`, `3 m/s; 4 m/s`, `3 i + 4 j`, in a plane `5 m/s at 30 deg`.

    With `names`, components that the text names (`p_y = 4, p_x = 3`) are put in their order.
    """
    pieces = components_in(text, count, names, expected, question)
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
            return _bare_beside_unit(found, expected) or tuple(found)


def _bare_beside_unit(found: Sequence[Reading], expected: Unit | None) -> ParseError | None:
    """What is asked about `894 mm, 1306` where metres are asked for: the number without a unit may be in either."""
    units = {each.unit.text: each.unit for each in found if each.unit is not None}
    bare = [each for each in found if each.unit is None and each.value]
    if expected is None or not bare or len(units) != 1:
        return None
    (unit,) = units.values()
    if unit.dimension != expected.dimension or unit.si == expected.si:
        return None
    choices = tuple(
        f"({'; '.join(each.as_read if each.unit or not each.value else f'{each.as_read} {show(its_unit)}' for each in found)})"
        for its_unit in (unit, expected)
    )
    why = _("{number} has no unit, but {other} has one", number=bare[0].as_read, other=show(unit))
    return ambiguous(why, None, *choices)


def components_in(
    text: str,
    count: int,
    names: Sequence[str] = (),
    expected: Unit | None = None,
    question: Question | None = None,
) -> list[str] | tuple[str, str] | ParseError:
    """The texts of the components, or those of a length and an angle; where angles are expected, two are no such vector."""
    if len(text) > LONGEST:
        return refused(_("this is longer than {most} characters", most=LONGEST), LONGEST)
    if TABLE.search(text):
        return refused(_("a table is not read here"), None, _("write the components as (3; 4) m/s"))
    typed = motion_in_numbers(by_hand(in_one_line(text, count)))
    normalized, skipped, sides = without_preamble(typed.translate(TO_ASCII))
    if (doubt := unread_side(sides, names, question, normalized)) is not None:
        return doubt
    if count == 2 and (both := BOTH_SIGNS.fullmatch(normalized)) is not None:  # `150° ± 90°`
        middle, half = both["middle"], both["half"]
        unit = both["unit"] or both["own"] or ""
        return [f"{middle} {both['own'] or unit} {sign} {half} {unit}" for sign in "-+"]
    polar = None if expected is not None and expected.is_angle else length_and_angle(normalized)
    if isinstance(polar, tuple) and not (count == 2 and are_axes(names)):
        return refused(_("a length and an angle give a vector in a plane only"))
    pieces = pieces_of(normalized, count, names, expected, question) if polar is None else polar
    return placed(pieces, skipped, rewritten=text != typed) if isinstance(pieces, ParseError) else pieces


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
        part = reading_of(its_length, number, length.unit, expected)
        if isinstance(part, ParseError):
            return part
        found.append(replace(part, polar=(length, angle)))
    return tuple(found)
