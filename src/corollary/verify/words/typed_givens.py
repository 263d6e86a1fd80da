"""Numbers of givens typed into the words: every student reads them, whatever numbers were drawn."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator
from functools import lru_cache

from corollary.problem.given import Given
from corollary.problem.problem import Problem
from corollary.units.unit import ONE, Unit, canonical
from corollary.verify.words.author_text import AuthorText
from corollary.verify.words.numerals_in_words import TypedNumber, typed_numbers

EXACT = 1e-9  # relative
ROUNDED = 3  # figures from which on a rounded number is no chance
EXAMPLE = re.compile(
    r"(?:such as|for example|for instance|e\.\s?g\.|z\.\s?B\.|zum Beispiel|etwa|f\.\s?eks\.|for eksempel|slik som|wie)"
    r"[^.;\n]{0,40}$",
    re.IGNORECASE,
)
COUNTED = re.compile(
    r"(?:section|exercise|example|figure|fig\.|eq\.|equation|chapter|problem|parts?|table|step|experiment|no\.|page|number|"
    r"abschnitt|aufgabe|abbildung|gleichung|kapitel|teil|tabelle|nummer|avsnitt|oppgave|figur|likning|del|side)\s*$",
    re.IGNORECASE,
)
SMALL_WORDS = """
and or but when while where which that who if as at in on to from for with by of is are was has have the a an then
beside against after before along over under up down towards until per its it he she they how what
und oder aber wenn als auf an in von zu für mit bei über gegen nach vor der die das ein eine ist sind hat wird
og eller men når mens som på i til fra for med ved over mot etter før den det en et er har blir
"""
FOLLOWS = frozenset(SMALL_WORDS.split())
"""Words that may follow a quantity without a unit; before another word a number counts things."""
LEADS = re.compile(
    r"\b(?:at|with|by|is|was|about|bei|mit|um|ist|etwa|ved|med|er|omtrent)\s+\$?$", re.IGNORECASE
)
"""Words before a quantity without a unit."""
LISTED = re.compile(r"\d\)?\s*(?:,|and|to|und|bis|og|til|-|–)\s*$")
CODE_BEFORE = re.compile(r"\b[A-Z][A-Z0-9]+[ -]?$")
"""DN 50, ISO 2768: the name of a part or of a norm."""
LETTER_BEFORE = re.compile(
    r"(?P<letter>\\?[A-Za-z][A-Za-z0-9]*(?:_\{?[A-Za-z0-9,]+\}?)?)\s*\$?\s*(?:=|≈|\\approx|:=)\s*\$?\s*-?$"
)
NOUN = re.compile(r"[^\W\d_]{4,}")


def typed_givens(problem: Problem, texts: Iterable[AuthorText]) -> Iterator[str]:
    """A sentence with its place for each number of a drawn given that stands typed in a text."""
    moving = [each for each in problem.givens if each.grid.count > 1 and not each.words and each.value]
    meant = {_bare(each) for each in problem.meant}
    for each in texts if moving else ():
        if not re.search(r"\d", each.text) and each.kind == "solution":
            continue
        for number in typed_numbers(each.without_tex, each.language):
            if _bare(number.text) in meant or _example(each.without_tex, number):
                continue
            given = next((one for one in moving if _stands_for(number, one, each)), None)
            if given is not None:
                yield f"{each.where(number.start)}: {_sentence(given, number, each)}"
                break  # one text, one complaint


def _sentence(given: Given, number: TypedNumber, each: AuthorText) -> str:
    in_unit = ""
    if number.unit is not None and canonical(number.unit) != canonical(given.unit):
        in_unit = f" in {canonical(number.unit)}"
    hole = f"{{{{{given.symbol}{in_unit}}}}}"
    remedy = f"write {hole}"
    if each.kind in ("title", "meaning", "solution") or "title" in each.what:
        remedy = "leave the number out, for no hole can stand there"
    if each.kind == "hint":
        remedy = f"say it with the letter, ${given.symbol}$"
    return (
        f"{each.what} says {number.text!r}, which is the printed value of {given.symbol} ({given.meaning}), and other students "
        f"have other numbers: {remedy}; or, where this number is meant for everybody, list it: meant: [{_bare(number.text)}]"
    )


def _stands_for(number: TypedNumber, given: Given, each: AuthorText) -> bool:
    """True if the number is the printed value of the given, or is said to be the given."""
    letter = LETTER_BEFORE.search(each.without_tex[: number.start])
    named = letter is not None and same_letter(letter["letter"], given.symbol)
    if number.unit is None:
        printed = abs(float(given.value))
        if not any(math.isclose(value, printed, rel_tol=EXACT) for value in number.values):
            return False
        return named or (letter is None and _bare_quantity(number, given, each))
    if not _same_kind(number.unit, given.unit):
        return False
    if named and each.kind != "solution" and any(number.values):
        return True  # v = 60 km/h beside a v that is drawn
    if letter is not None and not named:
        return False
    return any(_equal(value, number.figures, _in_unit(given, number.unit)) for value in number.values)


def _in_unit(given: Given, unit: Unit) -> float:
    ratio, pi = given.unit.to_si(given.value)
    return abs(unit.from_si(float(ratio) * math.pi**pi))


def _equal(typed: float, figures: int, printed: float) -> bool:
    if not typed:
        return False
    if math.isclose(typed, printed, rel_tol=EXACT):
        return True
    return figures >= ROUNDED and math.isclose(typed, float(f"{printed:.{figures - 1}e}"), rel_tol=EXACT)


def _same_kind(one: Unit, other: Unit) -> bool:
    if one.dimension != other.dimension:
        return False
    return one.dimension != ONE or is_angle(one) == is_angle(other)


def is_angle(unit: Unit) -> bool:
    """True for radians, degrees and the like, and for a solid angle."""
    return unit.is_angle or canonical(unit) == "sr"


def _bare_quantity(number: TypedNumber, given: Given, each: AuthorText) -> bool:
    """True if a number without unit stands where a quantity would: not a count of things, a year, a place in a list."""
    text = each.without_tex
    before, after = text[: number.start], number.rest.lstrip(" $)*_”\"'")
    row = before.rpartition("\n")[2]
    if number.in_formula or (not row.strip(" (-*") and re.match(r"[.)]", after)):
        return False
    if COUNTED.search(before) or before.endswith("(") or LISTED.search(before):
        return False
    if CODE_BEFORE.search(before):
        return False
    value = number.values[0]
    if 1500 <= value <= 2100 and value == int(value) and number.figures == 4:
        return False
    noun = NOUN.match(after)
    named = _meaning_words(given.meaning)
    last = NOUN.search(before.rstrip().rpartition(" ")[2])
    if last is not None and last[0].lower()[:5] == _quantity(given.meaning) and given.unit.dimension != ONE:
        return True  # a crate of mass 80
    if noun is not None and noun[0].lower() not in FOLLOWS:
        return noun[0].lower()[:5] in named and given.unit.dimension == ONE
    near = {word.lower()[:5] for word in NOUN.findall(before[-30:])}
    if _quantity(given.meaning) in near and re.search(r"(?:of|is|von|ist|på|er|av|with|mit|med)\s*$", before):
        return True
    alone = not before.strip() and not after
    if after[:1] in (":", "€", "-", "/", "'", "’", "+") or not (alone or LEADS.search(before)):
        return False
    if given.unit.dimension == ONE and "." not in number.text and "," not in number.text:
        return False  # a count of something else
    follows = re.match(r"[A-Za-zÀ-ÿ]+", after)
    if follows is not None and follows[0].lower() not in FOLLOWS:
        return False
    return len(re.sub(r"\s", "", number.text)) > 1 and (
        number.figures > 1 or "." in number.text or "," in number.text
    )


def _quantity(meaning: str) -> str:
    """The first noun of a meaning, which is the quantity: mass of the crate."""
    noun = NOUN.search(meaning)
    return (
        noun[0].lower()[:5]
        if noun is not None and noun[0].lower() not in ("number", "anzahl", "antall")
        else ""
    )


@lru_cache(maxsize=512)
def _meaning_words(meaning: str) -> frozenset[str]:
    return frozenset(word.lower()[:5] for word in NOUN.findall(meaning))


def _example(text: str, number: TypedNumber) -> bool:
    """True for a number in quotes or behind `such as`: how an answer may be typed."""
    if text[: number.start].endswith(('"', "“", "„", "«", "'", "‘")):
        return True
    return EXAMPLE.search(text[max(0, number.start - 70) : number.start]) is not None


def same_letter(typed: str, symbol: str) -> bool:
    """True if a letter of a text, in TeX or not, is the symbol of a given: `v_0` and `v_{0}` are v0, `\\theta` is theta."""
    return re.sub(r"[\\{}_$, ]", "", typed) == symbol.replace("_", "")


def _bare(text: str) -> str:
    """`50 km/h` and `50\\,\\mathrm{km/h}` compared."""
    return re.sub(r"[\s\N{WORD JOINER}$]", "", text.replace("\N{MINUS SIGN}", "-")).lstrip("-")
