"""How a verdict looks on a page: a friendly phrase, an icon, a colour; the colour never says it alone."""

from __future__ import annotations

from dataclasses import dataclass
from types import MappingProxyType
from typing import Final

from corollary.answers.verdict import Unread, Verdict, word
from corollary.figure.colour import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, VERMILLION


@dataclass(frozen=True, slots=True)
class Look:
    """`name` serves as CSS class and icon id, `phrase` speaks to the student, `short` heads a column of the report."""

    name: str
    phrase: str
    short: str
    colour: str


LOOKS: Final = MappingProxyType(
    {
        look.name: look
        for look in (
            Look("right", "Right", "right", GREEN),
            Look("follows", "Right, given your earlier answer", "follows", SKY),
            Look("mistaken", "A common mistake", "mistaken", ORANGE),
            Look("slip", "Nearly there: a slip", "slip", PURPLE),
            Look("wrong", "Not right yet", "wrong", VERMILLION),
            Look("unread", "Could not be read", "unread", GREY),
            Look("unmarked", "Waits for your teacher", "waiting", BLUE),
        )
    }
)
"""The look of each verdict, by the word of records and reports, from the best to the worst."""

BLANK: Final = Look("unread", "No answer", "unread", GREY)


def look(verdict: Verdict) -> Look:
    return BLANK if isinstance(verdict, Unread) and verdict.blank else LOOKS[word(verdict)]
