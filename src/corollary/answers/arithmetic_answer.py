"""Calculations left standing in an answer, worked out with their units: `0.43 kg * 20 m/s`, `20√3 m/s`, `π/2`, `sqrt(2*9.8*5) m/s`."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NoReturn

from corollary.formula.errors import ParseError, refused
from corollary.formula.functions import SPELLINGS
from corollary.formula.numerals import RAISED, VULGAR, unsigned
from corollary.units.unit import ONE, Dimension, Unit, read_unit, si_unit

DEEPEST = 20
LARGEST_POWER = 9
WORD = rf"(?!(?:{'|'.join(sorted((*SPELLINGS, 'pi'), key=len, reverse=True))})(?![A-Za-z]))[A-Za-zµμ]++|[°º%]"
UNIT_POWER = r"[⁻⁺]?[⁰¹²³⁴-⁹]+|\s?(?:\^|\*\*)\s?(?:[+-]?[0-9]+|[({][+-]?[0-9./]+[)}])|-?[0-9](?![0-9.,])"
SYMBOL = rf"(?:{WORD})(?:{UNIT_POWER})?"
UNITS_BEHIND = re.compile(
    rf"\s*\*?\s*{SYMBOL}(?:\s*[*/]?\s*{SYMBOL}|\s*/\s*\(\s*{SYMBOL}(?:\s*\*?\s*{SYMBOL})*\s*\))*"
)
NUMBER = re.compile(r"[0-9.,½⅓⅔¼¾]")
ROOT = re.compile(r"√\s*")
CALLED = re.compile(rf"({'|'.join(sorted(SPELLINGS, key=len, reverse=True))})(?![A-Za-z_])\s*")
PI = re.compile(r"pi(?![A-Za-z_])|π")
RAISE = re.compile(
    r"\s*(?:\^|\*\*)\s*(?:\(\s*([+-]?[0-9]+(?:[./][0-9]+)?)\s*\)|([+-]?[0-9]+(?:\.[0-9]+)?))|([⁻⁺]?[⁰¹²³⁴-⁹]+)"
)
BRACKET = re.compile(r"\((?=\s*[^()\s][^()]*[-+*/])")
ANGLE = re.compile(r"\s*(°|º|deg(?:rees?)?(?![A-Za-z])|rad(?![A-Za-z]))")
ANGLES = frozenset({"sin", "cos", "tan"})
OF_A_NUMBER: dict[str, Callable[[float], float]] = {
    "sin": math.sin, "cos": math.cos, "tan": math.tan, "asin": math.asin, "acos": math.acos, "atan": math.atan, "exp": math.exp,
    "ln": math.log, "log10": math.log10, "sinh": math.sinh, "cosh": math.cosh, "tanh": math.tanh,
}  # fmt: skip
BARE_ANGLE = "a number inside sin, cos or tan can be in degrees or in radians"


@dataclass(frozen=True, slots=True)
class Worked:
    """What a calculation comes to, in `unit` (None when no unit was written)."""

    value: float
    unit: Unit | None


@dataclass(frozen=True, slots=True)
class _Amount:
    """A value in SI. `bare`: a number as typed, which says of itself neither degrees nor radians."""

    value: float
    dimension: Dimension = ONE
    bare: bool = False


class _Stop(Exception):
    """Leaves the calculation with what is to be said."""

    def __init__(self, trouble: ParseError) -> None:
        self.trouble = trouble


@dataclass(slots=True)
class _Line:
    text: str
    at: int = 0
    depth: int = 0
    units: list[tuple[Unit, int, int]] = field(default_factory=list)

    def skip(self) -> str:
        """The next sign that is no blank; "" at the end."""
        while self.text[self.at : self.at + 1] == " ":
            self.at += 1
        return self.text[self.at : self.at + 1]

    def take(self, pattern: re.Pattern[str]) -> re.Match[str] | None:
        found = pattern.match(self.text, self.at)
        if found:
            self.at = found.end()
        return found


def worked_out(plain: str) -> Worked | ParseError:
    """Products, quotients, powers and roots of numbers, sums only within brackets; `plain` is translated by PLAIN and bounded.

    One unit at the very end is that of the result; otherwise each unit belongs to the number before it.
    """
    line = _Line(plain)
    try:
        amount = _whole(line)
        sized = [each for each in line.units if each[0].dimension != ONE]  # angles apart
        if len(sized) == 1 and sized[0][2] == len(plain.rstrip()):
            unit, start, _ = sized[0]
            return Worked(_whole(_Line(plain[:start])).value, unit)
    except _Stop as stop:
        return stop.trouble
    except (ValueError, OverflowError, ZeroDivisionError):
        return refused("this calculation has no value")
    if not line.units:
        return Worked(amount.value, None)
    return Worked(amount.value, si_unit(amount.dimension))


def _whole(line: _Line) -> _Amount:
    amount = _products(line)
    if line.skip():
        _refuse(line, "one number is enough here", "work it out and write a number and a unit")
    if not math.isfinite(amount.value):
        _refuse(line, "this calculation has no value")
    return amount


def _refuse(line: _Line, why: str, suggestion: str = "") -> NoReturn:
    raise _Stop(refused(why, min(line.at, len(line.text) - 1), suggestion))


def _terms(line: _Line) -> _Amount:
    amount = _products(line)
    while (sign := line.skip()) in ("+", "-") and sign:
        line.at += 1
        term = _products(line)
        if term.dimension != amount.dimension:
            _refuse(line, "only quantities of one kind can be added")
        amount = _Amount(amount.value + (term.value if sign == "+" else -term.value), amount.dimension)
    return amount


def _products(line: _Line) -> _Amount:
    sign = line.skip()
    if sign in ("+", "-") and sign:
        line.at += 1
        amount = _factor(line)
        amount = _Amount(-amount.value if sign == "-" else amount.value, amount.dimension, amount.bare)
    else:
        amount = _factor(line)
    divided = (
        False  # by more than a number with a blank behind it: `1/2 π` is a half of π, `1/2π` is not clear
    )
    while True:
        sign = line.skip()
        if sign in ("*", "/") and sign:
            line.at += 1
            negative = line.skip() == "-"
            line.at += negative
            factor = _factor(line)
            factor = _Amount(-factor.value, factor.dimension, factor.bare) if negative else factor
        elif _stands(line) and not NUMBER.match(sign):
            if divided:
                _refuse(
                    line,
                    "it is not clear what stands below the slash",
                    "put brackets around what is divided by",
                )
            sign, factor = "*", _factor(line)
        else:
            return amount
        divided = divided or (sign == "/" and not (factor.bare and line.text[line.at : line.at + 1] == " "))
        amount = (
            _Amount(amount.value * factor.value, amount.dimension * factor.dimension)
            if sign == "*"
            else _Amount(amount.value / factor.value, amount.dimension / factor.dimension)
        )


def _stands(line: _Line) -> bool:
    """Whether a factor comes next. A number in brackets is none: `0.4 (40 %)` says the same twice."""
    return any(pattern.match(line.text, line.at) for pattern in (NUMBER, ROOT, CALLED, PI, BRACKET))


def _factor(line: _Line) -> _Amount:
    """A number, π, a root, a function or a bracket; its power; the unit behind it."""
    line.depth += 1
    if line.depth > DEEPEST:
        _refuse(line, "this calculation is nested too deep")
    line.skip()
    amount = _to_power(line, _atom(line))
    found = UNITS_BEHIND.match(line.text, line.at)
    if found and not isinstance(unit := read_unit(found[0].strip().lstrip("*")), ParseError):
        line.units.append((unit, found.start(), found.end()))
        line.at = found.end()
        size = float(unit.factor) * math.pi**unit.pi
        amount = _Amount(amount.value * size, amount.dimension * unit.dimension)
    line.depth -= 1
    return amount


def _atom(line: _Line) -> _Amount:
    if NUMBER.match(line.text, line.at):
        number = unsigned(line.text, line.at)
        if isinstance(number, ParseError):
            raise _Stop(number)
        line.at = number[1]
        return _Amount(float(number[0].value), bare=line.text[line.at - 1] not in VULGAR)
    if line.take(PI):
        return _Amount(math.pi)
    if line.take(ROOT):
        return _root(_atom(line))
    if function := line.take(CALLED):
        return _called(line, SPELLINGS[function[1]])
    if line.skip() == "(":
        line.at += 1
        inner = _terms(line)
        if line.skip() != ")":
            _refuse(line, "a bracket is not closed")
        line.at += 1
        return inner
    _refuse(line, "a number is missing here", "begin with digits, such as 8.6")


def _called(line: _Line, function: str) -> _Amount:
    bracket = line.skip() == "("
    argument = _atom(line)
    if not bracket and (angle := line.take(ANGLE)):
        argument = _Amount(argument.value * (1.0 if angle[1] == "rad" else math.pi / 180))
    if function == "sqrt":
        return _root(argument)
    if function not in OF_A_NUMBER or argument.dimension != ONE:
        _refuse(line, f"{function} cannot be worked out here")
    if function in ANGLES and argument.bare:
        _refuse(line, BARE_ANGLE, f"write {function}(30°) or {function}(0.5 rad)")
    return _Amount(OF_A_NUMBER[function](argument.value))


def _root(amount: _Amount) -> _Amount:
    half = Dimension(amount.dimension.kg / 2, amount.dimension.m / 2, amount.dimension.s / 2)
    return _Amount(math.sqrt(amount.value), half)


def _to_power(line: _Line, amount: _Amount) -> _Amount:
    found = line.take(RAISE)
    if found is None:
        return amount
    written = (found[1] or found[2] or found[3]).translate(RAISED)
    above, _, below = written.partition("/")
    power = float(above) / float(below or 1) if len(written) < 8 else math.inf
    if abs(power) > LARGEST_POWER or 2 * power != round(2 * power):
        _refuse(line, f"a power such as {written[:8]} does not occur here")
    twice = round(2 * power)
    size = amount.dimension
    return _Amount(
        math.pow(amount.value, power), Dimension(size.kg * twice / 2, size.m * twice / 2, size.s * twice / 2)
    )
