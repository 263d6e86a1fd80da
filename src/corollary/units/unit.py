"""Units as students and authors write them, read and written again: `kg m/s`, `Ns`, `m s⁻²`, `J/(kg m)`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import product

from corollary.formula.characters import legible
from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.formula.misspelt import one_apart
from corollary.formula.numerals import RAISED, TO_ASCII
from corollary.messages import catalogue
from corollary.units.dimension import BASE, DIFFERENCE, ONE, PURE, Dimension, Unit
from corollary.units.unit_table import (
    APART,
    CALLED,
    ENGLISH,
    NAMED,
    PREFIXES,
    REFUSED,
    UNITS,
    UNSUGGESTED,
    WITH_PREFIXES,
    prefixed,
)

_ = catalogue(__name__)

LONGEST_RUN = 9
MOST_SPELLINGS = 64
WORD = re.compile(r"[A-Za-z]+")


def cuts(run: str) -> Iterator[tuple[str, ...]]:
    """Every way to cut letters into two or three pieces."""
    ends = range(1, len(run)) if len(run) <= LONGEST_RUN else ()
    yield from ((run[:end], run[end:]) for end in ends)
    yield from ((run[:first], run[first:end], run[end:]) for end in ends for first in range(1, end))


WITH_HOURS = ("Wh", "kWh", "MWh", "GWh", "Ah", "mAh")  # products that are written as one word, in any case


def in_capitals(text: str) -> bool:
    """Whether every letter is a capital. A lone one is not enough: `5 T` may well be tesla."""
    letters = "".join(WORD.findall(text))
    return len(letters) > 1 and letters.isupper()


def other_cases(text: str) -> list[str]:
    """The same letters as the table has them, small and capital: `KG M/S` is `kg m/s`, `MS` is `ms`, `Ms`, `mS` and `MS`.

    Where all are capitals they may be run together, too: `NS` is also `N s`. Empty where a word is none, or too much.
    """
    cut = in_capitals(text)
    spelled: list[list[str]] = []
    count = 1
    for word in WORD.findall(text):
        pieces = [(word,), *(cuts(word) if cut else ())]
        spelled.append([" ".join(spelling) for each in pieces for spelling in _spellings(each)])
        count *= len(spelled[-1])
    if not 0 < count <= MOST_SPELLINGS:
        return []
    found: list[str] = []
    for spelling in product(*spelled):
        words = iter(spelling)
        found.append(WORD.sub(lambda _word, words=words: next(words), text))
    return found


def _spellings(pieces: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """The pieces in the table's letters. Among run-together ones no unit that stands apart, and no kelvin but at the end."""
    for each in product(*(in_any_case(piece) for piece in pieces)):
        if len(each) == 1 or not (APART & set(each) or "K" in each[:-1]):
            yield each


def in_any_case(symbol: str) -> list[str]:
    """The units that differ from it in capitals only: `mohm` and `Mohm` for `MOHM`."""
    return _by_small_letters(len(UNITS)).get(symbol.lower(), [])


@lru_cache(maxsize=1)
def _by_small_letters(_units: int) -> dict[str, list[str]]:
    """Symbols by their small letters, for as many as there are by now; with prefixes that no row lists: `Ms` is a reading as well."""
    found: dict[str, list[str]] = {}
    unlisted = (
        prefix + symbol for symbol in WITH_PREFIXES for prefix in PREFIXES if prefix + symbol not in UNITS
    )
    for symbol in (*UNITS, *unlisted, *WITH_HOURS):
        found.setdefault(symbol.lower(), []).append(symbol)
    return found


SPEEDS = {
    "kph": "km/h", "kmph": "km/h", "kmh": "km/h", "mps": "m/s", "mph": "mi/h",
    "km/t": "km/h", "Stundenkilometer": "km/h",  # in Norwegian an hour is a time
    "U/min": "rpm", "omdr/min": "rpm",
}  # fmt: skip
SPEED = re.compile(rf"(?<![A-Za-z])(?:{'|'.join(SPEEDS)})(?![A-Za-z])")
PER = re.compile(r"(?<![A-Za-z])(?:per|pro|par)(?![A-Za-z])")
COMPOUND = re.compile(  # in German and Norwegian written as one word
    r"(?<![A-Za-z])((?:kilo)?(?:newton|watt|joule)|kilogramm?)(?=(?:sekund|meter|stund|timer?)[a-z]{0,2}(?![a-z]))",
    re.IGNORECASE,
)
JOINED = re.compile(
    r"(?<=[A-Za-z])-(?=[A-Za-z])|(?<=[A-Za-z0-9⁰¹²³⁴-⁹)])\.(?=\s?[A-Za-z(])"
)  # `N-s`, `kg.m/s`
# Written apart, or in words that another rule would take for a slash.
IN_OTHER_WORDS = {
    re.compile(pattern): sign
    for pattern, sign in {
        r"(?<![A-Za-z])times (?:an?|per|each|every)\s+(?=[a-z])": "1/",
        r"(?<=[A-Za-z]) in (?:an?|one|1|einer?|ett?) ?(?=(?:s|sec|seconds?|min|minutes?|h|hours?|Sekunden?|Minuten?|Stunden?|sekund|minutt|time)(?![A-Za-z]))": "/",
        r"(?<=[a-z]) an? (?=second|minute|hour|day|week|year)": "/",
        r"(?<![A-Za-z])per mille?(?![a-z])": "‰",
        r"(?<![A-Za-z])light[ -]year": "lightyear",
        r"(?<![A-Za-z])(mm|in) Hg(?![a-z])": r"\1Hg",
        r"(?<![A-Za-z])kilohm": "kiloohm",
        r"(?<![A-Za-z])megohm": "megaohm",
        r"(?<![A-Za-z])a\.u\.?(?![a-z])": "au",
    }.items()
}
RAISED_BEHIND = re.compile(r"\s+(squared|cubed)(?![A-Za-z])", re.IGNORECASE)
RAISED_BEFORE = re.compile(
    r"(?<![A-Za-z])(?:(?P<square>square|sq\.?|Quadrat-?|kvadrat-?)|(?:cubic|cu\.?|Kubik-?|kubikk-?))\s*(?P<unit>(?!d\b)[A-Za-zµ]+)(?![A-Za-z^])",
    re.IGNORECASE,
)
PREFIX_APART = re.compile(
    r"(?<![A-Za-z])(kilo|milli|centi|mega|giga|micro|nano)[ -]+(?=[a-z]{4,})", re.IGNORECASE
)
SHORTENED = re.compile(
    r"(?<![A-Za-z])((?i:micro|milli|nano|kilo))(?=(?:mol|m|g|s|N|J|W|V|A|Pa|Hz|eV|C|F)(?![A-Za-z]))"
)
MICRO = re.compile(
    r"(?<![A-Za-z])mu\s*(?=(?:m|g|s|A|V|C|F|N|J|W|H|T|Pa|mol|l|L)(?![A-Za-z]))"
)  # `\\mu m` without its backslash
OMEGA = re.compile(r"(?<![A-Za-z])([kMmGu]?)\s*Omega(?![A-Za-z])")
ALL = re.compile(r"\s*\[([^\[\]]*)\]\s*|\s*\(([^()]*)\)\s*")
# °C is no degree times a coulomb. A difference of temperatures is written with a delta: `Δ°C`, `delta K`.
DELTA = r"(?:delta(?:_| ?(?=[°ºdK]))|[Δ∆]\s?)"
DEGREES = r"(?:[°º]\s?|(?<![A-Za-z])deg(?:rees?)?\s?)(?:[CFK]|[Cc]elsius|[Cc]entigrade|[Ff]ahrenheit)"
TEMPERATURE = rf"(?:{DELTA}?{DEGREES}|{DELTA}K)(?![A-Za-z])"
PARTS = re.compile(rf"(?P<delta>{DELTA})?\s?(?P<degrees>[°ºd][^CFKcf]*)?(?P<scale>[CFKcf])\w*")
GROUP = re.compile(r"\(([^()^{}]+)\)(?!\s*[\^⁰¹²³⁴-⁹⁻*])")  # not raised


def in_signs(text: str) -> str:
    """The unit with a sign for every word and mark; a place in it stays a place in what was typed, but for whole brackets."""
    if whole := ALL.fullmatch(text):
        text = whole[1] or whole[2] or ""
    for pattern, sign in IN_OTHER_WORDS.items():
        text = pattern.sub(sign, text)
    text = RAISED_BEHIND.sub(lambda found: f"^{2 if found[1].lower() == 'squared' else 3}", text)
    text = RAISED_BEFORE.sub(lambda found: f"{found['unit']}^{2 if found['square'] else 3}", text)
    text = PREFIX_APART.sub(r"\1", text.replace("electron volt", "electronvolt"))
    text = SHORTENED.sub(
        lambda found: {"micro": "u", "milli": "m", "nano": "n", "kilo": "k"}[found[1].lower()], text
    )
    text = OMEGA.sub(r"\1ohm", MICRO.sub("u", text))
    text = SPEED.sub(lambda found: SPEEDS[found[0]], text)
    text = COMPOUND.sub(r"\1 ", text)
    text = JOINED.sub("*", PER.sub(lambda found: "/".ljust(len(found[0])), text))
    for _ in range(3):
        text = GROUP.sub(_opened, text)
    return text


def _opened(group: re.Match[str]) -> str:
    """What stands in brackets, without them, unless it is below a slash or a power: they hold that together."""
    before = group.string[: group.start()].rstrip()
    return group[0] if before.endswith(("/", "^", "**")) else f" {group[1]} "


def temperature(symbol: str) -> str:
    """`Δ °C` and `degrees Celsius` as they are in the table, delta_degC and degC; any other symbol as it is."""
    if not re.fullmatch(TEMPERATURE, symbol):
        return symbol
    found = PARTS.fullmatch(symbol)
    assert found is not None  # a temperature has these parts
    scale = found["scale"].upper()
    return (DIFFERENCE if found["delta"] else "") + ("K" if scale == "K" else "deg" + scale)


def suggested(symbol: str) -> str:
    """A unit that was likely meant: the same letters in another case, or a name of one with one letter amiss; else ""."""
    low = _suggestions(len(UNITS))
    if symbol.lower() in low:
        return low[symbol.lower()]
    if not 4 <= len(symbol) < 20:
        return ""
    names = (name for name in ENGLISH if name in UNITS and one_apart(symbol.lower(), name))
    return min(names, key=lambda name: (len(name), name), default="")


@lru_cache(maxsize=1)
def _suggestions(units: int) -> dict[str, str]:
    """Units by their small letters, for as many as there are by now."""
    return {known.lower(): known for known in UNITS if known not in UNSUGGESTED and known[0] != "K"}


__all__ = [
    "BASE",
    "ONE",
    "PURE",
    "UNITS",
    "Dimension",
    "Unit",
    "called",
    "canonical",
    "kind",
    "latex",
    "read_unit",
    "show",
    "si_unit",
    "unit",
]


LONGEST_UNIT = 80
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
LARGEST_POWER = 9
MOST_CACHED = 1024
SIGNS = {"deg": "°", "ohm": "Ω", "angstrom": "Å", "degC": "°C", "degF": "°F"}
"""How units are shown that files spell out."""
IN_TEX = {
    "deg": r"{}^{\circ}", "ohm": r"\Omega", "angstrom": "Å", "%": r"\%",
    "degC": r"{}^{\circ}C", "degF": r"{}^{\circ}F",
}  # fmt: skip

RAISED_TO = r"[⁻⁺]?[⁰¹²³⁴-⁹]+|\s?(?:\^|\*\*)\s?(?:[+-]?[0-9.]+|[({][+-]?[0-9./]+[)}])"
MARK = re.compile(
    rf"\s*(?:(?P<symbol>{TEMPERATURE}|[A-Za-zµμèéåøöÅ\u212bΩΩℓ]+|[°º%‰])(?P<power>{RAISED_TO}|-?[0-9]+)?"
    rf"|(?P<one>1(?![0-9.,]))|(?P<sign>\*|/|\(|\)(?P<raised>{RAISED_TO})?))"
)
NAMES, NAMES_IN_TEX = (re.compile("deg[CF]?|ohm|angstrom" + also) for also in ("", "|%"))
SECONDS = re.compile(r"(?:sec|secs)$")
Factors = list[tuple[Unit, Fraction]]


def read_unit(text: str) -> Unit | ParseError:
    """The unit a student wrote; asks about `J/kg m` and `ms^-1`, refuses what is not in the table."""
    if len(text) > LONGEST_UNIT:
        return refused(_("a unit is not longer than {most} characters", most=LONGEST_UNIT), LONGEST_UNIT)
    known = _READ.get((text, len(UNITS)))
    if known is not None:
        return known
    found = _read(text)
    if isinstance(found, Unit):
        if len(_READ) >= MOST_CACHED:
            _READ.clear()
        _READ[text, len(UNITS)] = found
    return found


# A class writes the same few units over and over, and in a calculation each is read twice. Refusals are not kept: they are
# sentences in the language of one reader. A unit more in the table may change what a text means.
_READ: dict[tuple[str, int], Unit] = {}


def _read(text: str) -> Unit | ParseError:
    normalized = in_signs(legible(text).translate(TO_ASCII))
    marks: list[re.Match[str]] = []
    at, end = 0, len(normalized.rstrip())
    while at < end:
        mark = MARK.match(normalized, at)
        if mark is None:
            at += len(normalized[at:]) - len(normalized[at:].lstrip())
            return refused(
                _("{sign} does not belong in a unit", sign=repr(normalized[at])),
                at,
                _("write a unit such as kg m/s"),
            )
        marks.append(mark)
        at = mark.end()
    return _product(marks, end)


def _product(marks: list[re.Match[str]], end: int) -> Unit | ParseError:
    """Factors above and below the line. After a bare slash a second factor could belong to either side: then both are kept."""
    found = _factors(marks, 0, end, inside=False)
    if isinstance(found, ParseError):
        return found
    certain, floating, doubt, _number = found
    below = _composed(certain + floating)
    if not floating or isinstance(below, ParseError):
        return below
    above = _composed(certain + [(each, -power) for each, power in floating])
    if isinstance(above, ParseError):
        return above
    return ambiguous(_("it is not clear what stands below the slash"), doubt, above.text, below.text)


def _factors(
    marks: list[re.Match[str]], start: int, end: int, *, inside: bool
) -> tuple[Factors, Factors, int, int] | ParseError:
    """The factors from one mark up to the end, or `inside` brackets up to the one that closes; and the mark behind them.

    Factors after `a/b` are apart from the certain ones: read from left to right, they stand above the line.
    """
    certain: Factors = []
    floating: Factors = []
    side, slashed, ready, doubt, below, number = 1, False, True, 0, 0, start
    while number < len(marks):
        mark = marks[number]
        number += 1
        at = mark.start() + len(mark[0]) - len(mark[0].lstrip())
        if mark["sign"] == "/":
            if (ready and certain) or floating:
                return refused(
                    _("it is not clear what this slash divides"),
                    at,
                    _("write one slash and brackets, such as J/(kg m)"),
                )
            side, slashed, ready, below = -1, True, True, 0
            continue
        if mark["sign"] == "*":
            if ready:
                return refused(_("a unit is missing before this sign"), at)
            ready = True
            continue
        if (mark["sign"] or "").startswith(")"):
            if not inside or ready:
                return refused(_("this bracket closes nothing"), at)
            return certain, floating, doubt, number
        if mark["sign"] == "(":
            group = _factors(marks, number, end, inside=True)
            if isinstance(group, ParseError):
                return group
            within, unsure, its_doubt, number = group
            if unsure:
                return refused(
                    _("it is not clear what stands below the slash"), its_doubt, _("write brackets")
                )
            power = _power(marks[number - 1]["raised"] or "")
            if not power or abs(power) > LARGEST_POWER:
                return refused(_("a bracket to this power is not supported here"), at)
            found = [(each, its_power * power) for each, its_power in within]
        else:
            found = [(PURE, Fraction(1))] if mark["one"] else _symbol(mark["symbol"], mark["power"] or "", at)
            if isinstance(found, ParseError):
                return found
        unsure_side = slashed and below > 0
        if unsure_side and not floating:
            doubt = at
        (floating if unsure_side else certain).extend((each, power * side) for each, power in found)
        below = below + 1 if slashed else 0
        ready = False
    if inside or ready:
        return refused(
            _("something is missing at the end of this unit"), end, _("write a unit such as kg m/s")
        )
    return certain, floating, doubt, number


def _symbol(symbol: str, power_text: str, at: int) -> Factors | ParseError:
    power = _power(power_text)
    if symbol in REFUSED:
        return refused(_(REFUSED[symbol], unit=symbol), at)
    symbol = temperature(symbol)
    if symbol == "e" and power_text[:1] in tuple("+-0123456789"):  # `1.5 e-3` has a blank too many
        return refused(_("{written} is not a unit known here", written=symbol + power_text), at)
    if not power or abs(power) > LARGEST_POWER:  # F0 is a letter of the problem, not a farad to the power 0
        return refused(
            _("a unit to the power {power} is not supported here", power=power_text.strip("^*")), at
        )
    if symbol == "ms" and power < 0:
        return ambiguous(
            _("ms can be milliseconds, or metres times seconds"), at, f"m s^{power}", _written("1/ms", -power)
        )
    if symbol in UNITS:
        return [(UNITS[symbol], power)]
    if found := prefixed(symbol):  # before letters are cut: `mPa` is no metre times a pascal
        return [(found, power)]
    named = in_any_case(symbol) if len(symbol) > 3 and not SECONDS.search(symbol) else ()
    if len(named) > 1 and not symbol.isupper():  # `MOhm`: of the prefixes of one name the typed one is meant
        named = [each for each in named if each[0] == symbol[0]]
    if len(meant := {UNITS[each] for each in named if each in UNITS}) == 1:  # `kOhm`, `NEWTON`; `Nsec` is N s
        return [(meant.pop(), power)]
    splits = [[*((each, Fraction(1)) for each in before), (last, power)] for *before, last in _splits(symbol)]
    if len(splits) > 1:
        return ambiguous(
            _("{text} can be read in several ways", text=symbol),
            at,
            *(_factors_text(split) for split in splits),
        )
    if splits:
        return splits[0]
    near = suggested(symbol)
    return refused(
        _("{written} is not a unit known here", written=symbol[:20]),
        at,
        _("did you mean {near}?", near=near) if near else "",
    )


def _splits(run: str) -> list[tuple[Unit, ...]]:
    """Every way to cut run-together letters (`Ns`, `kgm`) into two or three units."""
    known = [cut for cut in cuts(run) if all(piece in UNITS and piece not in APART for piece in cut)]
    found = [
        tuple(UNITS[piece] for piece in cut) for cut in known if "K" not in cut[:-1]
    ]  # Kgm: kg m, no kelvin
    for first, *rest in cuts(run):  # `mPas`, `cNm`: with a prefix that no row lists
        unit = prefixed(first) if first not in UNITS and len(rest) == 1 else None
        if unit is not None and rest[0] in UNITS and rest[0] not in APART:
            found.append((unit, UNITS[rest[0]]))
    return found


def _power(text: str) -> Fraction | None:
    normalized = text.translate(RAISED).strip("^*(){} ")
    try:
        return Fraction(normalized or 1) if len(normalized) < 8 else None
    except (ValueError, ZeroDivisionError):
        return None


def _composed(factors: Factors) -> Unit | ParseError:
    """The product of powers of units."""
    dimension, factor, pi, angle = ONE, Fraction(1), Fraction(0), Fraction(0)
    for each, power in factors:
        size = _raised(each.factor, power)
        if size is None:
            return refused(
                _("{unit} to the power {power} has no exact size", unit=each.text, power=power), None
            )
        dimension, factor, pi = dimension * each.dimension**power, factor * size, pi + each.pi * power
        angle += each.angle * power
    if pi.denominator != 1:
        return refused(_("an angle has whole powers only"), None)
    alone = factors[0][0] if len(factors) == 1 and factors[0][1] == 1 else PURE
    return Unit(_factors_text(factors), dimension, factor, int(pi), alone.offset, angle)


def _factors_text(factors: Factors) -> str:
    """What is above the line, a slash, what is below: `kg*m/s^2`."""
    powers: dict[str, Fraction] = {}
    for each, power in factors:
        powers[each.text] = powers.get(each.text, Fraction(0)) + power
    above = [_written(text, power) for text, power in powers.items() if power > 0 and text != "1"]
    below = [_written(text, -power) for text, power in powers.items() if power < 0 and text != "1"]
    bottom = f"/({'*'.join(below)})" if len(below) > 1 else "".join("/" + each for each in below)
    return ("*".join(above) or "1") + bottom


def _written(text: str, power: Fraction) -> str:
    exponent = (
        str(power)
        if power.denominator == 1
        else str(float(power))
        if 20 % power.denominator == 0
        else f"({power})"
    )
    return text if power == 1 else f"{text}^{exponent}"


def _raised(size: Fraction, power: Fraction) -> Fraction | None:
    if power.denominator == 1:
        return size ** int(power)
    top, bottom = (
        round(float(each) ** (1 / power.denominator)) for each in (size.numerator, size.denominator)
    )
    root = Fraction(top, bottom)
    return root**power.numerator if root**power.denominator == size else None


def unit(text: str) -> Unit:
    """A unit an author wrote. Raises ValueError with a sentence."""
    found = read_unit(text)
    if isinstance(found, ParseError):
        raise ValueError(
            f"unit {text!r}: {found.why}" + (f"; {found.suggestion}" if found.suggestion else "")
        )
    return found


def si_unit(dimension: Dimension) -> Unit:
    """The SI unit of a dimension, under its own name where it has one (N, J, V, ohm)."""
    for name in NAMED:
        if UNITS[name].dimension == dimension:
            return UNITS[name]
    found = _composed([(UNITS[name], power) for name, power in dimension.powers().items()])
    assert isinstance(found, Unit)  # sizes of 1 have every root
    return found


def called(dimension: Dimension) -> str:
    """What a person calls it: a force, a velocity; otherwise by its SI unit."""
    name = CALLED.get(dimension)
    return _(name) if name else _("something in {unit}", unit=show(si_unit(dimension)))


def kind(unit: Unit) -> str:
    """What a person calls it that is measured in this unit: as `called`, but for an angle and its powers."""
    if unit.angle not in (0, 1):
        return _("something in {unit}", unit=show(unit))
    return _("an angle") if unit.is_angle else called(unit.dimension)


def canonical(unit: Unit) -> str:
    """As it is written in files: `N*s`, `kg*m/s^2`, `1`."""
    return unit.text


def show(unit: Unit) -> str:
    """As people read it: `kg m/s²`, `°`; nothing for a plain number."""
    if unit.text == "1":
        return ""
    raised = re.sub(r"\^([0-9]+)(?![0-9.])", lambda found: found[1].translate(SUPERSCRIPTS), unit.text)
    micro = re.sub(r"\bu(?=[a-zA-Z])", "µ", raised)
    return NAMES.sub(lambda found: SIGNS[found[0]], micro.replace(DIFFERENCE, "")).replace("*", " ")


def latex(unit: Unit) -> str:
    r"""As TeX sets it, upright: `\mathrm{kg\,m/s^{2}}`; nothing for a plain number."""
    if unit.text == "1":
        return ""
    raised = re.sub(r"\^(\([-0-9./]+\)|-?[0-9.]+)", r"^{\1}", unit.text)
    micro = re.sub(r"\bu(?=[a-zA-Z])", r"\\mu ", raised).replace("*", r"\,")
    named = NAMES_IN_TEX.sub(lambda found: IN_TEX[found[0]], micro.replace(DIFFERENCE, ""))
    return rf"\mathrm{{{named}}}"
