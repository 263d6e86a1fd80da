"""Arrows, lengths, strings, springs, axes, angles, and words on their own."""

from __future__ import annotations

import math

from corollary.figure.drawing_sheet import (
    BEHIND,
    INK,
    MIDDLE,
    Canvas,
    FigureItem,
    NotDrawable,
    Point,
    primitive,
)
from corollary.figure.lettering import TextSpot, around
from corollary.figure.shapes.surfaces import arc
from corollary.figure.svg import BLUE
from corollary.messages import N_

LONGEST, SHORTEST, GAP = 84.0, 26.0, 4.0
THIN = 1.5


def beside(one: Point, other: Point) -> list[TextSpot]:
    """Spots along a line: at its middle on either side, then at its end, then further off."""
    (x, y), (to_x, to_y) = one, other
    angle = math.atan2(to_y - y, to_x - x)
    c, s = math.cos(angle), math.sin(angle)
    up = 1 if c > 1e-9 or (abs(c) <= 1e-9 and s < 0) else -1
    spots: list[TextSpot] = []
    for gap in (7.0, 22.0, 40.0):
        for side in (up, -up):
            across, along = -side * s, side * c
            for share in (0.5, 0.75, 0.25):
                spots.append(
                    TextSpot(
                        x + share * (to_x - x) + gap * across,
                        y + share * (to_y - y) + gap * along,
                        -across,
                        -along,
                    )
                )
        spots.append(TextSpot(to_x + (gap + 2) * c, to_y + (gap + 2) * s, -c, -s))
    return spots


def ends(canvas: Canvas, item: FigureItem) -> tuple[Point, Point]:
    """From where to where: from edge to edge of bodies. Raises NotDrawable."""
    start, end = item.place("from"), item.place("to")
    return canvas.at(start, end), canvas.at(end, start)


@primitive("arrow", N_("an arrow"), "from to by at", "into dashed", laid=1)
def arrow(canvas: Canvas, item: FigureItem) -> None:
    body = canvas.bodies.get(item.name) if item.name else None
    if item.name and body is None:
        canvas.at(item.name)
    colour = canvas.colour(item, BLUE if body is None or body.colour == INK else body.colour)
    if "by" not in item.numbers:
        tail, tip = (canvas.at(item.place(word)) for word in ("from", "to"))
        canvas.arrow(tail, tip, colour)
        canvas.write(item.label, beside(tail, tip), flags=item.flags)
        return
    dx, dy = item.numbers["by"]
    size = math.hypot(dx, dy)
    angle = math.atan2(dy, dx)
    length = max(SHORTEST, size * canvas.arrow_scale.get(item.group, 0.0)) if size else 0.0
    reach = (length * math.cos(angle), length * math.sin(angle))
    if "from" in item.places or "at" in item.places:
        x, y = canvas.at(item.place("from" if "from" in item.places else "at"))
        tail = (x, y)
    elif "to" in item.places:
        x, y = canvas.at(item.place("to"))
        tail = (x - reach[0], y - reach[1])
    elif body is None:
        raise NotDrawable("arrow needs the thing it begins at: arrow A by=v,0, or arrow from=0,0 by=v,0")
    elif "into" in item.flags:
        x, y = body.edge(angle + math.pi)
        tail = (x - reach[0] - GAP * math.cos(angle), y - reach[1] - GAP * math.sin(angle))
    else:
        x, y = body.edge(angle)
        tail = (x + GAP * math.cos(angle), y + GAP * math.sin(angle))
    tip = (tail[0] + reach[0], tail[1] + reach[1])
    if not length:  # at rest there is no arrow, and the words stay
        spots = (
            around((body.x - body.wide, body.y - body.high, body.x + body.wide, body.y + body.high))
            if body
            else []
        )
        canvas.write(item.label, spots or around((*tail, *tail)), flags=item.flags)
        return
    canvas.arrow(tail, tip, colour)
    canvas.write(item.label, beside(tail, tip), flags=item.flags)


@primitive("length", N_("a length"), "from to", laid=1)
def length(canvas: Canvas, item: FigureItem) -> None:
    tail, tip = (canvas.at(item.place(word)) for word in ("from", "to"))
    canvas.arrow(tail, tip, canvas.colour(item), THIN, both=True, size=9)
    canvas.write(item.label, beside(tail, tip), flags=item.flags)


@primitive("line", N_("a line"), "from to through", "dashed")
def line(canvas: Canvas, item: FigureItem) -> None:
    points = (
        list(ends(canvas, item)) if "from" in item.places else [canvas.at(each) for each in _through(item)]
    )
    dashed = "dashed" in item.flags
    colour = canvas.colour(item, "#999" if dashed else INK)
    canvas.path(points, stroke=colour, width=THIN, dashed=dashed, layer=BEHIND if dashed else MIDDLE)
    canvas.write(item.label, beside(points[-2], points[-1]), flags=item.flags)


@primitive("curve", N_("a curve"), "through over of", "dashed")
def curve(canvas: Canvas, item: FigureItem) -> None:
    points = [canvas.at(each) for each in _through(item)]
    colour = canvas.colour(item, BLUE)
    canvas.path(points, stroke=colour, width=2.5, dashed="dashed" in item.flags)
    middle = max(points, key=lambda each: each[1])
    canvas.write(item.label, [*around((*middle, *middle)), *beside(points[-2], points[-1])], flags=item.flags)


@primitive("string", N_("a string"), "from to", "dashed")
def string(canvas: Canvas, item: FigureItem) -> None:
    tail, tip = ends(canvas, item)
    canvas.path([tail, tip], stroke=canvas.colour(item, "#666"), dashed="dashed" in item.flags)
    canvas.write(item.label, beside(tail, tip), flags=item.flags)


@primitive("chain", N_("a chain"), "through")
def chain(canvas: Canvas, item: FigureItem) -> None:
    points = [canvas.at(each) for each in _through(item)]
    drawn = "M" + "L".join(f"{x:.1f} {-y:.1f}" for x, y in points)
    canvas.shapes.append(
        (1, f'<path d="{drawn}" fill="none" stroke="#666" stroke-width="6" stroke-dasharray="9 3"/>')
    )
    canvas.path(points, stroke="#666", width=1)
    canvas.write(item.label, beside(points[-2], points[-1]), flags=item.flags)


@primitive("spring", N_("a spring"), "from to")
def spring(canvas: Canvas, item: FigureItem) -> None:
    tail, tip = ends(canvas, item)
    (x, y), (to_x, to_y) = tail, tip
    far = math.hypot(to_x - x, to_y - y) or 1.0
    c, s = (to_x - x) / far, (to_y - y) / far
    straight = min(12.0, far * 0.15)
    turns = max(4, min(12, round((far - 2 * straight) / 14)))
    step = (far - 2 * straight) / (2 * turns)
    points = [tail, (x + straight * c, y + straight * s)]
    for k in range(2 * turns):
        along, side = straight + (k + 0.5) * step, 9.0 if k % 2 else -9.0
        points.append((x + along * c - side * s, y + along * s + side * c))
    points += [(to_x - straight * c, to_y - straight * s), tip]
    canvas.path(points, stroke=canvas.colour(item), width=2, solid=False)
    box = (
        min(x, to_x) - 9 * abs(s),
        min(y, to_y) - 9 * abs(c),
        max(x, to_x) + 9 * abs(s),
        max(y, to_y) + 9 * abs(c),
    )
    canvas.take(box)
    canvas.write(item.label, around(box), flags=item.flags)


@primitive("angle", N_("an angle"), "at between", "wide")
def angle(canvas: Canvas, item: FigureItem) -> None:
    start, end = item.numbers.get("between", (0.0, 0.0))
    radius = 62.0 if "wide" in item.flags else 40.0
    arc(canvas, canvas.at(item.place("at")), start, end, radius, item.label, canvas.colour(item))


@primitive("axis", N_("an axis"), "from to", laid=1)
def axis(canvas: Canvas, item: FigureItem) -> None:
    tail, tip = (canvas.at(item.place(word)) for word in ("from", "to"))
    canvas.arrow(tail, tip, canvas.colour(item), 2)
    canvas.write(item.label, beside(tail, tip)[6::7] + beside(tail, tip), flags=item.flags)


@primitive("axes", N_("axes"), "", "", laid=3, texts=2)
def axes(canvas: Canvas, item: FigureItem) -> None:
    """The directions of x and y, small, in the corner where there is most room."""
    left, bottom, right, top = canvas.extent()
    tall = len(item.texts) > 1
    upright = item.flags & {"above"}
    wide, high = (24.0, 54.0) if upright else (62.0, 58.0 if tall else 18.0)
    corners = [(right - wide, top - high), (left, top - high), (left, bottom), (right - wide, bottom)]
    corners += [(left + share * (right - left - wide), top - high) for share in (0.5, 0.35, 0.65)]
    outside = (
        [(left, bottom - high - 8)]
        if not tall and not upright
        else [(left - wide - 18, bottom), (right + 18, bottom)]
    )
    x, y = min((*corners, *outside), key=lambda each: canvas.covered((each[0] - 4, each[1] - 4, each[0] + wide + 8, each[1] + high + 4)))  # fmt: skip
    y += 8
    x += 6
    if not upright:
        canvas.arrow((x, y), (x + 44, y), INK, 2, size=9)
        canvas.write(item.label, [TextSpot(x + 48, y, -1, 0)])
    if tall or upright:
        canvas.arrow((x, y), (x, y + 36), INK, 2, size=9)
        canvas.write(item.texts[-1], [TextSpot(x, y + 40, 0, -1)])


@primitive("text", N_("words"), "at", "small")
def text(canvas: Canvas, item: FigureItem) -> None:
    x, y = canvas.at(item.place("at"))
    size = 13 if "small" in item.flags else 15
    across = 1 if "left" in item.flags else -1 if "right" in item.flags else 0
    canvas.write(item.label, [TextSpot(x, y, across, 0)], size=size, fill=canvas.colour(item))


@primitive("note", N_("a note"), "", laid=3)
def note(canvas: Canvas, item: FigureItem) -> None:
    left, bottom, right, _ = canvas.extent()
    canvas.write(item.label, [TextSpot((left + right) / 2, bottom - 5, 0, 1)], size=13)


def _through(item: FigureItem) -> tuple[Point | str, ...]:
    points = item.places.get("through", ())
    if len(points) < 2:
        raise NotDrawable(f"{item.kind} needs two points or more: through=(0,0),(1,2),(2,0)")
    return points
