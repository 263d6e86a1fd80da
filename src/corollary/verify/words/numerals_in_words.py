"""Numbers with their units as people write them in running text, in TeX, and in words."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

from corollary.units.unit import Unit, read_unit, unit
from corollary.verify.words.author_text import INLINE

GROUPED = r"\d{1,3}(?: \d{3})+(?:[.,]\d+)?"
NUMERAL = re.compile(
    rf"(?<![\w.,^{{\\/])(?P<sign>-)?(?P<digits>{GROUPED}|\d+(?:['’]\d{{3}})+|\d+(?:[.,]\d+)*)"
    r"(?P<power>\s?[·×*]\s?10(?:\^?\{?(?P<ten>[-+]?\d+)\}?|(?P<raised>[⁻⁺]?[⁰¹²³⁴-⁹]+))|[eE](?P<e>[-+]?\d+))?"
)
WORD_UNIT = r"[A-Za-zµμΩΩ°%ℓÅåøöéè]"
AFTER = re.compile(rf"(?P<gap> ?\$? ?[{INLINE}]? ?|-)(?P<unit>{WORD_UNIT}[^,;:!?\n$\"|\[\]\u25a1]{{0,40}})")
SENTENCE_END = re.compile(r"(?<=[^\W_])\.(?=\s)")
LOOK_LIKE_UNITS = """
a as at in is am an to of e d u t de da der die das den en et er og und i im um au the and or on per men mal ha pm l
"""
STOP = frozenset(LOOK_LIKE_UNITS.split())
LETTERS_OF_UNITS = frozenset("dltu")
"""Units of one letter: behind a number they are meant, alone they are not; no product of units ends in another word of STOP."""
NUMBER_WORDS = {
    "en": "one two three four five six seven eight nine ten eleven twelve",
    "de": "ein zwei drei vier fünf sechs sieben acht neun zehn elf zwölf",
    "nb": "en to tre fire fem seks sju åtte ni ti elleve tolv",
}
TENS = {
    "en": "twenty thirty forty fifty sixty seventy eighty ninety hundred",
    "de": "zwanzig dreißig vierzig fünfzig sechzig siebzig achtzig neunzig hundert",
    "nb": "tjue tretti førti femti seksti sytti åtti nitti hundre",
}
RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")
SPOKEN_UNITS = (
    (re.compile(r"\bper time\b|\bi timen\b"), "per hour"),
    (re.compile(r"\b(?:square|Quadrat-?|kvadrat-?)\s?([A-Za-z]+)", re.IGNORECASE), r"\1^2"),
    (re.compile(r"\b(?:cubic|Kubik-?|kubikk-?)\s?([A-Za-z]+)", re.IGNORECASE), r"\1^3"),
    (re.compile(r"\bper ?cent\b"), "%"),
    (re.compile(r"\bZenti", re.IGNORECASE), "centi"),
    (re.compile(r"\bMikro", re.IGNORECASE), "micro"),
    (re.compile(r"\bmetres?\b"), "meter"),
    (re.compile(r"\b([Kk]ilo|[Cc]enti|[Mm]illi)metres?\b"), r"\1meter"),
    (re.compile(r"\bdegrees? (?:Celsius|centigrade)\b"), "degC"),
    (re.compile(r"\bGrad Celsius\b|\bgrader celsius\b"), "degC"),
)


@dataclass(frozen=True, slots=True)
class TypedNumber:
    """A numeral in a text: what it may mean (`1,200` has two readings), its figures, its unit (None where none follows)."""

    start: int
    end: int
    text: str
    values: tuple[float, ...]
    figures: int
    unit: Unit | None
    in_formula: bool
    rest: str


def typed_numbers(text: str, language: str = "en") -> Iterator[TypedNumber]:
    """The numerals of a plain text, but for exponents, indices, fractions and coefficients of letters."""
    for found in NUMERAL.finditer(text):
        in_formula = text.count("$", 0, found.start()) % 2 == 1
        after = text[found.end() : found.end() + 1]
        if after == "/" and text[found.end() + 1 : found.end() + 2].isdigit():
            continue
        measured, end = unit_after(text, found.end(), in_formula)
        if (
            measured is None
            and not in_formula
            and (letter := re.match(r" ([dltu])(?![\w^=])", text[found.end() :]))
        ):
            measured, end = unit(letter[1]), found.end() + letter.end()
        if measured is None and (after.isalpha() or after in ("_", "\\") or (in_formula and after == "(")):
            continue  # a coefficient, as in 2R
        if measured is None and in_formula and re.match(r"\s*\\?[A-Za-z(]", text[found.end() :]):
            continue
        values = readings(found)
        digits = re.sub(r"\D", "", found["digits"]).lstrip("0")
        if values:
            yield TypedNumber(
                found.start(),
                end,
                " ".join(text[found.start() : end].replace(INLINE, "").replace("$", "").split()),
                values,
                len(digits),
                measured,
                in_formula,
                text[end : end + 60],
            )
    yield from _spelt(text, language)


def readings(found: re.Match[str]) -> tuple[float, ...]:
    """The values that a numeral may have."""
    digits = re.sub(r"[ '’]", "", found["digits"])
    marks = set(re.findall(r"[.,]", digits))
    if len(marks) == 2:
        last = max(digits.rfind("."), digits.rfind(","))
        several = {re.sub(r"[.,]", "", digits[:last]) + "." + digits[last + 1 :]}
    elif re.fullmatch(r"\d{1,3}(?:[.,]\d{3})+", digits):
        several = {re.sub(r"[.,]", "", digits)}
        if digits.count(".") + digits.count(",") == 1:
            several.add(digits.replace(",", "."))
    elif digits.count(".") + digits.count(",") > 1:
        return ()  # a date, the number of a section
    else:
        several = {digits.replace(",", ".")}
    power = found["ten"] or found["e"] or (found["raised"] or "0").translate(RAISED)
    if len(power) > 3:
        return ()
    return tuple(float(each) * 10.0 ** int(power) for each in sorted(several))


def unit_after(text: str, at: int, in_formula: bool) -> tuple[Unit | None, int]:
    """The unit that begins at a place of a plain text, and where it ends; None and the place where there is none."""
    found = AFTER.match(text, at)
    if found is None:
        return None, at
    if in_formula and "$" not in found["gap"] and INLINE not in found["gap"] and found["unit"][0] not in "°%":
        return None, at
    sentence = SENTENCE_END.split(found["unit"])[0]
    ends = [
        each.end()
        for place, each in enumerate(re.finditer(r"\S+", sentence))
        if not (place and each[0] in STOP - LETTERS_OF_UNITS)
    ][:4]
    for last in reversed(ends):
        written = found["unit"][:last]
        words = written.rstrip(".").replace(INLINE, "")
        words = words if words.count("(") == words.count(")") else words.rstrip(")")
        measured = known_unit(words)
        if measured is not None:
            return measured, found.start("unit") + len(written.rstrip("." if "(" in words else ".)"))
    return None, at


@lru_cache(maxsize=4096)
def known_unit(words: str) -> Unit | None:
    """A unit in signs or in words; None for what is none, and for words that only look like one."""
    if words in STOP or len(words) > 40 or not re.match(WORD_UNIT, words):
        return None
    for spoken, by in SPOKEN_UNITS:
        words = spoken.sub(by, words)
    if re.search(r"[a-z]{3,} [A-Za-z]{2,}", words) and not re.search(r"\b(?:per|pro)\b|second|sekund", words):
        return None  # two words of a sentence
    if len(words) < 3 and words.islower() and words in STOP:
        return None
    found = read_unit(words)
    return found if isinstance(found, Unit) else None


def _spelt(text: str, language: str) -> Iterator[TypedNumber]:
    """Numbers in words, where a unit follows: `fifty kilometres per hour`."""
    values = _spelt_values(language)
    pattern = "|".join(sorted(values, key=len, reverse=True))
    for found in re.finditer(rf"\b(?:{pattern})\b(?=[ -])", text, re.IGNORECASE):
        measured, end = unit_after(text, found.end(), False)
        if measured is not None and end - found.end() > 3:  # words, not a letter
            words, value = text[found.start() : end], values[found[0].lower()]
            figures = len(f"{value:g}")
            yield TypedNumber(
                found.start(), end, words, (value,), figures, measured, False, text[end : end + 60]
            )


@lru_cache(maxsize=8)
def _spelt_values(language: str) -> dict[str, float]:
    small = NUMBER_WORDS.get(language, NUMBER_WORDS["en"]).split()
    tens = TENS.get(language, TENS["en"]).split()
    found = {word: float(place) for place, word in enumerate(small, 1)}
    for place, ten in enumerate(tens, 2):
        found[ten] = 10.0 * place
        for ones, word in enumerate(small[:9], 1):
            found[
                f"{ten}-{word}" if language == "en" else f"{word}und{ten}" if language == "de" else ten + word
            ] = 10.0 * place + ones
    return found
