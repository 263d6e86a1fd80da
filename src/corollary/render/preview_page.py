"""The page on which an author writes one problem, and the piece of it that shows its draws, each of them whole."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from markupsafe import Markup

from corollary.notebook.worksheet import Exercise
from corollary.problem.variant import number
from corollary.render.page import environment, page
from corollary.render.wording import wanted
from corollary.units.unit import Unit, show
from corollary.verify.drawn import Draw, KeyedPart


@dataclass(frozen=True, slots=True)
class AuthorWord:
    """A word that an author may write, what it means, and a line to begin with."""

    word: str
    meaning: str
    example: str


@dataclass(frozen=True, slots=True)
class AuthorWords:
    """Words of one kind; `side` is the text in which they stand, `inline` words stand within a line."""

    title: str
    side: Literal["problem", "solution"]
    words: tuple[AuthorWord, ...]
    inline: bool = False


@dataclass(frozen=True, slots=True)
class Sheet:
    """One draw with all that is shown of it; `figure` is empty where there is none or it cannot be shown."""

    draw: Draw
    exercise: Exercise
    figure: Markup
    parts: tuple[KeyedPart, ...]
    solution: str

    @property
    def anchor(self) -> str:
        return "own" if self.draw.variant.index is None else f"v{self.draw.variant.index}"

    @property
    def name(self) -> str:
        index = self.draw.variant.index
        return "its own numbers" if index is None else f"variant {index}"

    @property
    def givens(self) -> list[str]:
        """The numbers alone, in the givens' units."""
        values = self.draw.variant.values
        return [number(given, values[given.symbol]) for given in self.exercise.problem.givens]


def preview_page(words: Sequence[AuthorWords], variants: str = "") -> str:
    """One page that needs nothing but the server that gave it, which it asks for texts, complaints and variants."""
    return page(
        "preview.html",
        title="Preview",
        script="preview.js",
        style=("report.css", "practise.css", "preview.css"),
        sends=True,
        formulas=True,
        words=words,
        variants=Markup(variants),
    )


def variants_piece(heading: str, sheets: Sequence[Sheet], redrawn: int, advice: str) -> str:
    """The draws as a table, and each of them whole; `redrawn` counts those too that no sheet is of, and `advice` says what would
    leave fewer."""
    return (
        environment()
        .get_template("variants.html")
        .render(
            heading=heading,
            sheets=sheets,
            dealt=sum(not sheet.draw.reason for sheet in sheets[1:]),
            redrawn=redrawn,
            advice=advice,
            wanted=wanted,
            in_unit=in_unit,
        )
    )


def in_unit(unit: Unit) -> str:
    """The unit in the heading of a column of bare numbers."""
    return f", {show(unit)}" if show(unit) else ""
