"""The texts of a record read: givens with units and ranges, what is asked, conventions."""

from __future__ import annotations

import re

from corollary.audit.record import AskedLetter, AssumedValue, StatedGiven
from corollary.formula.errors import ParseError, sentence
from corollary.formula.numerals import TO_ASCII, Written, scan_number
from corollary.problem.givens import SYMBOL
from corollary.units.unit import PURE, Unit, unit

RANGE = re.compile(r"\s*(\S+?)\s*(?:\.\.|…)\s*(.+)")
LETTER = re.compile(r"[A-Za-z][A-Za-z0-9_]*$")
ASSUMED = re.compile(r"\s*([A-Za-z][A-Za-z0-9_]*)\s*=\s*(.+)")
OR = re.compile(r"\s*(?:,|\bor\b)\s*")


def given_from(symbol: str, text: str) -> StatedGiven:
    """`2 kg`, `2..5 kg`, `30 deg`, `0.25`, or a unit alone. Raises ValueError with a sentence."""
    if not SYMBOL.match(symbol):
        raise ValueError(f"{symbol!r} is no letter; use a letter, then letters, digits or _")
    typed = text.translate(TO_ASCII).strip()
    spread = RANGE.fullmatch(typed)
    if spread is not None:
        low, _ = _number(spread[1], text)
        high, rest = _number(spread[2], text)
        if not low.value < high.value:
            raise ValueError(f"{text!r} is no range: the smaller number comes first, as in 2..5 kg")
        return StatedGiven(symbol, _unit(rest), low.value, high.value)
    if re.match(r"1\s*/\s*[^\d\s.,]", typed) or not re.match(r"[-+]?\s*[\d.,½⅓⅔¼¾]", typed):
        return StatedGiven(symbol, unit(typed), None, None)
    number, rest = _number(typed, text)
    return StatedGiven(symbol, _unit(rest), number.value, number.value, number.figures)


def asked_from(text: str) -> AskedLetter:
    """`v`, or `v in km/h`. Raises ValueError with a sentence."""
    letter, mark, its_unit = text.strip().partition(" in ")
    if not LETTER.match(letter.strip()):
        raise ValueError(
            f"{text!r} asks for no letter; write one of the laws' letters, as in `v` or `v in km/h`"
        )
    return AskedLetter(letter.strip(), unit(its_unit.strip()) if mark else None)


def assumed_from(text: str) -> AssumedValue | None:
    """`g = 9.8 m/s^2`, `g = 9.8 or 9.81 m/s^2`; None for a convention in words. Raises ValueError with a sentence."""
    found = ASSUMED.fullmatch(text)
    if found is None or re.search(r"\d", found[2]) is None:
        return None
    *others, last = OR.split(found[2].strip())
    number, rest = _number(last, text)
    values = [_number(each, text)[0].value for each in others]
    return AssumedValue(found[1], _unit(rest), (*values, number.value))


def _number(text: str, whole: str) -> tuple[Written, str]:
    found = scan_number(text.strip())
    if isinstance(found, ParseError):
        raise ValueError(f"{whole!r}: {sentence(found)}")
    number, end = found
    return number, text.strip()[end:].strip()


def _unit(text: str) -> Unit:
    return unit(text) if text else PURE
