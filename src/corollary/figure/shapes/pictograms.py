"""Cars, people and other everyday things, each an outline in a box from (−1, 0) to (1, its height), at a size on paper."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from corollary.figure.drawing_sheet import DARK_GREY, TINTS, Attachment, Canvas
from corollary.figure.item import FigureItem, Point
from corollary.figure.primitive import primitive
from corollary.figure.shapes.bodies import known, put
from corollary.messages import N_

Outline = tuple[Point, ...]


@dataclass(frozen=True, slots=True)
class Pictogram:
    """`half` is half its width on paper, `high` its height over that; outlines are filled, strokes are not, wheels and heads are
    circles: middle and radius."""

    noun: str
    half: float
    high: float
    filled: tuple[Outline, ...] = ()
    strokes: tuple[Outline, ...] = ()
    wheels: tuple[tuple[float, float, float], ...] = ()
    middle: float = 0.5


PICTOGRAMS: Final = {
    "car": Pictogram(
        N_("a car"), 62, 0.75,
        filled=(((-1, 0.15), (-1, 0.36), (-0.94, 0.42), (-0.62, 0.46), (-0.36, 0.75), (0.3, 0.75), (0.58, 0.45),
                 (0.9, 0.39), (1, 0.3), (1, 0.15)),),
        wheels=((-0.55, 0.16, 0.16), (0.56, 0.16, 0.16)), middle=0.32,
    ),
    "cart": Pictogram(
        N_("an open car"), 90, 0.56, filled=(((-1, 0.54), (-1, 0.14), (1, 0.14), (1, 0.54), (0.95, 0.54), (0.95, 0.2),
                                              (-0.95, 0.2), (-0.95, 0.54)),),
        wheels=((-0.6, 0.1, 0.1), (0.6, 0.1, 0.1)), middle=0.17,
    ),
    "bike": Pictogram(
        N_("a bicycle with its rider"), 40, 2.0,
        strokes=(((-0.6, 0.4), (-0.25, 1.0), (0.4, 1.0), (0.6, 0.4)), ((-0.6, 0.4), (0.0, 0.4), (0.4, 1.0)),
                 ((-0.25, 1.0), (0.0, 0.4)), ((0.4, 1.0), (0.5, 1.2), (0.66, 1.2)),
                 ((0.05, 0.45), (0.12, 0.85), (-0.26, 1.1), (0.12, 1.6), (0.55, 1.22))),
        wheels=((-0.6, 0.4, 0.38), (0.6, 0.4, 0.38), (0.22, 1.8, 0.19)), middle=0.8,
    ),
    "person": Pictogram(
        N_("a person"), 17, 5.1,
        strokes=(((-0.7, 0), (0, 1.8), (0.7, 0)), ((0, 1.8), (0, 3.8)), ((-0.85, 2.5), (0, 3.3), (0.95, 2.7))),
        wheels=((0, 4.4, 0.62),), middle=2.6,
    ),
    "crouching": Pictogram(
        N_("a person with bent knees"), 17, 3.7,
        strokes=(((-0.5, 0), (0.75, 0.75), (-0.4, 1.25), (0, 2.5)), ((0.95, 1.4), (0.05, 2.2), (-0.75, 1.5))),
        wheels=((0.1, 3.05, 0.62),), middle=1.6,
    ),
    "bullet": Pictogram(
        N_("a bullet"), 18, 0.72,
        filled=(((-1, 0), (0.3, 0), (0.7, 0.1), (0.93, 0.25), (1, 0.36), (0.93, 0.47), (0.7, 0.62), (0.3, 0.72), (-1, 0.72)),),
        middle=0.36,
    ),
    "rocket": Pictogram(
        N_("a rocket"), 84, 0.86,
        filled=(((-0.8, 0.1), (-1, -0.02), (-1, 0.2), (-0.8, 0.3)), ((-0.8, 0.76), (-1, 0.88), (-1, 0.66), (-0.8, 0.56)),
                ((-0.8, 0.1), (0.45, 0.1), (0.72, 0.2), (0.9, 0.33), (1, 0.43), (0.9, 0.53), (0.72, 0.66), (0.45, 0.76), (-0.8, 0.76))),
        middle=0.43,
    ),
    "racket": Pictogram(
        N_("a racket"), 13, 11.2,
        strokes=(((0, 0), (0, 3.9)), ((-0.5, 4.8), (-0.5, 9.4)), ((0, 4.0), (0, 10.2)), ((0.5, 4.8), (0.5, 9.4))),
        filled=(((0, 4.0), (-0.6, 4.5), (-0.95, 5.7), (-1, 7.1), (-0.95, 8.5), (-0.6, 9.7), (0, 10.2), (0.6, 9.7), (0.95, 8.5),
                 (1, 7.1), (0.95, 5.7), (0.6, 4.5)),),
        middle=7.1,
    ),
}  # fmt: skip
"""A row for each; the middle, where arrows begin, is as high as `middle` says."""


def _drawn(it: Pictogram) -> Callable[[Canvas, FigureItem], None]:
    def draw(canvas: Canvas, item: FigureItem) -> None:
        x, y, _ = put(canvas, item, it.half, it.middle * it.half)
        colour = canvas.next_colour(item)
        face = -1 if "backwards" in item.flags else 1

        def shifted(outline: Outline) -> list[Point]:
            return [(x + face * a * it.half, y + (b - it.middle) * it.half) for a, b in outline]

        for outline in it.filled:
            canvas.path(shifted(outline), fill=TINTS[colour], polygon=True, solid=False)
        for outline in it.strokes:
            canvas.path(shifted(outline), solid=False)
        for a, b, radius in it.wheels:
            canvas.circle(
                x + face * a * it.half, y + (b - it.middle) * it.half, radius * it.half,
                fill="#fff" if it.strokes else TINTS[DARK_GREY],
            )  # fmt: skip
        up, down = (it.high - it.middle) * it.half, it.middle * it.half
        room = (x - it.half, y - down, x + it.half, y + up)
        known(canvas, item, Attachment(x, y, it.half, min(up, down), colour), room)

    return draw


for _kind, _it in PICTOGRAMS.items():
    primitive(_kind, _it.noun, "at", "standing backwards outside", laid=0, texts=4)(_drawn(_it))
