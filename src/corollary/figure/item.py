"""One thing in a figure as plain data: what it is, where it stands, and what is written on it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

Point = tuple[float, float]
Place = Point | str
"""Coordinates, or a thing by its name: `A`, or one of its sides, `A.top`."""


@dataclass(frozen=True, slots=True)
class FigureItem:
    """Lengths are in one unit, whichever; angles in radians; `vectors` are grouped by what they measure, so that arrows of one
    group are drawn to one scale."""

    kind: str
    name: str = ""
    texts: tuple[str, ...] = ()
    places: Mapping[str, tuple[Place, ...]] = field(default_factory=dict[str, tuple[Place, ...]])
    numbers: Mapping[str, tuple[float, ...]] = field(default_factory=dict[str, tuple[float, ...]])
    flags: frozenset[str] = frozenset()
    group: str = ""

    @property
    def label(self) -> str:
        return self.texts[0] if self.texts else ""

    @property
    def marked(self) -> bool:
        """Whether its name is written on it: a capital letter or a number; a small letter is for the author's use."""
        return self.name[:1].isupper() or self.name[:1].isdigit()

    def number(self, word: str) -> float | None:
        return self.numbers[word][0] if word in self.numbers else None

    def place(self, word: str) -> Place:
        """Raises NotDrawable when the word is missing."""
        if word not in self.places:
            raise NotDrawable(f"{self.kind} needs {word}=, such as {word}=0,0 or {word}=A")
        return self.places[word][0]


class NotDrawable(ValueError):
    """Something in a figure cannot be drawn; one sentence says what and what to do. `item` is the thing, where it is known."""

    item: FigureItem | None = None
