"""One number out of what a student handed in: a machine number, or a text with a unit; else a formula."""

from __future__ import annotations

import math
import re
from dataclasses import replace

from corollary.answers.answer import Blank, Formulas, Numbers, Unclear
from corollary.answers.doubts import TABLE
from corollary.answers.formula import (
    EQUALS,
    as_typed,
    dimension_in,
    fitting,
    formula,
    formulas,
    other_dimension,
)
from corollary.answers.machine_number import exact, machine, sure
from corollary.answers.quantity import Reading, read_quantity
from corollary.answers.question import Question
from corollary.answers.unit_meant import STANDARD_GRAVITY
from corollary.formula.abbreviations import calculator_words
from corollary.formula.errors import ParseError, sentence
from corollary.formula.value import (
    Complex,
    Exact,
    Items,
    Measured,
    Named,
    Nothing,
    Real,
    Refused,
    Text,
    Value,
)
from corollary.messages import catalogue, in_convention
from corollary.units.unit import Unit, show

_ = catalogue(__name__)

# What stands for no answer: the blank itself, and what people leave where they mean to come back.
PLACEHOLDERS = {"", "...", "…", "?", "None"}
# A text with an operator that does not begin with digits was meant as a formula; then the formula's trouble is told.
FORMULA, OWN_NUMBER = re.compile(r"[*^/()·√]"), re.compile(r"^\W*[0-9]")
INVERSE = re.compile(
    r"\\?(?P<of>sin|cos|tan|cot)\s*(?:\^\s*(?:-\s*1|[({]\s*-\s*1\s*[)}])|\*\*\s*\(-1\)|⁻¹)(?=\s*(?:\\left\s*)?[({\[])"
)
DIGIT, LONGEST_WITH_WORDS = re.compile(r"[0-9]"), 200
WORDS_BEFORE = re.compile(r"\s*(?P<words>[^\W\d_]{2,}(?:\s+[^\W\d_]+)*)\s*[:,]?\s+(?=[-+−]?\s?[0-9.,])")
SEVERAL = re.compile(
    r"^\s*[(\[][^()\[\]]*[0-9][,;\s]+[^()\[\]]*[0-9][^()\[\]]*[)\]]|[0-9][^0-9]*(?:[;,]\s|\band\b)[^0-9]*[0-9]"
)
SHARES = frozenset({"%", "‰"})
TURNS = re.compile(r"\b(?:turns?|revolutions?|rotations?|umdrehung\w*|omdreining\w*)\b", re.IGNORECASE)
AMBIGUOUS = re.compile(r"[0-9]+(?:[.,][0-9]+)?\([0-9]+\)|[0-9]+(?:[.,][0-9]+)+")


def scalar(value: Value, question: Question) -> Numbers | Formulas | Blank | Unclear:
    """One number in SI, or a formula of the givens when the text is one."""
    unit = question.unit
    while isinstance(value, (Items, Named)) and len(value.items) == 1:
        value = value.items[0]
    match value:
        case Nothing():
            return Blank()
        case Real(number):
            found = machine(number, unit)
            return found if isinstance(found, Unclear) else with_share(found, unit)
        case Exact(number):
            return with_share(exact(number, unit), unit)
        case Complex(real, imaginary):
            if abs(imaginary) <= 1e-12 * abs(real) or imaginary == 0:
                return machine(real, unit)
            return Unclear(
                _("this is a complex number; a measured quantity is real"), f"{real:g} + {imaginary:g}i"
            )
        case Measured(number, of):
            return _measured(number, of, question)
        case Text(text):
            return typed(text, question)
        case Items(items) | Named(_, items):
            return Unclear(_("one number is asked for, not {count}", count=len(items)), _("a list"))
        case Refused():
            return turned_away(value)


def _measured(number: float, its_unit: str, question: Question) -> Numbers | Formulas | Blank | Unclear:
    """A quantity of the student's own library of units: its digits are those of a machine number."""
    found, digits = typed(f"{number!r} {its_unit}", question), machine(number, question.unit)
    if isinstance(found, Numbers) and isinstance(digits, Numbers):
        return replace(found, figures=digits.figures, most=digits.most)
    return digits if isinstance(digits, Unclear) else found


def turned_away(value: Refused) -> Unclear:
    """A value from which no answer can be read; what is wrong with it is a predicate, `is a set`."""
    return Unclear(_("it {predicate}", predicate=value.why), value.excerpt)


def typed(text: str, question: Question) -> Numbers | Formulas | Blank | Unclear:
    """A text: a number with a unit; else a formula of the givens, if its dimension is what is asked for."""
    if text.strip() in PLACEHOLDERS:
        return Blank()
    unit = question.unit
    if unit.text in ("rad", "deg"):  # where an angle is asked for, `cos^-1(…)` is one
        text = INVERSE.sub(r"arc\g<of>", text)
    found = read_quantity(text, unit, question)
    own_gravity = (
        isinstance(found, Reading) and found.unit == STANDARD_GRAVITY and "g" in question.symbol_names
    )
    if isinstance(found, Reading) and found.fit != "wrong dimension" and not own_gravity:
        return with_share(_in_turns(from_reading(found, unit), found, question), unit)
    if (
        isinstance(found, ParseError)
        and found.status == "asked"
        and found.position is None
        and (found.choices or EQUALS.search(text))
    ):
        several = meanings(found, text, unit)
        return Unclear(sentence(found), as_typed(text), several, benefit=bool(several))
    tree = formula(text, question)
    if isinstance(tree, ParseError) and tree.status == "asked":
        tree = fitting(text, question) or tree
    if isinstance(tree, Unclear):
        return tree
    looks_like_one = FORMULA.search(text) and not OWN_NUMBER.search(text) and not TABLE.search(text)
    if not isinstance(tree, ParseError):
        dimension = dimension_in(tree, question)
        if dimension == unit.dimension:
            return formulas(tree, typed=text)
        if isinstance(found, ParseError) or looks_like_one:
            why = (
                sentence(dimension)
                if isinstance(dimension, ParseError)
                else other_dimension(tree, dimension, unit)
            )
            return Unclear(why, as_typed(text))
    if isinstance(found, ParseError):
        if isinstance(tree, ParseError) and looks_like_one and not _words_before(text, question):
            return Unclear(sentence(tree), as_typed(text))
        several = meanings(found, text, unit)
        return Unclear(_explained(found, text, question), as_typed(text), several, benefit=bool(several))
    return from_reading(found, unit)


def with_share(found: Numbers, unit: Unit) -> Numbers | Unclear:
    """The number; asked about where it is less than 1, has no unit, and a share in percent is asked for: 0.497 is 49.7 %."""
    (value,) = found.values
    if unit.text not in SHARES or found.sizes or not 0 < abs(value) < unit.si:
        return found
    number, sign = value / unit.si, show(unit)
    share = f"{number / unit.si:.6g} {sign}"
    why = _(
        "{number} can be {small} or {large}; write its unit",
        number=found.as_read.removesuffix(sign).strip(),
        small=f"{number:.6g} {sign}",
        large=share,
    )
    meant = tuple(
        replace(found, values=(each,), as_read=text, missing="", sizes=(unit.si,), zeros=(0.0,))
        for each, text in ((number, share), (value, f"{number:.6g} {sign}"))
    )
    return Unclear(why, found.as_read, meant, benefit=True)


def _in_turns(found: Numbers, read: Reading, question: Question) -> Numbers:
    """An angle as a number of turns, where turns are counted: 1000 rad are 159 of them."""
    if (
        read.unit is None
        or not read.unit.is_angle
        or question.unit.text != "1"
        or not TURNS.search(question.title)
    ):
        return found
    turn = 2 * math.pi
    return replace(found, values=(found.values[0] / turn,), sizes=(read.unit.si / turn,))


def _explained(trouble: ParseError, text: str, question: Question) -> str:
    """What is said of a text that is no number: what a student sees in it, rather than where the reading stopped."""
    if trouble.status != "refused":
        return sentence(trouble)
    if words := _words_before(text, question):
        return _(
            "\u201c{words}\u201d in front of the number is not understood; write one number and a unit",
            words=words,
        )
    if DIGIT.search(text) is None:
        return _("there is no number in this; write one number and a unit")
    if text.count("(") > text.count(")"):
        return _("a bracket is never closed")
    if SEVERAL.search(text):
        return _("one number is asked for, not several")
    return sentence(trouble)


def _words_before(text: str, question: Question) -> str:
    """The words before a number that are neither letters of the problem nor functions; "" where there are none."""
    found = WORDS_BEFORE.match(text)
    if found is None or len(text) > LONGEST_WITH_WORDS:
        return ""
    known = calculator_words().keys() | set(question.symbol_names)
    words = found["words"].split()
    return "" if any(word in known for word in words) else found["words"]


def meanings(trouble: ParseError, text: str, unit: Unit) -> tuple[Numbers, ...]:
    """What an ambiguous text could mean: each choice put in the place of the number it is about."""
    if trouble.choices and trouble.position is None:  # a left side that was solved
        found = (read_quantity(choice, unit) for choice in trouble.choices)
        return tuple(
            from_reading(each, unit)
            for each in found
            if isinstance(each, Reading) and each.fit != "wrong dimension"
        )
    number = (
        AMBIGUOUS.search(text) if trouble.status == "asked" else None
    )  # only a text short enough to be read is asked about
    if number is None:
        return ()
    read = (
        read_quantity(text[: number.start()] + choice + text[number.end() :], unit)
        for choice in trouble.choices
    )
    return tuple(
        from_reading(each, unit)
        for each in read
        if isinstance(each, Reading) and each.fit != "wrong dimension"
    )


def from_reading(found: Reading, unit: Unit) -> Numbers:
    ratio, pi = found.si
    try:
        value = float(ratio) * math.pi**pi
    except OverflowError:
        value = math.inf if ratio > 0 else -math.inf
    size = (found.unit.si,) if found.unit is not None else ()
    zero = (0.0 if unit.is_difference else float(found.unit.offset),) if found.unit is not None else ()
    missing = _in_parts_unit(found, unit) if found.fit == "unit missing" else ""
    misfit = found.why if found.fit == "wrong dimension" else ""
    polar = (from_reading(found.polar[0], unit), from_reading(found.polar[1], unit)) if found.polar else None
    figures = (sure(found.least, found.figures),)
    return Numbers(
        (value,),
        figures,
        found.as_read,
        missing,
        misfit,
        sizes=size,
        polar=polar,
        beside=found.beside,
        zeros=zero,
    )


def _in_parts_unit(found: Reading, unit: Unit) -> str:
    """What is said of a number without the unit that it needs, beside how it was read."""
    better = in_convention(f"{found.as_read}{'' if unit.text == 'deg' else ' '}{show(unit)}")
    return _("taken in {unit}; better write {better}", unit=show(unit), better=better)
