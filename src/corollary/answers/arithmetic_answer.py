"""Calculations left standing in an answer, worked out with their units: `0.43 kg * 20 m/s`, `20√3 m/s`, `π/2`, `sqrt(2*9.8*5) m/s`.

They are formulas whose letters are units: read by the parser of formulas, and evaluated as those are.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from itertools import pairwise

from corollary.formula.abbreviations import ABBREVIATIONS, arity, calculator_words
from corollary.formula.arithmetics import DOUBLES, ready
from corollary.formula.ast import Call, Expr, Name, Negative, Number, Product, Quotient, Sum, calls, walk
from corollary.formula.errors import ParseError, ambiguous, refused
from corollary.formula.functions import FUNCTIONS
from corollary.formula.lexer import Found, Token, tokens
from corollary.formula.numerals import VULGAR, unsigned
from corollary.formula.parser import formula
from corollary.messages import catalogue
from corollary.units.dimensional_analysis import dimension_of
from corollary.units.unit import ONE, Unit, read_unit, si_unit

_ = catalogue(__name__)

ROUNDING = 4e-16
INVERSES = frozenset({"asin", "acos", "atan", "acot", "atan2"})
LARGEST_FACTORIAL = 20
NUMBER = re.compile(r"[0-9.,]")
WORD = re.compile(r"π|P[iI](?![A-Za-z])|(?P<short>(?P<letters>[A-Za-z]+)[0-9]*)[A-Za-z]*")
EXPONENT = re.compile(r"[0-9]")
RAISED = re.compile(r"\^|\*\*|[⁻⁺]?[⁰¹²³⁴-⁹]")
BRACKET = re.compile(
    r"\((?=\s*[^()\s][^()]*[-+*/]|[0-9.,]+\s*\)\s*[*/])"
)  # with a number alone in it, it says something twice: `0.4 (40 %)`
ANGLE = re.compile(r"\s*(°|º|deg(?:rees?)?(?![A-Za-z])|rad(?![A-Za-z]))")
UNIT_POWER = r"[⁻⁺]?[⁰¹²³⁴-⁹]+|\s?(?:\^|\*\*)\s?(?:[+-]?[0-9]+|[({][+-]?[0-9./]+[)}])|-?[0-9](?![0-9.,])"
RANGE = re.compile(
    r"\s*(?P<low>[0-9]+(?:[.,][0-9]+)?)\s*(?:-|\.\.)\s*(?P<high>[0-9]+(?:[.,][0-9]+)?)\s*(?:[A-Za-zµ°%]|$)"
)  # `8-9 N`
FACTOR_ENDS = frozenset({"number", "name", "unit", "degree", "close", "e", "bar"})
EULER = re.compile(r"e(?![A-Za-z0-9_])")
IN_BRACKETS = re.compile(r"\s*\*?\s*(?P<unit>\([A-Za-zµΩ°(][^,;=]*)\s*")
BELOW_BRACKET = re.compile(r"\s*/\s*(?P<unit>[A-Za-zµΩ][^,;=+]*)\s*")


@dataclass(frozen=True, slots=True)
class Worked:
    """What a calculation comes to, in `unit` (None when no unit was written); `is_angle` tells that it is one in radians."""

    value: float
    unit: Unit | None
    is_angle: bool = False


@cache
def _units_behind(functions: tuple[str, ...], euler: bool = False) -> re.Pattern[str]:
    """Units behind a factor: `kg`, `m/s^2`, `* m/(kg s)`. A function of several numbers (min) is one before its bracket only."""
    known = calculator_words()
    words = [
        rf"{word}(?=\s*\()" if word in ABBREVIATIONS or arity(known[word]) > 1 else word for word in functions
    ]
    word = rf"(?!(?:{'|'.join(sorted((*words, 'pi', 'Pi', 'PI', *(('e',) if euler else ())), key=len, reverse=True))})(?![A-Za-z]))[A-Za-zµμΩΩÅ]++|[°º%]"
    symbol = rf"(?:{word})(?:{UNIT_POWER})?"
    below = rf"\s*/\s*\(\s*{symbol}(?:\s*\*?\s*{symbol})*\s*\)"
    return re.compile(rf"\s*\*?\s*{symbol}(?:\s*[*/]?\s*{symbol}|{below})*")


OVER_UNIT = re.compile(r"(?<=[0-9)])\s+1\s*/\s*(?=[A-Za-z])")  # `sqrt(40) 1/s`
ROOT_OVER_UNIT = re.compile(r"√\s?([0-9.]+)\s+1\s*/\s*(?=[A-Za-z])")


def worked_out(normalized: str, *, euler: bool = False) -> Worked | ParseError:
    """Sums, products, quotients, powers and roots of numbers; `normalized` is translated by TO_ASCII and bounded.

    One unit at the very end is that of the result; otherwise each unit belongs to the number before it. `euler`: a lone `e`
    is Euler's number and not the elementary charge.
    """
    normalized = OVER_UNIT.sub("/", ROOT_OVER_UNIT.sub(r"sqrt(\1)/", normalized))
    units: dict[str, Unit] = {}
    read = tokens(
        normalized, _no_letters, read_first=lambda text, at, before: _sign(text, at, before, units, euler)
    )
    if isinstance(read, ParseError):
        return read
    if (found := RANGE.match(normalized)) and _number(found["low"]) < _number(found["high"]):
        why = _("{text} can be a range or a difference", text=normalized.strip())
        difference = f"({found['low']} - {found['high']}) {normalized[found.end('high') :].strip()}".strip()
        choices = () if ".." in found[0] else (difference,)
        return ParseError("asked", why, None, _("write one number and a unit"), choices)
    written = [token for token in read if token.kind == "unit"]
    sized = [token for token in written if units[token.text].dimension != ONE]  # angles apart
    at_the_end = len(sized) == 1 and sized[0] is read[-2]
    if at_the_end and _sum_at_the_top(read):  # of `8 + 0.6 kg` it is not clear what 8 measures
        number, unit = normalized[: sized[0].at].strip(), normalized[sized[0].at :].strip()
        return ambiguous(_("a unit is missing in this sum"), None, f"({number}) {unit}")
    tree = formula([*read[:-2], read[-1]] if at_the_end else read, student=True, numbers=True)
    if isinstance(tree, ParseError):
        return tree
    if written and written[-1] is read[-2] and units[written[-1].text].is_angle:
        alone = formula([*read[:-2], read[-1]], student=True, numbers=True)
        if not isinstance(alone, ParseError) and gives_angle(alone):
            tree = alone  # `arctan(1)°`: an angle already, shown in degrees by a calculator
    if function := _bare_angle(tree):
        why = _("a number inside sin, cos or tan can be in degrees or in radians")
        return refused(why, None, _("write {function}(30°) or {function}(0.5 rad)", function=function))
    if not at_the_end and any(unit.offset for unit in units.values()):
        return refused(_("a temperature in °C or °F has no products or sums"), None, _("write it in K"))
    measured = dimension_of(tree, {name: unit.dimension for name, unit in units.items()})
    if isinstance(measured, ParseError):
        return measured
    try:
        value = ready(tree, DOUBLES)({name: unit.si for name, unit in units.items()})
    except (ValueError, OverflowError, ZeroDivisionError):
        value = math.nan
    if not math.isfinite(value):
        return refused(_("this calculation has no value"))
    if abs(value) < ROUNDING * max(
        (abs(node.value) for node in walk(tree) if isinstance(node, Number)), default=1
    ) and _has_angle(tree):
        value = 0.0  # cos(90°) is 0, not 6e-17
    if at_the_end:
        return Worked(value, units[sized[0].text])
    of_value = sized or any(_outside_functions(read))  # the 30° of cos(30°) are no unit of the value
    its_unit = si_unit(measured) if of_value and value else None  # 0 is 0 in every unit
    turned = not sized and any(units[token.text].is_angle for token in _outside_functions(read))
    return Worked(value, its_unit, turned or gives_angle(tree))


def gives_angle(tree: Expr) -> bool:
    """True of an angle by its form, which comes in radians: `arcsin(0.44)`, `pi/2 - arctan(2)`; not of `arcsin(0.44)*180/pi`."""
    match tree:
        case Call(function, _):
            return function in INVERSES
        case Negative(inside):
            return gives_angle(inside)
        case Sum(terms):
            return any(map(gives_angle, terms))
        case Product(factors):
            return any(map(gives_angle, factors)) and not any(map(_in_degrees, factors))
        case Quotient(above, below):
            return gives_angle(above) and not _in_degrees(below)
        case _:
            return False


def _in_degrees(factor: Expr) -> bool:
    """Whether a factor is there to make degrees of radians, or may be: pi, 180, 57.3."""
    return any(
        node == Name("pi") or (isinstance(node, Number) and (node.value == 180 or 57 <= node.value <= 58))
        for node in walk(factor)
    )


def _sum_at_the_top(signs: list[Token]) -> bool:
    """Whether two terms stand side by side without a bracket around them: `3 m - 4 m`."""
    depth, bars = 0, 0
    for before, sign in pairwise(signs):
        depth += (before.kind == "open") - (before.kind == "close")
        if before.kind == "bar":
            bars = 1 - bars
        if bars == depth == 0 and sign.text in ("+", "-") and before.kind in FACTOR_ENDS:
            return True
    return False


def _number(text: str) -> float:
    return float(text.replace(",", "."))


def _outside_functions(signs: list[Token]) -> Iterator[Token]:
    """The units that stand in no bracket of a function."""
    opened: list[bool] = []
    for before, sign in pairwise(signs):
        if sign.kind == "open":
            opened.append(before.kind == "function")
        elif sign.kind == "close" and opened:
            opened.pop()
        elif sign.kind == "unit" and not any(opened):
            yield sign


def _bare_angle(tree: Expr) -> str:
    """A function of an angle that is given a bare number, `cos(30)`; "" when there is none."""
    for node in walk(tree):
        match node:
            case Call(function, (Number(value) | Negative(Number(value)),)) if (
                FUNCTIONS[function].angle and value
            ):
                return function
            case _:
                continue
    return ""


def _has_angle(tree: Expr) -> bool:
    return any(FUNCTIONS[call.function].angle for call in calls(tree))


def _no_letters(run: str, at: int) -> ParseError:
    return refused(_("a number is missing here"), at, _("begin with digits, such as 8.6"))


def _sign(
    text: str, at: int, before: list[Token], units: dict[str, Unit], euler: bool
) -> Found | ParseError | None:
    """The sign of a calculation at one place, with those before it; None for one that every formula may have."""
    last = before[-1].kind if before else "sign"
    of_function = len(before) > 1 and before[-2].kind == "function" and before[-2].text != "sqrt"
    if last == "number" and of_function and (angle := ANGLE.match(text, at)):
        if angle[1] != "rad":
            return [Token("degree", "°", at, True)], angle.end()
        before.insert(
            -1, Token("open", "(", at, True)
        )  # `cos 0.5 rad` is cos(0.5*1), whose number is not bare
        one = Token("number", "1", at, True, Fraction(1))
        return [Token("sign", "*", at, True), one, Token("close", ")", at, True)], angle.end()
    if (
        last in FACTOR_ENDS
        and last != "unit"
        and (found := _units_behind(tuple(calculator_words()), euler).match(text, at))
    ):
        unit = read_unit(found[0].strip().lstrip("*"))
        if isinstance(unit, Unit):
            units[unit.text] = unit
            return [Token("unit", unit.text, at, True)], found.end()
    if last in FACTOR_ENDS and last != "unit" and (at_end := _unit_at_the_end(text, at, last)) is not None:
        units[at_end.text] = at_end
        return [Token("unit", at_end.text, at, True)], len(text)
    if euler and (constant := EULER.match(text, at)):
        return [Token("e", "e", at, text[at - 1 : at] != " ")], constant.end()
    if last == "sign" and before and before[-1].text == "^" and EXPONENT.match(text, at):
        return None  # `2^3*10^-3`: here a number ends before its power of ten
    if text[at] == "!" and last == "number":
        return _factorial(before, at)
    if text[at] == "," and _between_arguments(text, at, before):
        return None
    if NUMBER.match(text, at):
        end = text.find(",", at) if _between_arguments(text, at, before) else -1
        below = last == "sign" and bool(before) and before[-1].text == "/"
        number = unsigned(text if end < 0 else text[:end], at, below_a_line=below)
        if isinstance(number, ParseError):
            return number
        return [Token("number", text[at : number[1]], at, True, number[0].value)], number[1]
    if word := WORD.match(text, at):
        tight = text[at - 1 : at] != " "
        if word[0] in ("pi", "π", "Pi", "PI"):
            return [Token("name", "pi", at, tight)], word.end()
        spellings = calculator_words()
        known = next((each for each in word.group(0, "short", "letters") if each in spellings), None)
        if (
            known is None
            and len(word[0]) > 2
            and word[0].lower() in spellings
            and word[0] in (word[0].upper(), word[0].capitalize())
        ):
            return [Token("function", spellings[word[0].lower()], at, tight)], word.end()
        if (
            known and not text[at + len(known) : at + len(known) + 1].isalpha()
        ):  # `cos30°`, but not `cosh` cut short
            return [Token("function", spellings[known], at, tight)], at + len(known)
    twice = text[at] in "+-" and before and before[-1].text in ("+", "-") and not _factor_before_sign(before)
    beside = last in FACTOR_ENDS and (
        text[at] in VULGAR or (text[at] == "(" and last != "close" and not BRACKET.match(text, at))
    )
    tower = (
        last == "number" and RAISED.match(text, at) and RAISED.search(before[-1].text)
    )  # 10^10^9 is not (10^10)^9
    if twice or beside or tower or text[at] in "[]{}°º":
        return refused(_("one number is enough here"), at, _("work it out and write a number and a unit"))
    return None


def _unit_at_the_end(text: str, at: int, last: str) -> Unit | None:
    """A unit in brackets, or below a slash, that ends the text: `(3/2)*(m/s)`, `(-36 kJ)/mol`."""
    found = IN_BRACKETS.fullmatch(text, at)
    below = BELOW_BRACKET.fullmatch(text, at) if last == "close" else None
    unit = read_unit(found["unit"]) if found else read_unit(f"1/{below['unit']}") if below else None
    return unit if isinstance(unit, Unit) else None


def _factorial(before: list[Token], at: int) -> Found | ParseError:
    """`5!`, the number before it replaced by its factorial."""
    number = before[-1].value
    if number.denominator != 1 or number > LARGEST_FACTORIAL or "!" in before[-1].text:
        return refused(
            _("this factorial is not worked out"), at, _("work it out and write a number and a unit")
        )
    before[-1] = replace(before[-1], text=f"{before[-1].text}!", value=Fraction(math.factorial(int(number))))
    return [], at + 1


def _between_arguments(text: str, at: int, before: list[Token]) -> bool:
    """Whether the one comma in this bracket parts the two numbers of a function: `hypot(3,4)`."""
    opened = len(before) - 1
    while opened >= 0 and before[opened].kind not in ("open", "close"):
        opened -= 1
    if opened < 1 or before[opened].kind != "open" or before[opened - 1].kind != "function":
        return False
    function = before[opened - 1].text
    return (arity(function) > 1 or function == "ln") and text[before[opened].at :].partition(")")[0].count(
        ","
    ) == 1


def _factor_before_sign(before: list[Token]) -> bool:
    """Whether the last sign stands between two terms: `2 - -1`, but not `--1`."""
    return len(before) > 1 and before[-2].kind in FACTOR_ENDS
