"""The unit that a student means, where what is asked for decides between readings: `ms^-1`, `kgs`, `KGM/S`, `km/H`."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

from corollary.formula.errors import ParseError, ambiguous
from corollary.messages import catalogue
from corollary.units.run_together import WORD, in_capitals, other_cases
from corollary.units.table import UNITS, UNSUGGESTED
from corollary.units.unit import Unit, called, read_unit, show

_ = catalogue(__name__)

PLURAL = re.compile(r"(?<![A-Za-z])([A-Za-zµ]{2,})s(?![A-Za-z])")
KILO = re.compile(r"\s*[Kk]ilos?\s*")  # said for kilograms
IN = re.compile(r"in\s+(?=\S)")
# A temperature as it is typed in a hurry: `25 ⁰C` with a raised zero, `25 oC`, `25 C°`, `77 F`.
DEGREE = re.compile(
    r"\s*(?:[⁰oO0]\s?|[°º]\s?|deg\s?)?(?P<scale>[CF])\s*[°º]?\s*|\s*(?:[°º⁰]|deg(?:rees?)?)\s*"
)
UNIT_TWICE = re.compile(r"([^()]*[^()\s])\s*\(([^()]*)\)")
HERTZ, RADIANS = re.compile(r"Hz\b"), re.compile(r"\brad\b")
METRES = re.compile(r"(?<![A-Za-z])ms(?=\s?[\^⁻*-])")


def unit_meant(text: str, expected: Unit | None) -> Unit | ParseError:
    """The unit; where it has several readings, as `ms^-1` or `Ns (newton seconds)`, the one that measures what is asked for."""
    if expected is not None and (of_temperature := _temperature(text, expected)) is not None:
        return of_temperature
    if expected is not None and KILO.fullmatch(text) and expected.dimension == UNITS["kg"].dimension:
        return UNITS["kg"]
    unit = read_unit(text)
    if expected is not None and (led := IN.match(text)) and not _fits(unit, expected):  # `83.6 in J`
        behind = read_unit(text[led.end() :])
        if _fits(behind, expected):
            return behind
    if expected is not None and isinstance(unit, Unit) and "turn" in unit.text:
        unit = _counted(unit, expected)
    if _counts_turns(unit, expected):
        return _turns_are_no_radians()
    if expected is not None and text.strip() == "m" and expected.dimension == UNITS["s"].dimension:
        return ambiguous(_("m can be minutes or metres"), 0, "min", "m")
    if expected is None or (isinstance(unit, Unit) and unit.dimension == expected.dimension):
        return unit
    unknown = isinstance(unit, ParseError) and unit.status == "refused"
    if (unknown or in_capitals(text)) and (meant := _in_another_case(text, expected)) is not None:
        return _turns_are_no_radians() if _counts_turns(meant, expected) else meant
    if isinstance(unit, Unit) and (slip := _slip_of_case(text, unit, expected)) is not None:
        return slip
    twice = UNIT_TWICE.fullmatch(text)
    meanings = (
        (*unit.choices, METRES.sub("m s", text))
        if isinstance(unit, ParseError)
        else twice.groups()
        if twice
        else (PLURAL.sub(lambda found: "kg" if found[1].lower() == "kg" else found[1], text),)
    )
    fitting = [
        each
        for each in map(read_unit, meanings)
        if isinstance(each, Unit) and each.dimension == expected.dimension
    ]
    if twice:
        return fitting[0] if len(fitting) == 2 else unit
    return fitting[0] if len({each.factor for each in fitting}) == 1 else unit


def _counts_turns(unit: Unit | ParseError, expected: Unit | None) -> bool:
    """True of hertz where radians per second are asked for."""
    if expected is None or not isinstance(unit, Unit):
        return False
    return bool(HERTZ.search(unit.text) and RADIANS.search(expected.text))


def _turns_are_no_radians() -> ParseError:
    return ParseError("asked", _("Hz counts whole turns, not radians"), None, _("write rad/s, or rpm"))


def _fits(unit: Unit | ParseError, expected: Unit) -> bool:
    return isinstance(unit, Unit) and unit.dimension == expected.dimension


def _temperature(text: str, expected: Unit) -> Unit | ParseError | None:
    """The scale of a temperature written short, where one is asked for; a bare degree sign is that of the question."""
    found = DEGREE.fullmatch(text) if expected.dimension == UNITS["K"].dimension else None
    if found is None:
        return None
    asked = expected.text.removeprefix("delta_")
    if found["scale"] is None and asked not in ("degC", "degF"):
        return ambiguous(_("{text} can be °C or °F", text=text.strip()), 0, "°C", "°F")
    its_scale = f"deg{found['scale']}" if found["scale"] else asked
    return UNITS[f"delta_{its_scale}" if expected.is_difference else its_scale]


def _counted(unit: Unit, expected: Unit) -> Unit:
    """A turn as 1 where a number of turns or a frequency is asked for, and as 2 pi where an angle is."""
    if (
        expected.pi
        or unit.dimension != expected.dimension
        or re.search(r"\b(?:rad|deg|turn)\b", expected.text)
    ):
        return unit
    power = unit.pi
    return replace(unit, factor=unit.factor / Fraction(2) ** power, pi=0)


def _in_another_case(text: str, expected: Unit) -> Unit | ParseError | None:
    """`KGM/S`, `NS`, `w`: the one unit of what is asked for that these letters are, small and capital apart. `MS` is asked about."""
    found: dict[Fraction, Unit] = {}
    for spelling in other_cases(text):
        unit = read_unit(spelling)
        if isinstance(unit, Unit) and unit.dimension == expected.dimension:
            found.setdefault(unit.factor, unit)
    if len(found) < 2:
        return next(iter(found.values()), None)
    small, large = show(found[min(found)]), show(found[max(found)])
    return ambiguous(
        _("{text} can be {small} or {large}", text=text, small=small, large=large), 0, small, large
    )


def _slip_of_case(text: str, unit: Unit, expected: Unit) -> ParseError | None:
    """`5 T` where a mass is asked for, `km/H` where a velocity is: asked for again, rather than judged as tesla and henry."""
    smaller = WORD.sub(lambda word: word[0].lower() if word[0] in UNSUGGESTED else word[0], text)
    meant = read_unit(smaller)
    if not isinstance(meant, Unit) or meant.dimension != expected.dimension:
        return None
    why = _("{unit} is {what}", unit=show(unit), what=called(unit.dimension))
    return ParseError("asked", why, 0, _("did you mean {near}?", near=smaller), (smaller, unit.text))
