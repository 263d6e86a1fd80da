"""Surfaces that bodies stand on, hang from and slide down: floor, ceiling, wall, incline."""

from __future__ import annotations

import math

from corollary.figure.drawing_sheet import BEHIND, INK, Canvas, FigureItem, Point, fixed, primitive
from corollary.figure.lettering import TextSpot, around
from corollary.figure.shapes.bodies import measured
from corollary.messages import N_

HATCH, DEEP = 10.0, 9.0


def hatched(canvas: Canvas, start: Point, end: Point, side: int, colour: str = INK) -> None:
    """A line with short strokes on the side of the solid: 1 is left of the way from start to end."""
    (x, y), (to_x, to_y) = start, end
    length = math.hypot(to_x - x, to_y - y) or 1.0
    c, s = (to_x - x) / length, (to_y - y) / length
    dx, dy = -DEEP * (c + side * s), DEEP * (side * c - s)
    stroke = f"l{fixed(dx)} {fixed(-dy)}m{fixed(HATCH * c - dx)} {fixed(dy - HATCH * s)}"
    strokes = f"M{fixed(x + HATCH * c)} {fixed(-y - HATCH * s)}" + stroke * int(length / HATCH)
    canvas.shapes.append((BEHIND, f'<path d="{strokes}" fill="none" stroke="#666" stroke-width="1"/>'))
    canvas.path([start, end], width=3, stroke=colour)
    xs, ys = sorted((x, to_x)), sorted((y, to_y))
    deep_x, deep_y = -side * DEEP * s, side * DEEP * c
    canvas.take(
        (xs[0] + min(0, deep_x), ys[0] + min(0, deep_y), xs[1] + max(0, deep_x), ys[1] + max(0, deep_y))
    )


def _level(canvas: Canvas, item: FigureItem, side: int) -> None:
    """A floor or a ceiling: where it is said, or along everything that is drawn so far."""
    left, bottom, right, top = canvas.extent()
    ends = (left - 24, right + 24)
    lowest = min((area[1] for area in canvas.areas), default=bottom)
    y = lowest if side < 0 else top + 24
    if "at" in item.places:
        x, y = canvas.at(item.place("at"))
        if (length := item.number("length")) is not None:
            ends = (x, x + length * canvas.scale)
    hatched(canvas, (ends[0], y), (ends[1], y), side, canvas.colour(item))
    below = y + side * (DEEP + 2)
    canvas.write(
        item.label,
        [
            TextSpot((ends[0] + ends[1]) / 2 + shift * (ends[1] - ends[0]) / 2, below, shift, -side)
            for shift in (-1, 0, 1)
        ],
        size=13,
        flags=item.flags,
    )


@primitive("floor", N_("a floor"), "at length", laid=2)
def floor(canvas: Canvas, item: FigureItem) -> None:
    _level(canvas, item, -1)


@primitive("ceiling", N_("a ceiling"), "at length", laid=2)
def ceiling(canvas: Canvas, item: FigureItem) -> None:
    _level(canvas, item, 1)


@primitive("wall", N_("a wall"), "at length", "facing_right")
def wall(canvas: Canvas, item: FigureItem) -> None:
    x, y = canvas.at(item.place("at"))
    length = measured(canvas, item, "length", 110.0)
    foot, head = (x, y - length / 2), (x, y + length / 2)
    hatched(canvas, foot, head, 1 if "facing_right" in item.flags else -1, canvas.colour(item))
    canvas.write(item.label, around((x - 10, foot[1], x + 10, head[1]))[1::-1], size=13, flags=item.flags)


@primitive("incline", N_("an incline"), "at length angle", laid=0)
def incline(canvas: Canvas, item: FigureItem) -> None:
    x, y = canvas.at(item.place("at"))
    length, angle = measured(canvas, item, "length", 260.0), item.numbers.get("angle", (math.pi / 6,))[0]
    end = (x + length * math.cos(angle), y + length * math.sin(angle))
    canvas.path([(x, y), (end[0], y), end], fill="#f4f4f4", polygon=True)
    canvas.slopes[item.name] = ((x, y), length, angle)
    arc(canvas, (x, y), 0.0, angle, 46.0, item.label)


def arc(
    canvas: Canvas, middle: Point, start: float, end: float, radius: float, label: str, colour: str = INK
) -> None:
    """Part of a circle with its text outside of the middle of it."""
    x, y = middle
    count = max(2, int(abs(end - start) / 0.12) + 1)
    turns = [start + (end - start) * k / count for k in range(count + 1)]
    canvas.path(
        [(x + radius * math.cos(a), y + radius * math.sin(a)) for a in turns], width=1.5, stroke=colour
    )
    half = (start + end) / 2
    spots = [
        TextSpot(x + far * math.cos(turn), y + far * math.sin(turn), -math.cos(turn), -0.7 * math.sin(turn))
        for far in (radius + 5, radius + 20, radius * 0.45, radius + 36)
        for turn in (half, half - (end - start) / 4, half + (end - start) / 4)
    ]
    canvas.write(label, spots)
