"""Holes and the words about them: the letter or the quantity named before a hole, and the unit behind it."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import lru_cache

from corollary.problem.given import Given
from corollary.problem.problem import Problem
from corollary.problem.statement import HOLE
from corollary.units.unit import Dimension, Unit, canonical, show, unit
from corollary.verify.words.author_text import AuthorText, tex_replaced
from corollary.verify.words.numerals_in_words import unit_after
from corollary.verify.words.typed_givens import same_letter

LETTER_IS = re.compile(
    r"(?<![A-Za-z0-9_\\/+*^Δ-])(?<!\\Delta )(?<!\\Delta)(?<!\\mid )(?P<letter>\\?[A-Za-z][A-Za-z0-9]*(?:_\{?[A-Za-z0-9,]+\}?)?)\s*\$?\s*=\s*\$?\s*$"
)
QUANTITIES = {
    "kg": "mass masses Masse masse massen",
    "m/s": "speed velocity Geschwindigkeit Schnelligkeit fart farten hastighet hastigheten",
    "m": "length height distance radius diameter depth width thickness wavelength "
    "Länge Höhe Abstand Radius Durchmesser Tiefe Breite lengde lengden høyde høyden avstand radius bredde",
    "s": "time duration period Zeit Dauer Periode tid tiden varighet periode",
    "N": "force Kraft Gewichtskraft kraft kraften",
    "m/s^2": "acceleration Beschleunigung akselerasjon akselerasjonen",
    "K": "temperature Temperatur temperatur temperaturen",
    "V": "voltage Spannung spenning spenningen",
    "A": "current strømstyrke Stromstärke",
    "Pa": "pressure Druck trykk trykket",
    "W": "power Leistung effekt effekten",
}
BEFORE = re.compile(r"(?P<noun>[^\W\d_]{3,})(?: of| von| på| is| er| ist)?(?: about)? $")


@lru_cache(maxsize=1)
def _measured() -> dict[str, Dimension]:
    return {noun: unit(si).dimension for si, nouns in QUANTITIES.items() for noun in nouns.split()}


def mislabelled(problem: Problem, texts: Iterable[AuthorText]) -> Iterator[str]:
    """A sentence with its place for each hole that the words about it contradict."""
    givens = {given.symbol: given for given in problem.givens}
    for each in texts:
        for found in HOLE.finditer(each.text):
            given = givens.get(found["formula"].strip())
            if given is None or given.words:
                continue
            before = tex_replaced(each.text[: found.start()])[-60:]
            why = _contradiction(given, before, givens) or _wrong_quantity(each.text, given, before, givens)
            if why := why or _unit_behind(each.text, found, given):
                yield f"{each.where(found.start(), each.text)}: {each.what}: {why}"


def _contradiction(given: Given, before: str, givens: dict[str, Given]) -> str:
    letter = LETTER_IS.search(before)
    if letter is not None:
        meant = next((other for name, other in givens.items() if same_letter(letter["letter"], name)), None)
        if meant is not None and meant.symbol != given.symbol:
            return (
                f"{letter['letter']} = {{{{{given.symbol}}}}} shows the value of {given.symbol} ({given.meaning}) for {meant.symbol} "
                f"({meant.meaning}): write {{{{{meant.symbol}}}}}, or the other letter"
            )
    return ""


def _wrong_quantity(text: str, given: Given, before: str, givens: dict[str, Given]) -> str:
    """What is wrong where `mass {{v}}` stands, and nothing in the text is said to be the mass that is given."""
    noun = _noun(before)
    measured = _measured().get(noun)
    if measured is None or measured == given.unit.dimension:
        return ""
    others = {name for name, each in givens.items() if each.unit.dimension == measured}
    if not others or any(
        _measured().get(_noun(tex_replaced(text[: each.start()])[-60:])) == measured
        for each in HOLE.finditer(text)
        if each["formula"].strip() in others
    ):
        return ""
    return f"{noun} {{{{{given.symbol}}}}}: {given.symbol} is in {show(given.unit) or 'no unit'} ({given.meaning}); which hole is meant?"


def _noun(before: str) -> str:
    found = BEFORE.search(before)
    return found["noun"] if found is not None else ""


def _unit_behind(text: str, found: re.Match[str], given: Given) -> str:
    """What is wrong with the unit typed behind a hole: it stands there twice, or is not that of the number."""
    in_formula = text.count("$", 0, found.start()) % 2 == 1
    rest = tex_replaced(text[found.end() : found.end() + 60])
    typed, end = unit_after(rest, 0, in_formula)
    if typed is None or (end < 2 and not rest.startswith(("%", "°"))):
        return ""
    words = rest[:end].strip(" $\N{WORD JOINER}")
    bare = found["style"] == "number" or found["style"] == "svg"
    own = unit(found["unit"]) if found["unit"] else given.unit
    whole = f"{found[0]} {words}"
    if not bare:
        if typed.dimension == own.dimension and canonical(own) != "1" and not _may_be_a_word(words):
            return f"{whole} has two units, for the hole brings {show(own)} along: leave {words} out, or write {{{{{given.symbol}|number}}}}"
        return ""
    if typed.dimension != own.dimension and not _may_be_a_word(words):
        return f"{whole}: {given.symbol} is in {show(own) or 'no unit'}, which measures something else"
    if typed.dimension == own.dimension and not _equal(typed, own):
        return f"{whole}: the number is in {show(own)}; write {{{{{given.symbol} in {canonical(typed)}}}}}"
    return ""


def _equal(one: Unit, other: Unit) -> bool:
    return (one.factor, one.pi, one.offset) == (other.factor, other.pi, other.offset)


def _may_be_a_word(words: str) -> bool:
    return (len(words) == 1 and words in "AaICdehtu") or words.lower() in ("turns", "rounds")
