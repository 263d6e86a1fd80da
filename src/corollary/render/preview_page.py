"""The page that shows an author one problem: what is wrong with it, its draws, and each of them whole."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from corollary.notebook.worksheet import Exercise
from corollary.problem.diagnostic import Diagnostic
from corollary.problem.variant import number
from corollary.render.page import page
from corollary.render.wording import wanted
from corollary.units.unit import Unit, show
from corollary.verify.drawn import Draw, KeyedPart


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


def preview_page(
    heading: str,
    sheets: Sequence[Sheet],
    redrawn: int,
    complaints: Sequence[Diagnostic],
    edition: str,
    advice: str = "",
) -> str:
    """One page that needs nothing but the server that gave it, and asks it whether `edition` still holds; `redrawn` counts
    those too that no sheet is of, and `advice` says what would leave fewer."""
    return page(
        "preview.html",
        title=f"{heading}: preview",
        script="preview.js",
        sends=True,
        heading=heading,
        sheets=sheets,
        dealt=sum(not sheet.draw.reason for sheet in sheets[1:]),
        redrawn=redrawn,
        advice=advice,
        complaints=complaints,
        edition=edition,
        wanted=wanted,
        in_unit=in_unit,
    )


def in_unit(unit: Unit) -> str:
    """The unit in the heading of a column of bare numbers."""
    return f", {show(unit)}" if show(unit) else ""
