"""Rays and lenses."""

from __future__ import annotations

import math
from itertools import pairwise

from corollary.figure.drawing_sheet import INK, TINTS, Canvas, FigureItem, NotDrawable, primitive
from corollary.figure.lettering import around
from corollary.figure.shapes.bodies import measured
from corollary.figure.shapes.lines import beside
from corollary.figure.svg import BLUE, VERMILLION
from corollary.messages import N_


@primitive("ray", N_("a ray of light"), "from to through", "dashed")
def ray(canvas: Canvas, item: FigureItem) -> None:
    places = item.places.get("through") or (item.place("from"), item.place("to"))
    if len(places) < 2:
        raise NotDrawable("ray needs two points or more: through=(0,0),(1,2),(2,0)")
    points = [canvas.at(each) for each in places]
    colour = canvas.colour(item, VERMILLION)
    canvas.path(points, stroke=colour, dashed="dashed" in item.flags)
    if "dashed" not in item.flags:
        for (x, y), (to_x, to_y) in pairwise(points):
            if math.hypot(to_x - x, to_y - y) > 30:
                turn = math.atan2(to_y - y, to_x - x)
                middle = ((x + to_x) / 2 + 5 * math.cos(turn), (y + to_y) / 2 + 5 * math.sin(turn))
                canvas.head(middle, turn, colour, 10)
    canvas.write(item.label, beside(points[0], points[1]), flags=item.flags)


@primitive("lens", N_("a lens"), "at length", "diverging", texts=2)
def lens(canvas: Canvas, item: FigureItem) -> None:
    x, y = canvas.at(item.place("at"))
    half = measured(canvas, item, "length", 120.0) / 2
    bulge = 9.0
    turns = [k / 8 - 1 for k in range(17)]
    thin, thick = (3.0, 3.0 + bulge) if "diverging" in item.flags else (1.0 + bulge, 1.0)
    right = [(x + thin + (thick - thin) * t * t, y + half * t) for t in turns]
    left = [(2 * x - a, b) for a, b in reversed(right)]
    canvas.path([*right, *left], fill=TINTS[BLUE], stroke=INK, width=1.5, polygon=True, solid=False)
    box = (x - bulge - 3, y - half, x + bulge + 3, y + half)
    canvas.take(box)
    for each in item.texts:
        canvas.write(each, around(box), flags=item.flags)
