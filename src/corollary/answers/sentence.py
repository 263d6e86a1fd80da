"""Quantities in sentences, `there are 1.77 kg of nitrogen in the bottle`, with the words that may change them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.answers.changing_words import CHANGING, DENIED, OF_CHANGE, words_of
from corollary.answers.number_words import NUMBERS
from corollary.answers.preamble import HALF_OF_A_NAME, OF_A_SIGN
from corollary.answers.question import Question
from corollary.answers.sign_words import SIGNS
from corollary.answers.unit_meant import unit_meant
from corollary.units.unit import Unit, read_unit

LONGEST, MOST_WORDS = 200, 30
NUMBER = re.compile(
    r"(?<![\w.,/^*])[-+−]?\s?(?:[0-9]+(?:[.,][0-9]+)?|[.,][0-9]+)(?:[eE][-+−]?[0-9]+|\s?[x×·*]\s?10(?:\^|\*\*)[({]?[-+−]?[0-9]+[)}]?|\s?[x×·]\s?10[⁻⁰¹²³⁴-⁹]+)?"
)
OTHER_SIGNS = re.compile(r"[^\w\s,.;:()'’-]|_")
WORD = re.compile(r"[^\W\d_]+(?:['’][^\W\d_]+)?")
OF_ORDER = frozenset({"first", "second", "third", "other", "before", "initial", "initially", "last", "next"})
MOST_TOKENS = 4


@dataclass(frozen=True, slots=True)
class QuantitySentence:
    """The quantities of a sentence, and the words before each and behind the last; `turned`: a word among them may be a sign."""

    quantities: tuple[str, ...]
    words: tuple[str, ...]
    turned: bool


def sentence_in(text: str, count: int, question: Question) -> QuantitySentence | None:
    """The sentence that a text is, with so many quantities; None where it has other signs, or a word that changes a quantity."""
    if len(text) > LONGEST or not WORD.search(text):
        return None
    pieces, quantities, at = list[str](), list[str](), 0
    for found in NUMBER.finditer(text):
        if found.start() < at:
            return None
        end = found.end() + _unit_behind(text[found.end() :], question.unit)
        if end == found.end() and not _needs_no_unit(text[end:], question.unit):
            return None
        pieces.append(text[at : found.start()])
        quantities.append(text[found.start() : end].strip())
        at = end
    pieces.append(text[at:])
    between = HALF_OF_A_NAME.sub("", " ".join(pieces))
    words = [word.lower() for word in WORD.findall(between)]
    joining = {"and", "und", "og", "between", "first"} if count > 1 else {"and"}
    denied = ((CHANGING | OF_CHANGE) - SIGNS.keys() - NUMBERS.keys() - joining) - (
        OF_ORDER & words_of(f"{question.title} {question.text}")
    )
    if (
        len(quantities) != count
        or not words
        or len(words) > MOST_WORDS
        or OTHER_SIGNS.search(between)
        or between.count("(") != between.count(")")
        or re.search(r"\d", between)
        or denied.intersection(words)
        or DENIED.search(between)
    ):
        return None
    turned = bool(SIGNS.keys() & set(words) or OF_A_SIGN.search(between))
    return QuantitySentence(tuple(quantities), tuple(pieces), turned)


def by_names(sentence: QuantitySentence, names: Sequence[str]) -> tuple[str, ...] | None:
    """The quantities in the order of the names, each named in the words before it, or each behind it; as they stand where none is
    named; None where it is not told which is which."""
    spoken = [name for name in names if name.isalpha()]
    named = [
        {name for name in spoken if re.search(rf"\b{re.escape(name)}\b", words)} for words in sentence.words
    ]
    if not set[str]().union(*named):
        return sentence.quantities
    for places in (named[:-1], named[1:]):
        others = named[-1] if places == named[:-1] else named[0]
        if not others and all(len(each) == 1 for each in places):
            order = [next(iter(each)) for each in places]
            if sorted(order) == sorted(names):
                return tuple(sentence.quantities[order.index(name)] for name in names)
    return None


def _needs_no_unit(rest: str, expected: Unit) -> bool:
    """True where a plain number is asked for, and the word behind one is no unit of something else."""
    word = re.match(r"\s*([^\W\d_%°]+)", rest)
    return expected.is_pure and (word is None or not isinstance(read_unit(word[1]), Unit))


def _unit_behind(rest: str, expected: Unit) -> int:
    """How much of a text behind a number is its unit."""
    tokens = [found.end() for found in re.finditer(r"\s*\S+", rest)][:MOST_TOKENS]
    for last in reversed(tokens):
        text = rest[:last].rstrip(" .,;:)")
        found = unit_meant(text.strip(), expected) if text.strip() else None
        if isinstance(found, Unit) and found.measures(expected):
            return len(text)
    return 0
