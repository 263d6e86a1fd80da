"""The table of what a figure can be made of; each kind of thing registers itself, in a file of `shapes/`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, Literal

from corollary.figure.drawing_sheet import COLOURS, Canvas
from corollary.figure.item import FigureItem

Takes = Literal["place", "places", "vector", "lengths", "angles", "number"]
WORDS: Final[dict[str, Takes]] = {
    "at": "place",
    "from": "place",
    "to": "place",
    "through": "places",
    "by": "vector",
    "radius": "lengths",
    "length": "lengths",
    "size": "lengths",
    "angle": "angles",
    "between": "angles",
    "turn": "angles",
    "along": "number",
    "on": "place",
    "over": "number",
}
"""What an author can say of a thing, and what kind of value it has."""
SIDES: Final = frozenset({"above", "below", "left", "right"})
LAID: Final = 0, 1, 2, 3
"""Bodies first, for others are attached to them; then what joins them; floors below all that; last what goes where there is room."""


@dataclass(frozen=True, slots=True)
class Primitive:
    """`noun` is what a screen reader says; `words` and `flags` are what an author may write of it."""

    kind: str
    noun: str
    draw: Callable[[Canvas, FigureItem], None]
    words: frozenset[str]
    flags: frozenset[str]
    laid: int
    most_texts: int


PRIMITIVES: Final[dict[str, Primitive]] = {}


def primitive(
    kind: str, noun: str, words: str = "", flags: str = "", *, laid: int = 1, texts: int = 1
) -> Callable[[Callable[[Canvas, FigureItem], None]], Callable[[Canvas, FigureItem], None]]:
    """Registers a function as what draws things of a kind; colours and the sides of a text are known to all."""

    def register(draw: Callable[[Canvas, FigureItem], None]) -> Callable[[Canvas, FigureItem], None]:
        every = frozenset(flags.split()) | COLOURS.keys() | SIDES
        PRIMITIVES[kind] = Primitive(kind, noun, draw, frozenset(words.split()), every, laid, texts)
        return draw

    return register
