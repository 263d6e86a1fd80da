"""Parts of an electric circuit, each between two points."""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.figure.drawing_sheet import INK, TINTS, Canvas, FigureItem, NotDrawable, Point, primitive
from corollary.figure.lettering import around
from corollary.figure.shapes.lines import ends
from corollary.messages import N_

HIGH = 9.0


def part(
    canvas: Canvas,
    item: FigureItem,
    half: float,
    lines: Sequence[tuple[Sequence[Point], float]],
    *,
    polygon: bool = False,
) -> None:
    """Wires to both ends of a symbol in the middle; its lines are in (along, across), each with its width."""
    (x, y), (to_x, to_y) = ends(canvas, item)
    far = math.hypot(to_x - x, to_y - y)
    if far < 2 * half:
        raise NotDrawable(f"{item.kind}: its ends are too close together; put from= and to= further apart")
    c, s = (to_x - x) / far, (to_y - y) / far
    middle = ((x + to_x) / 2, (y + to_y) / 2)
    for one, end in (((x, y), -half), ((to_x, to_y), half)):
        canvas.path([one, (middle[0] + end * c, middle[1] + end * s)])
    for points, width in lines:
        turned = [(middle[0] + a * c - b * s, middle[1] + a * s + b * c) for a, b in points]
        canvas.path(turned, stroke=canvas.colour(item), width=width, polygon=polygon, fill=TINTS[INK] if polygon else "none", solid=False)  # fmt: skip
    wide, high = half * abs(c) + 14 * abs(s), half * abs(s) + 14 * abs(c)
    box = (middle[0] - wide, middle[1] - high, middle[0] + wide, middle[1] + high)
    canvas.take(box)
    spots = around(box)
    canvas.write(item.label, spots if abs(c) > 0.5 else [spots[2], spots[3], *spots], flags=item.flags)


@primitive("wire", N_("a wire"), "from to through")
def wire(canvas: Canvas, item: FigureItem) -> None:
    places = item.places.get("through") or (item.place("from"), item.place("to"))
    canvas.path([canvas.at(each) for each in places])


@primitive("resistor", N_("a resistor"), "from to")
def resistor(canvas: Canvas, item: FigureItem) -> None:
    part(canvas, item, 24, [([(-24, -HIGH), (24, -HIGH), (24, HIGH), (-24, HIGH)], 2)], polygon=True)


@primitive("battery", N_("a battery"), "from to")
def battery(canvas: Canvas, item: FigureItem) -> None:
    part(canvas, item, 4, [([(-4, -9), (-4, 9)], 4), ([(4, -18), (4, 18)], 2)])


@primitive("capacitor", N_("a capacitor"), "from to")
def capacitor(canvas: Canvas, item: FigureItem) -> None:
    part(canvas, item, 5, [([(-5, -16), (-5, 16)], 2.5), ([(5, -16), (5, 16)], 2.5)])


@primitive("meter", N_("a meter"), "from to")
def meter(canvas: Canvas, item: FigureItem) -> None:
    """An ammeter or a voltmeter: its name is the letter in the circle."""
    circle = [(15 * math.cos(k * math.pi / 12), 15 * math.sin(k * math.pi / 12)) for k in range(24)]
    part(canvas, item, 15, [(circle, 2)], polygon=True)
    (x, y), (to_x, to_y) = ends(canvas, item)
    canvas.mark(item.name, (x + to_x) / 2, (y + to_y) / 2)
