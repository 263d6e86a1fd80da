"""A graph in a figure: its axes as an author states them, and what is drawn on them brought to the sheet."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, Final

from corollary.figure.drawing_sheet import FigureItem, NotDrawable, Point
from corollary.figure.graph_scale import HIGH, WIDE, GraphScale, axis_title
from corollary.units.unit import Unit, show

GRAPH: Final = "graph"
ON_AXES: Final = frozenset({"curve", "point", "line", "arrow", "length", "text", "note"})
NOT_ON_AXES: Final = frozenset({"radius", "size", "by"})
GRAPH_SAMPLES: Final = 160
"""Straight pieces of a curve of a formula."""
MOST_LISTED: Final = 13  # points of one curve, in words
Number = Callable[[Mapping[str, Any]], float]


@dataclass(frozen=True, slots=True)
class GraphAxes:
    """`letter` is the variable of the formulas; ends and steps are in the units of the axes. Without ends, `y` takes what is drawn."""

    letter: str
    x: tuple[Number, Number]
    y: tuple[Number, Number] | None
    units: tuple[Unit, Unit]
    steps: tuple[float, float]
    titles: tuple[str, str]


def si(number: Number, unit: Unit) -> Number:
    """A plain number of an axis in SI."""
    factor, offset = float(unit.factor) * math.pi**unit.pi, float(unit.offset)
    return lambda values: factor * number(values) + offset


def in_unit(number: Number, unit: Unit) -> Number:
    """A formula of givens in the unit of an axis."""
    return lambda values: unit.from_si(number(values))


def on_sheet(
    axes: GraphAxes, lines: Sequence[tuple[int, FigureItem]], values: Mapping[str, float]
) -> list[tuple[int, FigureItem]]:
    """The graph, which comes first, with its ranges, and what is drawn on it, cut off where it leaves them; each with its line. Raises
    NotDrawable."""
    (first, graph), *items = lines
    points = [place for _, item in items for own in item.places.values() for place in own]
    known = [place for place in points if not isinstance(place, str)]
    (left, right), steps = axes.x, axes.steps
    scale = GraphScale.exactly if "sketch" in graph.flags else GraphScale.holding
    x = scale(left(values), right(values), steps[0])
    if axes.y is not None:
        bottom, top = axes.y
        y = scale(bottom(values), top(values), steps[1])
    elif known:
        heights = [place[1] for place in known if x.low <= place[0] <= x.high]
        y = scale(min(0.0, *heights), max(0.0, *heights), steps[1])
    else:
        raise NotDrawable("graph: say from where to where, y=0,10, or draw something on it")
    titles = axes.titles
    if "sketch" not in graph.flags:
        across, up = (show(each) for each in axes.units)
        titles = axis_title(axes.titles[0], across), axis_title(axes.titles[1], up)
    numbers = {"x": (x.low, x.high, x.step), "y": (y.low, y.high, y.step)}
    found = [(first, replace(graph, texts=titles, numbers=numbers))]
    for line, item in items:
        found += ((line, piece) for piece in _drawn_on(item, x, y))
    return found


def _drawn_on(item: FigureItem, x: GraphScale, y: GraphScale) -> list[FigureItem]:
    """An item in the lengths of the sheet; a curve that leaves the ranges is several."""

    def to_sheet(point: Point) -> Point:
        return x.share(point[0]) * WIDE, y.share(point[1]) * HIGH

    def inside(point: Point) -> bool:
        return x.low - 1e-9 * x.step <= point[0] <= x.high + 1e-9 * x.step and (
            y.low - 1e-9 * y.step <= point[1] <= y.high + 1e-9 * y.step
        )

    through = item.places.get("through", ())
    path = [place for place in through if not isinstance(place, str)]
    if path and len(path) == len(through):
        listed = _at_ticks(path, x) if item.smooth else path
        listed = [point for point in listed if inside(point)]
        pieces = _pieces(path, (x.low, x.high), (y.low, y.high))
        return [
            replace(
                item,
                places={"through": tuple(map(to_sheet, piece))},
                texts=item.texts if at == 0 else (),
                data=tuple(listed) if at == 0 else (),
            )
            for at, piece in enumerate(pieces)
        ]
    places = {
        word: tuple(place if isinstance(place, str) else to_sheet(place) for place in own)
        for word, own in item.places.items()
    }
    ends = [place for word in ("at", "from", "to") for place in item.places.get(word, ())]
    data = tuple(place for place in ends if not isinstance(place, str))
    listed = item.kind == "point" or (item.kind == "line" and len(data) == 2)
    return [replace(item, places=places, data=data if listed else ())]


def _at_ticks(path: Sequence[Point], x: GraphScale) -> list[Point]:
    """A curve at the ticks that it reaches, and at its ends; one that turns back at some of its points."""
    if any(one[0] >= other[0] for one, other in pairwise(path)):
        return [path[k * (len(path) - 1) // (MOST_LISTED - 1)] for k in range(MOST_LISTED)]
    every = math.ceil(len(x.ticks) / MOST_LISTED)
    wanted = [tick for tick in x.ticks[::every] if path[0][0] < tick < path[-1][0]]
    return [path[0], *(_between(path, tick) for tick in wanted), path[-1]]


def _between(path: Sequence[Point], at: float) -> Point:
    (a, b), (c, d) = next(pair for pair in pairwise(path) if pair[1][0] >= at)
    return at, b + (d - b) * (at - a) / (c - a)


def _pieces(path: Sequence[Point], x: tuple[float, float], y: tuple[float, float]) -> list[list[Point]]:
    """The parts of a path of straight lines that lie within the ranges."""
    found: list[list[Point]] = []
    for one, other in pairwise(path):
        part = _within(one, other, x, y)
        if part is None:
            continue
        if found and found[-1][-1] == part[0]:
            found[-1].append(part[1])
        else:
            found.append(list(part))
    return found


def _within(
    one: Point, other: Point, x: tuple[float, float], y: tuple[float, float]
) -> tuple[Point, Point] | None:
    """The part of a straight line within a rectangle, after Liang and Barsky."""
    first, last = 0.0, 1.0
    for at, (low, high) in enumerate((x, y)):
        way, slack = other[at] - one[at], 1e-9 * (high - low)
        if not way:
            if not low - slack <= one[at] <= high + slack:
                return None
            continue
        enters, leaves = sorted(((low - slack - one[at]) / way, (high + slack - one[at]) / way))
        first, last = max(first, enters), min(last, leaves)
    if first > last:
        return None

    def point(share: float) -> Point:
        return one[0] + share * (other[0] - one[0]), one[1] + share * (other[1] - one[1])

    return one if first == 0 else point(first), other if last == 1 else point(last)
