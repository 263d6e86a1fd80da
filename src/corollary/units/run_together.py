"""Letters that are run together (`Ns`, `kgm`), cut into pieces that may be units; capitals throughout, and what they may be."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import lru_cache
from itertools import product

from corollary.units.unit_table import APART, PREFIXES, UNITS, WITH_PREFIXES

LONGEST_RUN = 9
MOST_SPELLINGS = 64
WORD = re.compile(r"[A-Za-z]+")


def cuts(run: str) -> Iterator[tuple[str, ...]]:
    """Every way to cut letters into two or three pieces."""
    ends = range(1, len(run)) if len(run) <= LONGEST_RUN else ()
    yield from ((run[:end], run[end:]) for end in ends)
    yield from ((run[:first], run[first:end], run[end:]) for end in ends for first in range(1, end))


WITH_HOURS = ("Wh", "kWh", "MWh", "GWh", "Ah", "mAh")  # products that are written as one word, in any case


def in_capitals(text: str) -> bool:
    """Whether every letter is a capital. A lone one is not enough: `5 T` may well be tesla."""
    letters = "".join(WORD.findall(text))
    return len(letters) > 1 and letters.isupper()


def other_cases(text: str) -> list[str]:
    """The same letters as the table has them, small and capital: `KG M/S` is `kg m/s`, `MS` is `ms`, `Ms`, `mS` and `MS`.

    Where all are capitals they may be run together, too: `NS` is also `N s`. Empty where a word is none, or too much.
    """
    cut = in_capitals(text)
    spelled: list[list[str]] = []
    count = 1
    for word in WORD.findall(text):
        pieces = [(word,), *(cuts(word) if cut else ())]
        spelled.append([" ".join(spelling) for each in pieces for spelling in _spellings(each)])
        count *= len(spelled[-1])
    if not 0 < count <= MOST_SPELLINGS:
        return []
    found: list[str] = []
    for spelling in product(*spelled):
        words = iter(spelling)
        found.append(WORD.sub(lambda _word, words=words: next(words), text))
    return found


def _spellings(pieces: tuple[str, ...]) -> Iterator[tuple[str, ...]]:
    """The pieces in the table's letters. Among run-together ones no unit that stands apart, and no kelvin but at the end."""
    for each in product(*(in_any_case(piece) for piece in pieces)):
        if len(each) == 1 or not (APART & set(each) or "K" in each[:-1]):
            yield each


def in_any_case(symbol: str) -> list[str]:
    """The units that differ from it in capitals only: `mohm` and `Mohm` for `MOHM`."""
    return _by_small_letters(len(UNITS)).get(symbol.lower(), [])


@lru_cache(maxsize=1)
def _by_small_letters(_units: int) -> dict[str, list[str]]:
    """Symbols by their small letters, for as many as there are by now; with prefixes that no row lists: `Ms` is a reading as well."""
    found: dict[str, list[str]] = {}
    unlisted = (
        prefix + symbol for symbol in WITH_PREFIXES for prefix in PREFIXES if prefix + symbol not in UNITS
    )
    for symbol in (*UNITS, *unlisted, *WITH_HOURS):
        found.setdefault(symbol.lower(), []).append(symbol)
    return found
