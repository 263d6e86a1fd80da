"""A student's number and unit, read once and shown back: what it is in SI, and whether it is the kind of thing asked for."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Literal

from corollary.answers import trace
from corollary.answers.arithmetic_answer import worked_out
from corollary.answers.doubts import doubtful
from corollary.answers.left_side import (
    RATIO,
    Solved,
    gives,
    gives_what_is_asked,
    has_letters,
    is_another_given,
    is_calculation,
    measures_otherwise,
    named,
    solvable,
    solved_value,
    turned_over,
    turns,
    unknown_letter,
)
from corollary.answers.motion_words import motion_in_number
from corollary.answers.name import SYMBOL, another_body, is_name, is_talk
from corollary.answers.number_words import clock_in_units, in_digits
from corollary.answers.preamble import UNCHANGING, answer_in
from corollary.answers.question import Question
from corollary.answers.sign_words import SIGNS
from corollary.answers.spread import WIDEST, without_spread
from corollary.answers.tolerance import same_value
from corollary.answers.unit_meant import unit_meant
from corollary.formula.ast import Expr
from corollary.formula.by_hand import by_hand
from corollary.formula.errors import ParseError, refused
from corollary.formula.numerals import LONGEST, TO_ASCII, Written, decimal_text, scan_number
from corollary.messages import catalogue, in_convention
from corollary.units.unit import ONE, PURE, UNITS, Dimension, Unit, kind, read_unit, show

_ = catalogue(__name__)

MOST_SIDES = 5
DEGREES_APART = 0.3  # kelvins between two sides, each rounded: 273 or 273.15 may have been added
RESIDUE = 1e-12  # in the unit typed: what a calculation leaves where the other side is 0
ROUND = str.maketrans("[]{}", "()()")
TWICE = re.compile(
    r"\s*([^()=]*[^()=\s])\s*(?:(?P<open>\()|[,;]\s*(?:or|i\.e\.|that is)\s)\s*=?\s*([^()=]*[^()=\s])\s*(?(open)\))\s*"
)

CHARGE, CHARGED = Dimension.of("A s"), re.compile(r"(?<![A-Za-z])(?:[pnumk]?C|e|[mkMGT]?eV)(?![A-Za-z])")
EULER = re.compile(
    r"(?<![A-Za-z_.])e(?![A-Za-z0-9_+])(?!-[0-9])|(?<![A-Za-z_.0-9])e(?=\s*(?:\^|\*\*|[⁻⁰¹²³⁴-⁹]))"
)
TWO_ANSWERS = re.compile(r"\d\D*\s(?:or|oder|eller|ou)\s\D*\d", re.IGNORECASE)
# `86 N = F`
NAME_BEHIND = re.compile(r"\s*(?P<value>[-+−–]?\s*[0-9.,][^=≈]*?)\s*=\s*(?P<name>[^=≈\s0-9][^=≈]{0,12}?)\s*")
# As columns of tables and axes of figures are labelled: `F [N] = 86`, `F (N) = 86`, `F in N: 86`, `F/N = 86`.
LABELLED = re.compile(
    rf"\s*(?P<name>{SYMBOL})\s*(?:\[(?P<squared>[^\[\]=]+)\]|\s\((?P<round>[^()=]+)\)|\s+in\s+(?P<led>[^=:]+?)|/\s*\(?(?P<below>[^()=:]+?)\)?)\s*[=:]\s*(?P<number>[-+−]?\s*[0-9.,]+(?:\s?(?:[eE]|[·*x×]\s?10\^?)[-+−]?[0-9]+)?)\s*"
)
IN_BRACKETS = re.compile(r"\s*[(\[](?P<equation>[^()\[\]=]+=[^()\[\]=]+)[)\]]\s*\.?\s*")  # `(F = 86 N)`
ARROW = re.compile(rf"^(?P<name>\s*{SYMBOL})\s*(?:→|⇒|[-=]>)\s*(?=[-+−]?[0-9.,])")  # `F → 86 N`
WORDS_BEHIND_NAME = re.compile(
    rf"(?P<name>\s*{SYMBOL})\s*\((?P<words>[A-Za-z ]+)\)(?=\s*=)"
)  # `F (average) = 86 N`
SHARE_OF = re.compile(r"(?<=[0-9])(\s*%)\s+of\s+(?=[0-9])")  # `65 % of 20 cm`
OF_THAT = re.compile(
    r"(?<=[0-9])(?P<unit>\s*(?:%|percent))?\s+(?:of (?:it|that|this|them)|more or less|or so)\s*$",
    re.IGNORECASE,
)
GLUED = re.compile(r"(?<=[A-Za-z²³°%])([+-])(?=[0-9.,]+\s*[A-Za-zµ°%])")
PIECE = re.compile(r"([0-9]+(?:[.,][0-9]+)?)\s*(°|[A-Za-zµ]+)\.?,?")
SEVERAL = re.compile(
    rf"\s*[-+]?(?:{PIECE.pattern}(?:\s+|(?=[0-9]))(?:and\s+|und\s+|og\s+)?)+{PIECE.pattern}\.?\s*"
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
    beside: tuple[Expr, ...] = ()


def read_quantity(text: str, expected: Unit | None, question: Question | None = None) -> Reading | ParseError:
    """The number and unit a text stands for, or the calculation left standing in it. Without `expected` every unit fits.

    With the `question`, a left side that is a formula of its givens is known to stand for the answer.
    """
    if len(text) > LONGEST:
        return refused(_("this is longer than {most} characters", most=LONGEST), LONGEST)
    typed = _with_label_behind(_rewrite(text), expected, question)
    normalized, skipped, sides = answer_in(  # split_remark, strip_preamble, solve_left_side
        typed.translate(TO_ASCII), in_a_sentence=question is not None and not question.components
    )
    rewritten = text != typed
    if (doubt := doubtful(typed, normalized)) is not None:
        return placed(doubt, skipped, rewritten=rewritten)
    normalized, spread = _split_uncertainty(normalized)
    found = _parse(text, normalized, expected)
    if isinstance(found, ParseError):
        if found.status == "refused" and TWO_ANSWERS.search(typed):
            return refused(_("these are two answers"), None, _("write the one that you mean"))
        return placed(found, skipped, rewritten=rewritten)
    if sides:
        with trace.silent():
            beside = _beside_sides(sides, found, expected, question)
        if isinstance(beside, ParseError):
            return beside
        found = replace(found, beside=beside)
    return _with_spread(found, spread) if spread else found


def _rewrite(text: str) -> str:
    """Stage `rewrite`: TeX, signs of other alphabets, and motion in words, as a keyboard has them; a name behind a value before it."""
    typed = _with_name_in_front(motion_in_number(by_hand(text)))
    if typed != text:
        trace.took("rewrite", text, typed)
    return typed


def _with_name_in_front(typed: str) -> str:
    """An equation in brackets, behind an arrow, with words behind its name, or turned round, as `F = 86 N`."""
    if (whole := IN_BRACKETS.fullmatch(typed)) is not None:
        typed = whole["equation"]
    typed = ARROW.sub(r"\g<name> = ", typed)
    if (remark := WORDS_BEHIND_NAME.match(typed)) and UNCHANGING.issuperset(remark["words"].lower().split()):
        typed = remark["name"] + typed[remark.end() :]
    if (turned := NAME_BEHIND.fullmatch(typed)) and is_name(turned["name"]):
        typed = f"{turned['name']} = {turned['value']}"
    return typed


def _with_label_behind(typed: str, expected: Unit | None, question: Question | None) -> str:
    """`F [N] = 86` as `F = 86 N`, where the label is a unit of what is asked for."""
    found = LABELLED.fullmatch(typed) if expected is not None else None
    if found is None or not is_name(found["name"], question):
        return typed
    label = found["squared"] or found["round"] or found["led"] or found["below"]
    unit = unit_meant(label.strip(), expected)
    if isinstance(unit, ParseError) or expected is None or not unit.measures(expected):
        return typed
    if found["below"] and question is not None and label.strip() in question.symbol_names:
        return typed  # `v/c` of two letters of the problem
    behind = f"{found['name']} = {found['number'].strip()} {label.strip()}"
    trace.took("rewrite", typed, behind)
    return behind


def _split_uncertainty(normalized: str) -> tuple[str, str]:
    """Stage `split_uncertainty`: the value, and the uncertainty with its unit."""
    value, spread = without_spread(normalized)
    if spread:
        trace.took("split_uncertainty", spread, value)
    return value, spread


def _parse(text: str, normalized: str, expected: Unit | None) -> Reading | ParseError:
    """Stages `parse_number` and `parse_unit`, of a number before a unit, or of a calculation as a whole."""
    with trace.silent():
        found = _alone(text, normalized, expected)
    if isinstance(found, Reading):
        _note(normalized, found)
    return found


def _with_spread(found: Reading, spread: str) -> Reading | ParseError:
    """The value with its uncertainty beside it, as it is shown; refused where that is too wide."""
    if not _is_small(spread, found):
        why = _("the uncertainty is more than a tenth of the value")
        return refused(why, None, _("write one number and a unit"))
    return replace(found, as_read=f"{found.as_read} ± {spread.strip()}")


def _note(normalized: str, found: Reading) -> None:
    """Record the number and the unit that were read: apart where one number stands before one unit, else as one calculation."""
    number = scan_number(normalized)
    rest = "" if isinstance(number, ParseError) else normalized[number[1] :].strip()
    if isinstance(number, ParseError) or number[0].value != found.value or (found.unit is None and rest):
        trace.took("parse_number", normalized, "")
        return
    trace.took("parse_number", normalized[: number[1]], rest)
    if rest:
        trace.took("parse_unit", rest, "")


def _beside_sides(
    sides: Sequence[str], last: Reading, expected: Unit | None, question: Question | None
) -> tuple[Expr, ...] | ParseError:
    """The formulas of givens among the sides before the last; asks about two values that differ, and about what is no name."""
    if way := next((side for side in sides if {word.lower() for word in side.split()} & SIGNS.keys()), ""):
        why = _("{side} stands on the left, not the answer alone", side=way)
        return ParseError("asked", why, None, _("write the number with its sign"))
    open_sides = [
        side for side in sides[-MOST_SIDES:] if not (is_name(side, question) or is_talk(side, question))
    ]
    unread: list[str] = []
    for side in open_sides:
        value = _side_value(side, expected)
        if isinstance(value, ParseError) and is_calculation(side):
            return value.without_place()  # `8.6/0 = 86 N`
        if isinstance(value, ParseError) or (
            value.fit == "wrong dimension"
            and not (
                value.figures > 1 and len(sides) > 1
            )  # in `F = 2 T = 86 N` a letter; not in `F = 86 J = 86 N`
            and has_letters(side, expected, question)
        ):
            unread.append(side)
        elif not _agree(value, last):
            why = _("{one} and {other} are not the same", one=value.as_read, other=last.as_read)
            return ParseError("asked", why, None, _("write one number and a unit"))
    wanted = expected or last.unit or PURE
    if len(sides) == 1 and is_name(sides[0], question) and is_another_given(sides[0], wanted, question):
        why = _(
            "{letter} is a given, and is not measured in {wanted}",
            letter=sides[0].strip(),
            wanted=show(wanted) or "1",
        )
        return ParseError("asked", why, None, _("write the answer without it"))
    if other := next((side for side in sides if another_body(side, question)), ""):
        why = _("{letter} is not what is asked for", letter=other.strip())
        return ParseError("asked", why, None, _("write the answer without it"))
    if other := next((side for side in unread if measures_otherwise(side, wanted.dimension, question)), ""):
        why = _("{formula} does not have the unit {wanted}", formula=other, wanted=show(wanted) or "1")
        return ParseError("asked", why, None, _("write the answer alone"))
    stand_for_it = [gives_what_is_asked(side, wanted.dimension, question) for side in unread]
    formulas = tuple(each for each in stand_for_it if not isinstance(each, bool))
    if named(sides, question) or not unread:
        return formulas
    if wanted.is_angle and (turned := next((side for side in unread if turns(solvable(side, question))), "")):
        return _asked_about(turned, last, wanted, question)
    if len(unread) == 1 and (over := turned_over(unread[0], wanted.dimension, question)) is not None:
        return _solved(unread[0], over, last, wanted)
    if len(unread) == 1 < len(open_sides) and wanted.dimension == ONE and RATIO.fullmatch(unread[0]):
        return ()  # `K_B/K_0 = 15.36/16 = 0.960`
    if any(stand_for_it):
        return formulas
    return _asked_about(unread[0], last, wanted, question)


def _asked_about(side: str, last: Reading, wanted: Unit, question: Question | None) -> ParseError:
    """`2*theta = 180 deg`, solved for its letter and asked about; without a reading where it has no letter to solve for."""
    why = _("{side} stands on the left, not the answer alone", side=side)
    found = solvable(side, question)
    of_angle = turns(found) and wanted.is_angle
    if (
        found is None
        or (found.function and last.unit is not None)
        or not (of_angle or unknown_letter(found.name, question))
    ):
        return ParseError("asked", why, None, _("write one number and a unit"))
    return _solved(side, found, last, wanted)


def _solved(side: str, found: Solved, last: Reading, wanted: Unit) -> ParseError:
    """What a left side gives for the letter it is solved for, to be judged in its place and said."""
    value = solved_value(found, float(last.value))
    if value is None:
        why = _("{side} stands on the left, not the answer alone", side=side)
        return ParseError("asked", why, None, _("write one number and a unit"))
    if turns(found):
        value, its_unit = math.degrees(value), " deg"
    else:
        its_unit = "" if found.function else f" {last.unit.text}" if last.unit is not None else ""
    choice = f"{decimal_text(Fraction(f'{value:.6g}'), 0)}{its_unit}"
    why = gives(side, last.as_read, found, choice)
    how = _("type the angle") if turns(found) and wanted.is_angle else _("write the answer alone")
    return ParseError("asked", why, None, how, (choice,))


def _side_value(side: str, expected: Unit | None) -> Reading | ParseError:
    """A left side as a number with its unit, or as a calculation; `0 - 48000` is a difference there and no range."""
    value = _number_and_unit(side, side, expected)
    if isinstance(value, ParseError):
        value = _worked(side, SHARE_OF.sub(r"\1*", side), expected)
    if isinstance(value, ParseError) and value.status == "asked" and len(value.choices) == 1:
        value = _worked(side, value.choices[0], expected)
    return value


def _agree(one: Reading, other: Reading) -> bool:
    """True if two sides are the same value; a bare number may stand for either unit, or for that of SI: `1 - 3/4 = 0.25 = 25 %`."""
    if one.unit is not None and other.unit is not None and one.unit.dimension != other.unit.dimension:
        # not `86 J = 86 N`, of two numbers that were typed, but `0.43 kg*20/0.1 = 86 N`
        return not one.figures and same_value(float(one.value), float(other.value))
    if any(each.unit is not None and each.unit.offset for each in (one, other)):
        return _are_one_temperature(one, other)
    if same_value(in_si(one), in_si(other)) or _are_zero(one, other):
        return True
    missing = any(each.unit is None and each.fit == "unit missing" for each in (one, other))
    in_si_unit = ((each, beside) for each, beside in ((one, other), (other, one)) if each.unit is None)
    return (missing and same_value(float(one.value), float(other.value))) or any(
        same_value(float(each.value), in_si(beside)) for each, beside in in_si_unit
    )


def _are_one_temperature(one: Reading, other: Reading) -> bool:
    """True if two sides are one temperature; the unit of a calculation may be left to the last side: `290.45 K - 273.15 K = 17.3 °C`."""
    kelvins = in_si(other)
    found = [in_si(one), *([float(one.value)] if one.unit is None else [])]
    in_last_unit = not one.figures and abs(one.value - other.value) <= DEGREES_APART
    return in_last_unit or any(abs(each - kelvins) <= DEGREES_APART for each in found)


def _are_zero(one: Reading, other: Reading) -> bool:
    """True if one of the two is 0 and the other what a calculation leaves of it."""
    return not (one.value and other.value) and max(abs(one.value), abs(other.value)) <= RESIDUE


def _alone(text: str, normalized: str, expected: Unit | None) -> Reading | ParseError:
    """The number, the calculation, or the number said twice, that a text is without what stands around it."""
    normalized = in_digits(normalized, pure=expected is not None and expected.dimension == ONE)
    if (together := _in_several_units(text, normalized, expected)) is not None:
        return together
    if expected is not None and EULER.search(normalized) and not _of_charge(expected):
        worked = _worked(text, normalized, expected, euler=True)
        if isinstance(worked, Reading):
            return worked
    found = _number_and_unit(text, normalized, expected)
    if (
        isinstance(found, Reading)
        and found.fit != "fits"
        and (spaced := GLUED.sub(r" \1 ", normalized)) != normalized
    ):
        worked = _worked(text, spaced, expected)  # `9 m-2 cm` is no power of the metre
        if isinstance(worked, Reading) and worked.fit == "fits":
            return worked
    twice = _same_twice(normalized, expected) if isinstance(found, ParseError) else None
    if twice is not None:
        return twice
    if isinstance(found, ParseError) and found.status == "refused":
        worked = _worked(text, normalized, expected)
        if not isinstance(worked, ParseError) or (worked.choices and worked.position is None):
            return worked
    return found


def _in_several_units(text: str, normalized: str, expected: Unit | None) -> Reading | None:
    """The sum of `1 h 30 min`, `5 ft 3 in`, `1 m 20 cm`: each unit smaller than the one before, and each number less than what fills it."""
    if expected is not None and expected.dimension == UNITS["s"].dimension:
        normalized = clock_in_units(normalized)
    found = SEVERAL.fullmatch(normalized)
    pieces = PIECE.findall(normalized) if found else []
    if len(pieces) < 2:
        return None
    sign = -1 if normalized.lstrip().startswith("-") else 1
    units, total = [read_unit(unit) for _number, unit in pieces], Fraction(0)
    first = units[0]
    if (
        not isinstance(first, Unit)
        or first.offset
        or first.pi != 0
        or (expected and first.dimension != expected.dimension)
    ):
        return None
    figures, before = 0, Fraction(0)
    for (number, _unit), its_unit in zip(pieces, units, strict=True):
        read = scan_number(number)
        if (
            isinstance(read, ParseError)
            or not isinstance(its_unit, Unit)
            or its_unit.dimension != first.dimension
        ):
            return None
        size = read[0].value * its_unit.factor
        if before and not (its_unit.factor < before and size < before):
            return None
        total, before = total + size, its_unit.factor
        figures += max(read[0].figures, 1)
    value = sign * total / first.factor
    as_read = ("-" if sign < 0 else "") + " ".join(f"{number} {unit}" for number, unit in pieces)
    read = reading_of(text, Written(value, figures, figures), first, expected)
    return replace(read, as_read=as_read) if isinstance(read, Reading) else None


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


def _same_twice(normalized: str, expected: Unit | None) -> Reading | ParseError | None:
    """`0.4 (40 %)`, `20 m/s (72 km/h)`: the first of the two, when both say the same; it is refused when they do not."""
    both = TWICE.fullmatch(normalized)
    if both is None:
        return None
    first, second = (
        found
        if isinstance(found := _number_and_unit(each, each, expected), Reading)
        else _worked(each, each, expected)
        for each in both.group(1, 3)
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
    normalized = OF_THAT.sub(lambda found: found["unit"] or "", normalized)
    found = scan_number(normalized)
    if isinstance(found, ParseError):
        return found
    number, end = found
    rest = normalized[end:].strip().rstrip(".")
    if not rest:
        return reading_of(text, number, None, expected)
    at = end + normalized[end:].index(rest[0])
    if rest[0] in "+-" or (rest[0] in "0123456789" and not re.match(r"1\s*/", rest)):
        return refused(_("one number is enough here"), at, _("work it out and write a number and a unit"))
    if rest == "*":
        return refused(_("something is missing behind this sign"), at, _("write one number and a unit"))
    unit = unit_meant(rest.removeprefix("*").strip(), expected)
    return unit.moved(at) if isinstance(unit, ParseError) else reading_of(text, number, unit, expected)


def _of_charge(expected: Unit) -> bool:
    """True where a charge or an energy in electronvolts is asked for: there `e` is the elementary charge."""
    return expected.dimension == CHARGE or CHARGED.search(expected.text) is not None


def _worked(
    text: str, normalized: str, expected: Unit | None, *, euler: bool = False
) -> Reading | ParseError:
    found = worked_out(normalized.translate(ROUND), euler=euler)
    if isinstance(found, ParseError):
        return found
    number = Written(Fraction(f"{found.value:.15g}"), 0, 0)
    in_radians = (
        found.is_angle
        and expected is not None
        and ((expected.is_angle and not expected.bare) or (expected.text == "1" and found.unit is not None))
    )
    its_unit = UNITS["rad"] if in_radians else found.unit
    return reading_of(text, number, its_unit, expected, decimal_text(Fraction(f"{found.value:.6g}"), 0))


def in_si(reading: Reading) -> float:
    """The value in SI as the nearest double but one."""
    ratio, pi = reading.si
    return float(ratio) * math.pi**pi


def placed(error: ParseError, skipped: int, *, rewritten: bool) -> ParseError:
    """The error at its place in what was typed, before which `skipped` characters were left out; at none in TeX rewritten."""
    return error.without_place() if rewritten else error.moved(skipped)


def reading_of(
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
    ).rstrip()
    fit, why = "fits", ""
    pure = expected is None or (expected.dimension == ONE and expected.bare)  # 1 and rad are
    zero = not number.value and not size.offset  # 0 is 0 in every unit, but for a temperature
    if expected is not None and unit is None and not zero and not pure:
        fit = "unit missing"
        why = _(
            "the unit is missing; write for example {example}",
            example=in_convention(f"{as_read} {show(expected)}"),
        )
    elif expected is not None and not size.measures(expected):
        fit, why = "wrong dimension", _misfit(as_read, size, expected)
    return Reading(text, number.value, number.figures, number.least, unit, (ratio, pi), fit, why, as_read)


def _misfit(as_read: str, size: Unit, expected: Unit) -> str:
    wanted, found, example = kind(expected), kind(size), show(expected)
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
