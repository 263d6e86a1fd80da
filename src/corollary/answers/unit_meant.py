"""The unit that a student means, where what is asked for decides between readings: `ms^-1`, `kgs`, `KGM/S`, `km/H`."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction

from corollary.formula.errors import ParseError, ambiguous
from corollary.messages import catalogue
from corollary.units.unit import ONE, WORD, Dimension, Unit, called, in_capitals, other_cases, read_unit, show
from corollary.units.unit_table import UNITS, UNSUGGESTED

_ = catalogue(__name__)

PLURAL = re.compile(r"(?<![A-Za-z])([A-Za-zµ]{2,})s(?![A-Za-z])")
STANDARD_GRAVITY = Unit("g_n", Dimension.of("m s^-2"), Fraction("9.80665"))
# What is typed for a unit that is another one, by what is asked for.
SHORT: dict[Dimension, dict[str, Unit]] = {
    UNITS["s"].dimension: {"a": UNITS["yr"], "y": UNITS["yr"]},
    UNITS["kg"].dimension: {"gm": UNITS["g"], "gms": UNITS["g"]},
    STANDARD_GRAVITY.dimension: dict.fromkeys(("g", "gs", "g's"), STANDARD_GRAVITY),
}
METRE_GLUED = re.compile(r"/\s*\(?\s*m\s?K\)?(?![A-Za-z0-9^])")  # `W/mK` has no millikelvin
PER_SECOND = Dimension.of("s^-1")
LARGE_CALORIES = re.compile(r"\s*Cals?\s*")
SI_UNITS = re.compile(r"\s*\(?(?:in )?SI(?:[ -]units?)?\)?\s*")
KILO = re.compile(r"\s*[Kk]ilos?\s*")  # said for kilograms
IN = re.compile(r"in\s+(?=\S)")
# A temperature as it is typed in a hurry: `25 ⁰C` with a raised zero, `25 oC`, `25 C°`, `77 F`.
DEGREE = re.compile(
    r"\s*(?:[⁰oO0]\s?|[°º]\s?|deg\s?|[Gg]rad(?:er)?\s?)?(?P<scale>[CF])(?:elsius|ahrenheit)?\s*[°º]?\s*"
    r"|\s*(?:[°º⁰]|deg(?:rees?)?|[Gg]rad(?:er)?)\s*"
)
POUND = re.compile(r"(?<![A-Za-z])(?:lbs?|[Pp]ounds?|[Pp]funde?|[Pp]und)(?![A-Za-z])")
UNIT_TWICE = re.compile(r"([^()]*[^()\s])\s*\(([^()]*)\)")
HERTZ, TURNS = re.compile(r"Hz\b"), re.compile(r"\b(?:turn|rpm)\b")
SHARE = re.compile(r"[%‰]|\bpp[mb]\b")
RATE_OF_SHARE = re.compile(r"(?:[%‰]|pp[mb])(?:/.*)?")
OF_A_FIELD = re.compile(
    r"\s*(?P<prefix>[mkuµμ]?)(?:G|Gs)\s*"
)  # `5 G`: gauss where a magnetic field is asked for
METRES = re.compile(r"(?<![A-Za-z])ms(?=\s?[\^⁻*-])")


def unit_meant(text: str, expected: Unit | None) -> Unit | ParseError:
    """The unit; where it has several readings, as `ms^-1` or `Ns (newton seconds)`, the one that measures what is asked for."""
    if expected is not None and (of_temperature := _temperature(text, expected)) is not None:
        return of_temperature
    if expected is not None and SI_UNITS.fullmatch(text) and expected.si == 1 and not expected.offset:
        return expected
    if expected is not None and KILO.fullmatch(text) and expected.dimension == UNITS["kg"].dimension:
        return UNITS["kg"]
    if expected is not None and (of_field := OF_A_FIELD.fullmatch(text)) and _fits(UNITS["gauss"], expected):
        return read_unit(f"{of_field['prefix']}gauss")
    if expected is not None and (short := SHORT.get(expected.dimension, {}).get(text.strip())) is not None:
        return short
    if LARGE_CALORIES.fullmatch(text):
        return ambiguous(
            _("{text} can be {small} or {large}", text=text, small="cal", large="kcal"), 0, "cal", "kcal"
        )
    unit = read_unit(text)
    if expected is not None and (led := IN.match(text)) and not _fits(unit, expected):  # `83.6 in J`
        behind = read_unit(text[led.end() :])
        if _fits(behind, expected):
            return behind
    if expected is not None and isinstance(unit, Unit):
        if TURNS.search(unit.text):
            unit = _counted(unit, expected)
        if (doubt := _doubtful(text, unit, expected)) is not None:
            return doubt
    if expected is not None and text.strip() == "m" and expected.dimension == UNITS["s"].dimension:
        return ambiguous(_("m can be minutes or metres"), 0, "min", "m")
    if expected is None or (isinstance(unit, Unit) and unit.dimension == expected.dimension):
        return unit
    in_force = read_unit(POUND.sub("lbf", text))
    if isinstance(in_force, Unit) and in_force.dimension == expected.dimension:
        return in_force  # the pounds that are read are shown as lbf
    by_metre = read_unit(METRE_GLUED.sub("/(m K)", text))
    if isinstance(by_metre, Unit) and by_metre.dimension == expected.dimension:
        return by_metre
    unknown = isinstance(unit, ParseError) and unit.status == "refused"
    if (unknown or in_capitals(text)) and (meant := _in_another_case(text, expected)) is not None:
        return (_doubtful(text, meant, expected) or meant) if isinstance(meant, Unit) else meant
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


def _doubtful(text: str, unit: Unit, expected: Unit) -> ParseError | None:
    """What is asked about a unit of the right dimension: hertz for rad/s or the other way round, rpm where it is not said what is
    counted, and a percent or a degree that stands beside a unit of something else (`12 % N`)."""
    if unit.dimension != expected.dimension:
        return None
    if HERTZ.search(unit.text) and expected.angle:
        return ParseError("asked", _("Hz counts whole turns, not radians"), None, _("write rad/s, or rpm"))
    if expected.angle == 1 and not unit.angle and unit.factor != 1 and unit.dimension == PER_SECOND:
        return ambiguous(
            _("{text} can count turns or radians", text=text.strip()),
            0,
            f"turn*{unit.text}".replace("*1", ""),
            f"rad*{unit.text}".replace("*1", ""),
        )
    if HERTZ.search(expected.text) and unit.angle:
        return ParseError("asked", _("Hz counts whole turns, not radians"), None, _("write Hz, or rpm"))
    if "rpm" in unit.text and not expected.angle and not HERTZ.search(expected.text):
        return ambiguous(_("{text} can count turns or radians", text=text.strip()), 0, "turn/min", "rad/s")
    share, turned = SHARE.search(unit.text), unit.pi and not expected.angle and expected.dimension != ONE
    if share and expected.is_angle:
        why = _("{text} is a share, not an angle", text=text.strip())
    elif turned or (share and not RATE_OF_SHARE.fullmatch(unit.text)):
        why = _("{text} joins another unit with % or °", text=text.strip())
    else:
        return None
    return ParseError("asked", why, None, _("write one number and a unit"))


def _fits(unit: Unit | ParseError, expected: Unit) -> bool:
    return isinstance(unit, Unit) and unit.measures(expected)


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
        not unit.measures(expected)
        or expected.angle
        or ("rpm" in unit.text and not HERTZ.search(expected.text))
    ):
        return unit
    power = unit.pi
    return replace(unit, factor=unit.factor / Fraction(2) ** power, pi=0, angle=unit.angle - power)


def _in_another_case(text: str, expected: Unit) -> Unit | ParseError | None:
    """`KGM/S`, `NS`, `w`: the one unit of what is asked for that these letters are, small and capital apart. `MS` is asked about."""
    found: dict[Fraction, Unit] = {}
    spellings = other_cases(text)
    if not (text.isupper() or text.islower()):  # `Mhz`: its first letter is as it was meant
        spellings.sort(key=lambda each: each[:1] != text[:1])
    for spelling in spellings:
        unit = read_unit(spelling)
        if found and spelling[:1] != text[:1] and not (text.isupper() or text.islower()):
            break
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
        other = _in_another_case(text, expected) if text.islower() else None  # `5 kn` for kN
        if not isinstance(other, Unit):
            return None
        meant, smaller = other, show(other)
    why = _("{unit} is {what}", unit=show(unit), what=called(unit.dimension))
    return ParseError("asked", why, 0, _("did you mean {near}?", near=smaller), (smaller, unit.text))
