"""The options of a choice that was corrected after it was handed out: which letter of a sheet is which letter of today."""

from __future__ import annotations

from collections.abc import Sequence

from corollary.problem.part import Option


def letters_now(before: Sequence[Option], today: Sequence[Option]) -> tuple[tuple[str, str], ...]:
    """Each letter of the sheet with today's letter of the same option; empty where today has none.

    Options are the same by their text. Of those that were reworded the ones that stayed at their letter are, and the last one left.
    """
    found: dict[str, str] = {}
    left = {option.letter: _words(option) for option in today}
    for option in before:
        same = [letter for letter, words in left.items() if words == _words(option)]
        if same:
            found[option.letter] = same[0]
            del left[same[0]]
    rest = [option.letter for option in before if option.letter not in found]
    for letter in rest:
        if letter in left:
            found[letter] = letter
            del left[letter]
    rest = [letter for letter in rest if letter not in found]
    if len(rest) == len(left) == 1:
        found[rest[0]] = next(iter(left))
    return tuple((option.letter, found.get(option.letter, "")) for option in before)


def _words(option: Option) -> str:
    return " ".join(option.text.split())
