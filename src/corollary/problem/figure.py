"""A problem's figure drawn with a student's numbers, once for each variant."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Final

from corollary.figure.drawing import FigurePanel, describe, draw, unmentioned
from corollary.figure.item import FigureItem, NotDrawable, Place
from corollary.problem.figure_lines import PANEL, FigureLine, Located, read_lines
from corollary.problem.statement import filled
from corollary.problem.variant import Variant

SAMPLES: Final = 40
"""Straight pieces of a curve."""


class BadFigure(ValueError):
    """A line of a figure cannot be read or drawn; `line` counts from 0 within the figure."""

    def __init__(self, line: int, why: str) -> None:
        super().__init__(why)
        self.line = line


@dataclass(frozen=True, slots=True)
class VariantFigure:
    """A figure with one student's numbers: SVG text, and the same in words."""

    svg: str
    alt: str


def drawn(variant: Variant) -> VariantFigure:
    """The figure of a variant; without one, empty. Raises BadFigure.

    A figure that begins with `<` is a drawing of the author's own.
    """
    problem = variant.problem
    words = filled(problem.figure_alt, variant)
    if is_svg(problem.figure):
        return VariantFigure(filled(problem.figure, variant), words)
    lines, complaints = read_lines(
        problem.figure, tuple((given.symbol, given.unit.dimension) for given in problem.givens)
    )
    if complaints:
        raise BadFigure(*complaints[0])
    values: dict[str, float] = {}
    for given in problem.givens:
        ratio, pi = given.unit.to_si(variant.values[given.symbol])
        values[given.symbol] = float(ratio) * math.pi**pi
    titles, items = [("", False)], [list[tuple[int, FigureItem]]()]
    for line in lines:
        texts = tuple(filled(text, variant) if "{{" in text else text for text in line.texts)
        if line.kind == PANEL:
            titles.append((texts[0] if texts else "", "below" in line.flags))
            items.append([])
        else:
            items[-1].append((line.line, _item(line, texts, values)))
    panels = [
        FigurePanel(title, tuple(item for _, item in own), below)
        for (title, below), own in zip(titles, items, strict=True)
        if own
    ]
    try:
        svg = draw(panels)
    except NotDrawable as error:
        line = next((line for own in items for line, item in own if item is error.item), 0)
        raise BadFigure(line, str(error)) from None
    more = unmentioned(panels, words) if words else describe(panels)
    return VariantFigure(svg, " ".join(filter(None, (words, more))))


def is_svg(figure: str) -> bool:
    """Whether an author drew it by hand, or there is none."""
    return not figure or figure.lstrip().startswith("<")


def _item(line: FigureLine, texts: tuple[str, ...], values: Mapping[str, float]) -> FigureItem:
    try:
        if line.over is None:
            places = {word: tuple(_at(each, values) for each in own) for word, own in line.places.items()}
        else:
            letter, start, end = line.over
            low, high = start(values), end(values)
            steps = [{**values, letter: low + (high - low) * k / SAMPLES} for k in range(SAMPLES + 1)]
            places = {word: tuple(_at(own[0], step) for step in steps) for word, own in line.places.items()}
        numbers = {word: tuple(each(values) for each in own) for word, own in line.numbers.items()}
    except (ArithmeticError, ValueError):
        raise BadFigure(line.line, f"{line.kind}: a formula has no value with these numbers") from None
    found = [*(n for own in numbers.values() for n in own)]
    found += [n for own in places.values() for place in own if not isinstance(place, str) for n in place]
    if not all(map(math.isfinite, found)):
        raise BadFigure(line.line, f"{line.kind}: a formula has no finite value with these numbers")
    return FigureItem(line.kind, line.name, texts, places, numbers, line.flags, line.group)


def _at(place: Located, values: Mapping[str, float]) -> Place:
    return place if isinstance(place, str) else (place[0](values), place[1](values))
