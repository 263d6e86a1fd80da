"""The units of mechanics: what they measure, how they are written, and what they are in kg, m and s."""

from __future__ import annotations

import re
from dataclasses import dataclass
from difflib import get_close_matches
from fractions import Fraction

from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.formula.numerals import PLAIN, RAISED
from corollary.units.words import SPELLED, in_signs

LONGEST_UNIT = 80
SUPERSCRIPTS = str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹")
LARGEST_POWER = 9


@dataclass(frozen=True, slots=True)
class Dimension:
    """Powers of kilogram, metre and second; an angle has none. Fractions occur in contact constants (N/m^1.5)."""

    kg: Fraction = Fraction(0)
    m: Fraction = Fraction(0)
    s: Fraction = Fraction(0)

    def __mul__(self, other: Dimension) -> Dimension:
        return Dimension(self.kg + other.kg, self.m + other.m, self.s + other.s)

    def __truediv__(self, other: Dimension) -> Dimension:
        return Dimension(self.kg - other.kg, self.m - other.m, self.s - other.s)

    def __pow__(self, power: int | Fraction) -> Dimension:
        return Dimension(self.kg * power, self.m * power, self.s * power)


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit and its size: one of it is `factor` times pi**`pi` in SI (a degree is pi/180, a percent 1/100)."""

    text: str
    dimension: Dimension
    factor: Fraction = Fraction(1)
    pi: int = 0


def _dimension(kg: int, m: int, s: int) -> Dimension:
    return Dimension(Fraction(kg), Fraction(m), Fraction(s))


ONE = Dimension()
PURE = Unit("1", ONE)
PREFIX = {
    "": 0,
    "p": -12,
    "n": -9,
    "u": -6,
    "µ": -6,
    "μ": -6,
    "m": -3,
    "c": -2,
    "d": -1,
    "h": 2,
    "k": 3,
    "K": 3,
    "M": 6,
    "G": 9,
}
TABLE = (  # symbol, powers of kg, m and s, size in SI, prefixes it is used with; sizes of eV and u: CODATA 2018
    ("g", (1, 0, 0), "1/1000", "nuµμmkK"), ("m", (0, 1, 0), "1", "nuµμmcdkK"), ("s", (0, 0, 1), "1", "pnuµμm"),
    ("N", (1, 1, -2), "1", "uµμmkKMG"), ("J", (1, 2, -2), "1", "uµμmkKMG"), ("W", (1, 2, -3), "1", "uµμmkKMG"),
    ("Pa", (1, -1, -2), "1", "hkKMG"), ("Hz", (0, 0, -1), "1", "mkKMG"), ("eV", (1, 2, -2), "1.602176634e-19", "mkKMG"),
    ("t", (1, 0, 0), "1000", ""), ("u", (1, 0, 0), "1.66053906660e-27", ""), ("min", (0, 0, 1), "60", ""),
    ("h", (0, 0, 1), "3600", ""), ("rad", (0, 0, 0), "1", "m"), ("%", (0, 0, 0), "1/100", ""),
)  # fmt: skip
ONE_SIGN = {"K": "k", "µ": "u", "μ": "u"}
UNITS = {
    sign + symbol: Unit(
        ONE_SIGN.get(sign, sign) + symbol, _dimension(*powers), Fraction(size) * Fraction(10) ** PREFIX[sign]
    )
    for symbol, powers, size, prefixes in TABLE
    for sign in ("", *prefixes)
}
UNITS |= dict.fromkeys(("deg", "°", "º", "degree", "degrees"), Unit("deg", ONE, Fraction(1, 180), 1))
UNITS |= {
    prefix + word + plural: UNITS[sign + symbol]
    for symbol, words in SPELLED.items()
    for word in words.split()
    for prefix, sign in (
        ("", ""),
        ("milli", "m"),
        ("micro", "u"),
        ("centi", "c"),
        ("kilo", "k"),
        ("mega", "M"),
    )
    for plural in ("", "s", "n", "en")
    if sign + symbol in UNITS and (plural != "en" or word[-1] != "e")
}
CALLED = {
    _dimension(*powers): words
    for powers, words in {
        (0, 0, 0): "a plain number", (1, 0, 0): "a mass", (0, 1, 0): "a length", (0, 0, 1): "a time", (0, 1, -1): "a velocity",
        (0, 1, -2): "an acceleration", (1, 1, -1): "a momentum or an impulse", (1, 1, -2): "a force", (1, 2, -2): "an energy",
        (1, 2, -3): "a power", (0, 0, -1): "a rate", (1, 0, -1): "a rate of mass", (1, 0, -2): "a spring constant",
        (1, -1, -2): "a pressure", (0, 2, 0): "an area", (0, 3, 0): "a volume", (1, -3, 0): "a density",
        (1, 2, 0): "a moment of inertia",
    }.items()
}  # fmt: skip

MARK = re.compile(
    r"\s*(?:(?P<symbol>[A-Za-zµμèé]+|[°º%])(?P<power>[⁻⁺]?[⁰¹²³⁴-⁹]+|\s?(?:\^|\*\*)\s?(?:[+-]?[0-9.]+|[({][+-]?[0-9./]+[)}])|[+-]?[0-9]+)?"
    r"|(?P<one>1(?![0-9.,]))|(?P<sign>\*|/|\(|\)))"
)
Factors = list[tuple[Unit, Fraction]]


def read_unit(text: str) -> Unit | ParseError:
    """The unit a student wrote; asks about `J/kg m` and `ms^-1`, refuses what is not in the table."""
    if len(text) > LONGEST_UNIT:
        return refused(f"a unit is not longer than {LONGEST_UNIT} characters", LONGEST_UNIT)
    plain = in_signs(text.translate(PLAIN))
    marks: list[re.Match[str]] = []
    at, end = 0, len(plain.rstrip())
    while at < end:
        mark = MARK.match(plain, at)
        if mark is None:
            at += len(plain[at:]) - len(plain[at:].lstrip())
            return refused(f"{plain[at]!r} does not belong in a unit", at, "write a unit such as kg m/s")
        marks.append(mark)
        at = mark.end()
    return _product(marks, end)


def _product(marks: list[re.Match[str]], end: int) -> Unit | ParseError:
    """Factors above and below the line. After a bare slash a second factor could belong to either side: then both are kept."""
    certain: Factors = []
    floating: Factors = []  # factors after `a/b`, above the line when read from left to right
    side, opened, slashed, ready, doubt = 1, 0, False, True, 0
    for mark in marks:
        at = mark.start() + len(mark[0]) - len(mark[0].lstrip())
        if mark["sign"] == "/":
            if opened or (ready and certain) or floating:
                return refused(
                    "this slash has no clear place", at, "write one slash and brackets, such as J/(kg m)"
                )
            side, slashed, ready = -1, False, True
        elif mark["sign"] == "*":
            if ready:
                return refused("a unit is missing before this sign", at)
            ready = True
        elif mark["sign"] == "(":
            if opened or (slashed and side < 0):
                return refused(
                    "this bracket has no clear place", at, "write one slash and one bracket, such as J/(kg m)"
                )
            opened, ready = 1, True
        elif mark["sign"] == ")":
            if not opened or ready:
                return refused("this bracket closes nothing", at)
            opened, slashed, ready = 0, True, False
        else:
            found = [(PURE, Fraction(1))] if mark["one"] else _symbol(mark["symbol"], mark["power"] or "", at)
            if isinstance(found, ParseError):
                return found
            if slashed and side < 0 and not floating:
                doubt = at
            (floating if slashed and side < 0 else certain).extend(
                (each, power * side) for each, power in found
            )
            slashed, ready = slashed or not opened, False
    if opened or ready:
        return refused("something is missing at the end of this unit", end, "write a unit such as kg m/s")
    below = _composed(certain + floating)
    if not floating or isinstance(below, ParseError):
        return below
    above = _composed(certain + [(each, -power) for each, power in floating])
    if isinstance(above, ParseError):
        return above
    return ambiguous("it is not clear what stands below the slash", doubt, above.text, below.text)


def _symbol(symbol: str, power_text: str, at: int) -> Factors | ParseError:
    power = _power(power_text)
    if power is None or abs(power) > LARGEST_POWER:
        return refused(f"a unit to the power {power_text.strip('^*')} does not occur here", at)
    if symbol == "ms" and power < 0:
        return ambiguous(
            "ms can be milliseconds, or metres times seconds", at, f"m s^{power}", _written("1/ms", -power)
        )
    if known := UNITS.get(symbol) or (UNITS.get(symbol.lower()) if len(symbol) > 3 else None):
        return [(known, power)]
    splits = [[*((each, Fraction(1)) for each in before), (last, power)] for *before, last in _splits(symbol)]
    if len(splits) > 1:
        return ambiguous(
            f"{symbol} can be read in several ways", at, *(_factors_text(split) for split in splits)
        )
    if splits:
        return splits[0]
    low = {known.lower(): known for known in UNITS if known[0] != "K"}
    near = [low[symbol.lower()]] if symbol.lower() in low else get_close_matches(symbol[:20], low.values(), 1)
    return refused(f"{symbol[:20]} is not a unit known here", at, f"did you mean {near[0]}?" if near else "")


def _splits(run: str) -> list[tuple[Unit, ...]]:
    """Every way to cut run-together letters (`Ns`, `kgm`) into two or three units."""
    ends = range(1, len(run)) if len(run) < 10 else ()
    cuts = [(run[:end], run[end:]) for end in ends]
    cuts += [(run[:first], run[first:end], run[end:]) for end in ends for first in range(1, end)]
    return [tuple(UNITS[piece] for piece in cut) for cut in cuts if all(piece in UNITS for piece in cut)]


def _power(text: str) -> Fraction | None:
    plain = text.translate(RAISED).strip("^*(){} ")
    try:
        return Fraction(plain or 1) if len(plain) < 8 else None
    except (ValueError, ZeroDivisionError):
        return None


def _composed(factors: Factors) -> Unit | ParseError:
    """The product of powers of units."""
    dimension, factor, pi = ONE, Fraction(1), Fraction(0)
    for each, power in factors:
        size = _raised(each.factor, power)
        if size is None:
            return refused(f"{each.text} to the power {power} has no exact size", None)
        dimension, factor, pi = dimension * each.dimension**power, factor * size, pi + each.pi * power
    if pi.denominator != 1:
        return refused("an angle has whole powers only", None)
    return Unit(_factors_text(factors), dimension, factor, int(pi))


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
    """The SI unit of a dimension, under its own name where it has one (N, J, W, Pa)."""
    for name in ("N", "J", "W", "Pa"):
        if UNITS[name].dimension == dimension:
            return UNITS[name]
    powers = [(UNITS["kg"], dimension.kg), (UNITS["m"], dimension.m), (UNITS["s"], dimension.s)]
    found = _composed([(each, power) for each, power in powers if power])
    assert isinstance(found, Unit)  # sizes of 1 have every root
    return found


def called(dimension: Dimension) -> str:
    """What a person calls it: a force, a velocity; otherwise by its SI unit."""
    return CALLED.get(dimension) or f"something in {show(si_unit(dimension))}"


def canonical(unit: Unit) -> str:
    """As it is written in files: `N*s`, `kg*m/s^2`, `1`."""
    return unit.text


def show(unit: Unit) -> str:
    """As people read it: `kg m/s²`, `°`; nothing for a plain number."""
    if unit.text == "1":
        return ""
    raised = re.sub(r"\^([0-9]+)(?![0-9.])", lambda found: found[1].translate(SUPERSCRIPTS), unit.text)
    return re.sub(r"\bu(?=[a-zA-Z])", "µ", raised).replace("*", " ").replace("deg", "°")


def latex(unit: Unit) -> str:
    r"""As TeX sets it, upright: `\mathrm{kg\,m/s^{2}}`; nothing for a plain number."""
    if unit.text == "1":
        return ""
    raised = re.sub(r"\^(\(?[-0-9./]+\)?)", r"^{\1}", unit.text)
    symbols = (
        re.sub(r"\bu(?=[a-zA-Z])", r"\\mu ", raised)
        .replace("*", r"\,")
        .replace("deg", r"{}^{\circ}")
        .replace("%", r"\%")
    )
    return rf"\mathrm{{{symbols}}}"
