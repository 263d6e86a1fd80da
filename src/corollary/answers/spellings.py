"""Words that may be written in several ways, `ellipse | elliptic orbit`: which one is meant, and which one is nearly written."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from corollary.answers.changing_words import NEGATIONS

MARK = "|"  # parts the ways to write one word; the first is the one that is printed
ARTICLES = frozenset(["the", "a", "an", "der", "die", "das", "ein", "eine", "en", "et", "ei", "den", "det"])
LONGEST, MOST_WORDS = 160, 8
DENIALS: str = (
    f"{NEGATIONS} or oder eller but rather than instead except unlike almost nearly like squashed "
    "aber sondern men"
)
DENYING = frozenset(DENIALS.split())


@dataclass(frozen=True, slots=True)
class WordsMet:
    """The letters of the words that a text may be: one when it is `exact`, else those that are nearly written so."""

    letters: tuple[str, ...]
    exact: bool


def main_spelling(text: str) -> str:
    """The word as it is printed."""
    return text.partition(MARK)[0].strip()


def spelled_alike(words: Mapping[str, str]) -> tuple[str, str] | None:
    """The letters of two words that share a way to write them, if there are any."""
    seen: dict[str, str] = {}
    for letter, word in words.items():
        for way in map(bare, word.split(MARK)):
            if (first := seen.setdefault(way, letter)) != letter:
                return first, letter
    return None


def words_met(text: str, words: Mapping[str, str]) -> WordsMet:
    """What a text is among words, each with its letter and the ways to write it; none of a text that is near none of them."""
    typed = bare(text)
    ways = {letter: [bare(way) for way in word.split(MARK)] for letter, word in words.items()}
    if not typed or len(text) > LONGEST:
        return WordsMet((), exact=False)
    if same := tuple(letter for letter, each in ways.items() if typed in each):
        return WordsMet(same, exact=True)
    off = {letter: min(distance(typed, way) - allowed(way) for way in each) for letter, each in ways.items()}
    near = [letter for letter in off if off[letter] <= 0]
    return WordsMet(tuple(sorted(near, key=off.__getitem__)), exact=False)


def word_held(text: str, words: Mapping[str, str]) -> str:
    """The letter of the one word that stands in a text of a few words more, `part of an ellipse`, or that it begins, `against`; ""
    where there is none, or two."""
    typed = bare(text) if len(text) <= LONGEST else ""
    ways = {letter: [bare(way) for way in word.split(MARK)] for letter, word in words.items()}
    if not typed or len(typed.split()) > MOST_WORDS or DENYING.intersection(typed.split()):
        return ""
    inside = [letter for letter, each in ways.items() if any(f" {way} " in f" {typed} " for way in each)]
    begun = [letter for letter, each in ways.items() if any(way.startswith(f"{typed} ") for way in each)]
    found = inside or (begun if len(typed) > 4 else [])
    return found[0] if len(found) == 1 else ""


def bare(text: str) -> str:
    """Small letters and digits, without articles, accents and marks; umlauts as they are typed without them."""
    text = text.casefold().translate(
        str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "ø": "o", "å": "a", "æ": "ae"})
    )
    apart = unicodedata.normalize("NFKD", text)
    words = re.sub(r"[^a-z0-9]+", " ", re.sub(r"[\u0300-\u036f]", "", apart)).split()
    words = " ".join(words).replace("each other", "one another").split()
    return " ".join(word for word in words if word not in ARTICLES or len(words) == 1)


def allowed(word: str) -> int:
    """How many slips of a finger leave a word recognisable: one in four letters, at most three."""
    return min(3, max(1, len(word) // 4)) if len(word) > 2 else 0


def distance(one: str, other: str) -> int:
    """Letters left out, put in, or exchanged, and neighbours that changed places (Damerau's distance, optimal alignment)."""
    before: Sequence[int] = ()
    row: list[int] = list(range(len(other) + 1))
    for i, x in enumerate(one, 1):
        above, row = row, [i]
        for j, y in enumerate(other, 1):
            best = min(above[j] + 1, row[j - 1] + 1, above[j - 1] + (x != y))
            if i > 1 and j > 1 and x == other[j - 2] and one[i - 2] == y:
                best = min(best, before[j - 2] + 1)
            row.append(best)
        before = above
    return row[-1]
