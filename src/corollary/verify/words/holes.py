"""Holes in the words of a problem: the words about them, and holes of two givens exchanged in a translation."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from itertools import combinations

from corollary.problem.given import Given
from corollary.problem.problem import Problem
from corollary.problem.statement import HOLE
from corollary.problem.translation import ProblemTranslation
from corollary.units.unit import Dimension, Unit, canonical, show, unit
from corollary.verify.words.author_text import AuthorText, tex_replaced
from corollary.verify.words.numerals_in_words import typed_numbers, unit_after
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
ASKED = re.compile(
    r"\b(?:what|which|welche\w?|hvilke[nt]?) (?:[^\W\d_]+ )?(?:is|are|ist|sind|er) $", re.IGNORECASE
)
"""`After what time is {{p}} left?` asks for a time, and says nothing of the hole."""
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
    if noun in given.meaning.casefold().partition(" of ")[0].split():  # a molar mass is called a mass
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
    return found["noun"] if found is not None and not ASKED.search(before) else ""


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


WORD = re.compile(r"[^\W\d_]{3,}|\b[A-Z]\b|\b\d\b|[.;:!?](?=\s)")
REACH = 9  # words before a hole that may say what it is
COMMON = frozenset(
    [
        "the",
        "of",
        "and",
        "for",
        "its",
        "von",
        "der",
        "die",
        "das",
        "des",
        "dem",
        "den",
        "und",
        "til",
        "for",
        "den",
        "det",
        "og",
    ]
)
STEM = 5


def exchanged(problem: Problem, texts: Iterable[AuthorText], meanings: Mapping[str, str]) -> Iterator[str]:
    """A sentence with its place for two holes in a text, each of which the words before it say to be the other."""
    givens = {given.symbol: given for given in problem.givens}
    every = list(texts)
    in_words = {
        hole
        for each in every
        if each.kind in ("statement", "part", "option")
        for hole in _places(each.text, givens)
    }
    missing = [name for name in givens if name not in in_words and not givens[name].source]
    for each in every:
        places = _places(each.text, givens)
        for one, other in ((one, other) for one in places for other in missing if each.kind == "statement"):
            if givens[one].unit.dimension != givens[other].unit.dimension:
                continue
            own, others = (
                _distinctive(meanings[one], meanings[other]),
                _distinctive(meanings[other], meanings[one]),
            )
            place = next((at for at in places[one] if _nearest(each.text, at, own, others) == 2), None)
            if place is not None:
                yield (
                    f"{each.where(place, each.text)}: {each.what}: {{{{{one}}}}} stands where the words are about {meanings[other]}, "
                    f"whose {{{{{other}}}}} is nowhere: is it meant?"
                )
        for one, other in combinations(places, 2):
            if givens[one].unit.dimension != givens[other].unit.dimension or not (
                places[one] and places[other]
            ):
                continue
            if _swapped(each.text, places[one][0], places[other][0], meanings[one], meanings[other]):
                yield (
                    f"{each.where(places[one][0], each.text)}: {each.what}: {{{{{one}}}}} stands where the words are about "
                    f"{meanings[other]}, and {{{{{other}}}}} where they are about {meanings[one]}: exchange them"
                )


def _places(text: str, givens: Mapping[str, Given]) -> dict[str, list[int]]:
    found: dict[str, list[int]] = {}
    for hole in HOLE.finditer(text):
        letter = hole["formula"].strip()
        if letter in givens and not givens[letter].words:
            found.setdefault(letter, []).append(hole.start())
    return found


def _swapped(text: str, one: int, other: int, mine: str, theirs: str) -> bool:
    """True if the nearest of the distinctive words before each hole is one of the other's."""
    own, others = _distinctive(mine, theirs), _distinctive(theirs, mine)
    return (
        bool(own and others)
        and _nearest(text, one, own, others) == 2
        and _nearest(text, other, own, others) == 1
    )


def _distinctive(mine: str, theirs: str) -> frozenset[str]:
    return frozenset(_stems(mine)) - frozenset(_stems(theirs))


def _stems(text: str) -> list[str]:
    return [
        word if len(word) == 1 else word.lower()[:STEM]
        for word in WORD.findall(text)
        if word.lower() not in COMMON
    ]


def _nearest(text: str, place: int, own: frozenset[str], others: frozenset[str]) -> int:
    """1 or 2 for the set of which a word stands nearest before a place, in its sentence; 0 for neither."""
    before = WORD.findall(HOLE.sub(" ", text[:place]))[-REACH:]
    for word in reversed(before):
        if word in (".", ";", "!", "?"):
            return 0
        stem = word if len(word) == 1 else word.lower()[:STEM]
        if stem in own or stem in others:
            return 1 if stem in own else 2
    return 0


def translated_otherwise(problem: Problem, found: ProblemTranslation, language: str) -> Iterator[str]:
    """A sentence with its place for holes that a translation doubles or leaves out, and for numbers that are others in it."""
    pairs: list[tuple[int, str, str, str]] = [
        (1, "the alt text", problem.figure_alt, found.alt),
        (1, "the statement", problem.statement, found.statement),
    ]
    for part in problem.parts:
        if (theirs := found.parts.get(part.id)) is not None:
            pairs.append((theirs.line, f"part {part.id}", part.text, theirs.text))
            texts = {each.letter: each.text for each in theirs.options}
            pairs += [
                (
                    theirs.line,
                    f"option {each.letter} of part {part.id}",
                    each.text,
                    texts.get(each.letter, ""),
                )
                for each in part.options
            ]
    pairs += [
        (found.lines.get(text, 1), f"the translation of {text[:40]!r}", text, theirs)
        for text, theirs in found.texts.items()
    ]
    givens = {given.symbol: given for given in problem.givens}
    for line, what, original, theirs in pairs:
        if not original or not theirs:
            continue
        mine = AuthorText(found.path, what, theirs, line, language)
        yield from _other_holes(mine, original, givens)
        yield from _other_numbers(mine, AuthorText(problem.path, what, original, 1))


def _other_holes(mine: AuthorText, original: str, givens: Mapping[str, Given]) -> Iterator[str]:
    ours, theirs = _order(original), _order(mine.text)
    counted, counted_there = Counter(ours), Counter(theirs)
    if set(ours) != set(theirs):
        return  # which is complained of already
    if counted != counted_there:
        named = ", ".join(
            f"{{{{{hole}}}}} {counted_there[hole]} times, the original {counted[hole]}"
            for hole in sorted(counted)
            if counted[hole] != counted_there[hole]
        )
        yield f"{mine.where(0, mine.text)}: {mine.what} has {named}: one is missing, or stands in the place of another"
    elif ours != theirs:
        for one, other in combinations(dict.fromkeys(ours), 2):
            if one not in givens or other not in givens:
                continue
            if givens[one].unit.dimension != givens[other].unit.dimension:
                continue
            pair = [hole for hole in ours if hole in (one, other)]
            if pair != [hole for hole in theirs if hole in (one, other)]:
                place = next(
                    each.start()
                    for each in HOLE.finditer(mine.text)
                    if each["formula"].strip() in (one, other)
                )
                yield (
                    f"{mine.where(place, mine.text)}: {mine.what} has {{{{{one}}}}} and {{{{{other}}}}} in another order than the "
                    "original, and both measure the same: exchange them, or let the words keep the order"
                )


def _order(text: str) -> list[str]:
    return [each["formula"].strip() for each in HOLE.finditer(text)]


def _other_numbers(mine: AuthorText, original: AuthorText) -> Iterator[str]:
    """Numbers of two figures and more, or with a unit, that the original does not have."""
    known = {value for each in typed_numbers(original.without_tex) for value in each.values}
    for number in typed_numbers(mine.without_tex, mine.language):
        if known.isdisjoint(number.values) and (number.unit is not None and number.text[:1].isdigit()):
            yield (
                f"{mine.where(number.start)}: {mine.what} says {number.text!r}, a number that the original does not have"
            )
