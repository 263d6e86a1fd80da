"""The unit that a student means, where what is asked for decides between readings: `ms^-1`, `kgs`, `KG M/S`, `km/H`."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from itertools import product

from corollary.formula.errors import ParseError
from corollary.messages import catalogue
from corollary.units.table import UNITS, UNSUGGESTED
from corollary.units.unit import Unit, called, read_unit, show

_ = catalogue(__name__)

MOST_SPELLINGS = 32
WORD = re.compile(r"[A-Za-z]+")
PLURAL = re.compile(r"(?<![A-Za-z])[Kk]gs(?![A-Za-z])")
UNIT_TWICE = re.compile(r"([^()]*[^()\s])\s*\(([^()]*)\)")
METRES = re.compile(r"(?<![A-Za-z])ms(?=\s?[\^⁻*-])")


def unit_meant(text: str, expected: Unit | None) -> Unit | ParseError:
    """The unit; where it has several readings, as `ms^-1` or `Ns (newton seconds)`, the one that measures what is asked for."""
    unit = read_unit(text)
    if expected is None or (isinstance(unit, Unit) and unit.dimension == expected.dimension):
        return unit
    if isinstance(unit, Unit) and (slip := _slip_of_case(text, unit, expected)) is not None:
        return slip
    if isinstance(unit, ParseError) and unit.status == "refused" and (meant := _in_capitals(text, expected)):
        return meant
    twice = UNIT_TWICE.fullmatch(text)
    meanings = (
        (*unit.choices, METRES.sub("m s", text))
        if isinstance(unit, ParseError)
        else twice.groups()
        if twice
        else (PLURAL.sub("kg", text),)
    )
    fitting = [
        each
        for each in map(read_unit, meanings)
        if isinstance(each, Unit) and each.dimension == expected.dimension
    ]
    if twice:
        return fitting[0] if len(fitting) == 2 else unit
    return fitting[0] if len({each.factor for each in fitting}) == 1 else unit


def _in_capitals(text: str, expected: Unit) -> Unit | None:
    """`KG M/S`, `w`: the one unit of what is asked for that these letters are, small and capital apart; None for `MS` and `MM`."""
    spelled = [[known for known in UNITS if known.lower() == word.lower()] for word in WORD.findall(text)]
    if not spelled or not 0 < math.prod(map(len, spelled)) <= MOST_SPELLINGS:
        return None
    found: dict[Fraction, Unit] = {}
    for spelling in product(*spelled):
        words = iter(spelling)
        unit = read_unit(WORD.sub(lambda _word, words=words: next(words), text))
        if isinstance(unit, Unit) and unit.dimension == expected.dimension:
            found.setdefault(unit.factor, unit)
    return next(iter(found.values())) if len(found) == 1 else None


def _slip_of_case(text: str, unit: Unit, expected: Unit) -> ParseError | None:
    """`5 T` where a mass is asked for, `km/H` where a velocity is: asked for again, rather than judged as tesla and henry."""
    smaller = WORD.sub(lambda word: word[0].lower() if word[0] in UNSUGGESTED else word[0], text)
    meant = read_unit(smaller)
    if not isinstance(meant, Unit) or meant.dimension != expected.dimension:
        return None
    why = _("{unit} is {what}", unit=show(unit), what=called(unit.dimension))
    return ParseError("asked", why, 0, _("did you mean {near}?", near=smaller), (smaller, unit.text))
