"""A figure drawn: its things laid out to its own extents, as SVG text of one look, and told in words."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

from corollary.figure.drawing_sheet import LAID, PRIMITIVES, Canvas, FigureItem, NotDrawable, Point, fixed
from corollary.figure.graph_scale import HIGH, WIDE, graph_in_words
from corollary.figure.lettering import Box, lettered, spoken
from corollary.figure.shapes.lines import LONGEST
from corollary.messages import N_, catalogue

__all__ = ["PRIMITIVES", "FigurePanel", "describe", "draw", "graphs_in_words", "unmentioned"]

_ = catalogue(__name__)

WIDTH: Final = 520.0
"""Of every figure, so that letters and lines are of one size on every page."""
MARGIN: Final = 8.0
TALLEST: Final = 190.0
"""What is between the lowest and the highest place of a panel; what is drawn about them comes on top."""
LEAST_GAP: Final = 20.0
ABOUT: Final = 70.0
"""What bodies and words take besides, as a first guess."""
TALLEST_GRAPH: Final = HIGH
TITLE: Final = 22.0
TRIES: Final = 4
DIRECTIONS: Final = (
    N_("to the right"), N_("to the right and up"), N_("up"), N_("to the left and up"),
    N_("to the left"), N_("to the left and down"), N_("down"), N_("to the right and down"),
)  # fmt: skip


@dataclass(frozen=True, slots=True)
class FigurePanel:
    """Part of a figure with a scale of its own; `below` begins a new row."""

    title: str
    items: tuple[FigureItem, ...]
    below: bool = False

    @property
    def is_graph(self) -> bool:
        return any(item.kind == "graph" for item in self.items)


def draw(panels: Sequence[FigurePanel]) -> str:
    """The figure as SVG text, without ids, scripts or references. Raises NotDrawable, with the `item` that cannot."""
    rows: list[list[FigurePanel]] = []
    for panel in panels:
        if panel.below or not rows:
            rows.append([])
        rows[-1].append(panel)
    arrows, shapes, y, over = _arrow_scales(panels), list[str](), 0.0, 0.0
    for row in rows:
        drawn, y, wider = _row(row, y, arrows)
        shapes += drawn
        over = max(over, wider)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{fixed(-over / 2)} 0 {fixed(WIDTH + over)} {fixed(y)}" '
        f'font-family="sans-serif" font-size="15">{"".join(shapes)}</svg>'
    )


def _arrow_scales(panels: Iterable[FigurePanel]) -> dict[str, float]:
    """The longest arrow of each group has the same length on paper, in all panels."""
    longest: dict[str, float] = {}
    for panel in panels:
        for item in panel.items:
            if "by" in item.numbers:
                longest[item.group] = max(longest.get(item.group, 0.0), math.hypot(*item.numbers["by"]))
    return {group: LONGEST / size for group, size in longest.items() if size}


def _row(
    row: Sequence[FigurePanel], top: float, arrows: Mapping[str, float]
) -> tuple[list[str], float, float]:
    """Panels beside each other, from `top` downwards; where they end, and by how much they are too wide."""
    drawn = _fitted(row, arrows)
    boxes = [canvas.extent() for canvas in drawn]
    wide = [max(box[2] - box[0], lettered(panel.title)[1]) for panel, box in zip(row, boxes, strict=True)]
    titled = TITLE if any(panel.title for panel in row) else 0.0
    low = min(box[1] for box in boxes)
    end = top + 2 * MARGIN + titled + max(box[3] for box in boxes) - low
    gap = max((WIDTH - 2 * MARGIN - sum(wide)) / len(row), LEAST_GAP)
    all_wide = sum(wide) + gap * (len(row) - 1)
    x, shapes = (WIDTH - all_wide) / 2, list[str]()
    for panel, canvas, box, room in zip(row, drawn, boxes, wide, strict=True):
        middle = x + room / 2
        inside = "".join(shape for _layer, shape in sorted(canvas.shapes, key=lambda each: each[0]))
        left, down = fixed(middle - (box[0] + box[2]) / 2), fixed(end - MARGIN + low)
        shapes.append(f'<g transform="translate({left} {down})">{inside}</g>')
        if panel.title:
            place = f'x="{fixed(middle)}" y="{fixed(top + MARGIN + 12)}"'
            shapes.append(f'<text {place} text-anchor="middle" fill="#555">{lettered(panel.title)[0]}</text>')
        x += room + gap
        if panel is not row[-1]:
            line = f"M{fixed(x - gap / 2)} {fixed(top + 4)}V{fixed(end - 4)}"
            shapes.append(f'<path d="{line}" stroke="#bbb" stroke-dasharray="3 4"/>')
    return shapes, end, max(0.0, all_wide + 2 * MARGIN - WIDTH)


def _fitted(row: Sequence[FigurePanel], arrows: Mapping[str, float]) -> list[Canvas]:
    """Each panel at the largest scale at which all fit beside each other; one with a single place takes what it needs."""
    spans: list[tuple[float, float]] = []
    for panel in row:
        left, bottom, right, top = _extent(panel.items)
        spans.append((right - left, top - bottom))
    drawn = {
        place: _laid(panel.items, 1.0, arrows) for place, panel in enumerate(row) if not any(spans[place])
    }
    free = WIDTH - 2 * MARGIN - LEAST_GAP * (len(row) - 1) - sum(map(_width, drawn.values()))
    wishes = {
        place: ABOUT
        + min(free, wide / high * (TALLEST_GRAPH if row[place].is_graph else TALLEST) if high else free)
        for place, (wide, high) in enumerate(spans)
        if place not in drawn
    }
    for place, wish in wishes.items():
        drawn[place] = _at_scale(row[place], free * wish / sum(wishes.values()), *spans[place], arrows)
    return [drawn[place] for place in range(len(row))]


def _at_scale(
    panel: FigurePanel, room: float, wide: float, high: float, arrows: Mapping[str, float]
) -> Canvas:
    """The panel, made smaller until it is no wider than its room, or smaller does not help: words keep their size."""
    for_places, best = room - ABOUT, None
    tallest = TALLEST_GRAPH if panel.is_graph else TALLEST
    for _attempt in range(TRIES):
        scale = min(for_places / wide if wide else math.inf, tallest / high if high else math.inf)
        canvas = _laid(panel.items, scale, arrows)
        if best is None or _width(canvas) < _width(best):
            best = canvas
        excess = _width(canvas) - room
        for_places = scale * wide - excess - 1
        if excess <= 0 or for_places < room / 4:
            break
    assert best is not None
    return best


def _width(canvas: Canvas) -> float:
    left, _bottom, right, _top = canvas.extent()
    return right - left


def _laid(items: Sequence[FigureItem], scale: float, arrows: Mapping[str, float]) -> Canvas:
    canvas = Canvas(scale, arrows)
    for phase in LAID:
        if phase == LAID[-1]:
            canvas.finish()
        for item in items:
            if PRIMITIVES[item.kind].laid == phase:
                try:
                    PRIMITIVES[item.kind].draw(canvas, item)
                    if phase == LAID[-1]:
                        canvas.finish()
                except NotDrawable as error:
                    error.item = item
                    raise
    return canvas


def _extent(items: Iterable[FigureItem]) -> Box:
    """The box around all places that are told by numbers, and the sizes about them."""
    points: list[Point] = []
    for item in items:
        if item.kind == "graph":
            return 0.0, 0.0, WIDE, HIGH
        radius = item.number("radius") or 0.0
        half = tuple(number / 2 for number in item.numbers.get("size", (2 * radius,)))
        long, slope = item.number("length") or 0.0, item.number("angle") or 0.0
        for places in item.places.values():
            for place in places:
                if isinstance(place, str):
                    continue
                x, y = place
                points += [(x - half[0], y - half[-1]), (x + half[0], y + half[-1])]
                if item.kind in ("wall", "lens"):
                    points += [(x, y - long / 2), (x, y + long / 2)]
                elif long:
                    points.append((x + long * math.cos(slope), y + long * math.sin(slope)))
    if not points:
        return 0.0, 0.0, 0.0, 0.0
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def describe(panels: Sequence[FigurePanel]) -> str:
    """What the figure shows, for those who cannot see it: each thing, and what is written on it."""
    sentences: list[str] = []
    for panel in panels:
        if panel.is_graph:
            sentences += graphs_in_words([panel])
            continue
        phrases = "; ".join(filter(None, map(_phrase, panel.items)))
        if phrases:
            sentence = (
                f"{spoken(panel.title)}: {phrases}" if panel.title else phrases[0].upper() + phrases[1:]
            )
            sentences.append(sentence + ".")
    return " ".join(sentences)


def graphs_in_words(panels: Sequence[FigurePanel]) -> tuple[str, ...]:
    """The axes and the values of each graph."""
    return tuple(
        f"{spoken(panel.title)}: {graph_in_words(panel.items)}"
        if panel.title
        else graph_in_words(panel.items)
        for panel in panels
        if panel.is_graph
    )


def unmentioned(panels: Sequence[FigurePanel], words: str) -> str:
    """What is written in the figure with a number, and not in an author's description of it."""
    have = spoken(words)
    missing = dict.fromkeys(
        spoken(text)
        for panel in panels
        for item in panel.items
        for text in item.texts
        if any(each.isdigit() for each in text) and not _mentioned(spoken(text), have)
    )
    return _("Written in the figure: {texts}.", texts="; ".join(missing)) if missing else ""


def _mentioned(text: str, words: str) -> bool:
    value = text.rpartition("= ")[2]
    return text in words or value in words


def _phrase(item: FigureItem) -> str:
    if item.kind == "note":
        return spoken(item.label)
    if item.kind == "text":
        return spoken(item.label)
    if PRIMITIVES[item.kind].noun == N_("a line") and not item.texts:
        return ""
    thing = _(PRIMITIVES[item.kind].noun)
    if item.kind == "arrow":
        thing += _where(item)
    elif item.marked:
        thing += f" {item.name}"
    return (
        _("{thing}: {texts}", thing=thing, texts=", ".join(map(spoken, item.texts))) if item.texts else thing
    )


def _where(item: FigureItem) -> str:
    if "by" not in item.numbers:
        ends = [str(item.places[word][0]) for word in ("from", "to") if word in item.places]
        named = [end for end in ends if end[:1].isupper()]
        return " " + _("from {one} to {other}", one=named[0], other=named[1]) if len(named) == 2 else ""
    dx, dy = item.numbers["by"]
    if not math.hypot(dx, dy):
        return ""
    eighth = round(math.atan2(dy, dx) / (math.pi / 4)) % 8
    at = " " + _("at {thing}", thing=item.name) if item.marked else ""
    return at + " " + _(DIRECTIONS[eighth])
