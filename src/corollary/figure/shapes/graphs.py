"""The axes of a graph with their grid, ticks and titles."""

from __future__ import annotations

import math

from corollary.figure.drawing_sheet import BEHIND, INK, Canvas, FigureItem, primitive
from corollary.figure.graph_scale import HIGH, WIDE, GraphScale
from corollary.figure.lettering import TextSpot, lettered
from corollary.messages import N_

THIN_LINE, GRID_LINE = "#e3e3e3", "#b5b5b5"
TICK_SIZE = 12
LABEL_GAP = 6.0
BELOW = 20.0  # under the numbers of the horizontal axis
CLOSEST = 6.0  # units between two thin lines: nearer ones cannot be counted


@primitive("graph", N_("a graph"), "x y units steps", "plain sketch", laid=0, texts=2)
def graph(canvas: Canvas, item: FigureItem) -> None:
    x, y = GraphScale(*item.numbers["x"]), GraphScale(*item.numbers["y"])
    wide, high = WIDE * canvas.scale, HIGH * canvas.scale
    canvas.take((0.0, 0.0, 1.0, 1.0))
    if not item.flags & {"plain", "sketch"}:
        for scale, size in ((x, wide), (y, high)):
            parts = scale.parts if size / len(scale.ticks) / scale.parts >= CLOSEST else 1
            for stroke, each in ((THIN_LINE, parts), (GRID_LINE, 1)):
                count = (len(scale.ticks) - 1) * each
                for k in range(count + 1):
                    at = k / count * size
                    ends = [(at, 0.0), (at, high)] if scale is x else [(0.0, at), (wide, at)]
                    canvas.path(ends, stroke=stroke, width=1, layer=BEHIND, solid=False)
    zero = y.share(0.0) * high if y.low < 0 < y.high else 0.0
    upright = x.share(0.0) * wide if x.low < 0 < x.high else 0.0
    canvas.path([(0.0, zero), (wide, zero)], stroke=INK, width=1.5, layer=BEHIND, solid=False)
    canvas.path([(upright, 0.0), (upright, high)], stroke=INK, width=1.5, layer=BEHIND, solid=False)
    across, up = (*item.texts, "", "")[:2]
    left = below = 0.0
    if "sketch" not in item.flags:
        _labels(canvas, x, wide, along=True)
        left, below = _labels(canvas, y, high, along=False), BELOW
    canvas.write(across, [TextSpot(wide, -LABEL_GAP - below, 1, 1)])
    canvas.write(up, [TextSpot(-left, high + 10, -1, -1)])


def _labels(canvas: Canvas, scale: GraphScale, size: float, *, along: bool) -> float:
    """The numbers at the ticks, so many as there is room for; the width of the widest."""
    texts = [scale.text(tick) for tick in scale.ticks]
    widest = max(lettered(text, TICK_SIZE)[1] for text in texts)
    room = (widest if along else TICK_SIZE) + 6
    every = max(1, math.ceil(room * (len(texts) - 1) / size))
    for tick, text in list(zip(scale.ticks, texts, strict=True))[::every]:
        at = scale.share(tick) * size
        spot = TextSpot(at, -LABEL_GAP, 0, 1) if along else TextSpot(-LABEL_GAP, at, 1, 0)
        canvas.write(text, [spot], size=TICK_SIZE)
    return widest + LABEL_GAP
