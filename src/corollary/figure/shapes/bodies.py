"""Bodies, cars, people and other everyday things: what arrows, strings and springs can be attached to."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from corollary.figure.drawing_sheet import (
    DARK_GREY,
    INK,
    TINTS,
    Attachment,
    Canvas,
    FigureItem,
    NotDrawable,
    Point,
    primitive,
)
from corollary.figure.lettering import Box, around
from corollary.messages import N_

RADII, BLOCK = {"small": 10.0, "big": 28.0}, (54.0, 42.0)


def put(canvas: Canvas, item: FigureItem, wide: float, high: float) -> tuple[float, float, float]:
    """Where the middle of a body of this size is, and by how much it is turned; on an incline it stands upon it."""
    if (on := item.places.get("on")) is not None:
        name = str(on[0])
        if name not in canvas.slopes:
            raise NotDrawable(f"on={name}: there is no incline of this name above this line")
        (x, y), length, angle = canvas.slopes[name]
        share = item.number("along")
        reach = length * (0.5 if share is None else share)
        x, y = x + reach * math.cos(angle), y + reach * math.sin(angle)
        return x - high * math.sin(angle), y + high * math.cos(angle), angle
    x, y = canvas.at(item.place("at"))
    return x, y + (high if "standing" in item.flags else 0), item.number("turn") or 0.0


def known(canvas: Canvas, item: FigureItem, body: Attachment, room: Box | None = None) -> None:
    """Enters a body under its name, keeps texts off it, and writes its own beside it."""
    c, s = abs(math.cos(body.turn)), abs(math.sin(body.turn))
    wide, high = (
        (body.wide, body.high)
        if body.round
        else (body.wide * c + body.high * s, body.wide * s + body.high * c)
    )
    box = room or (body.x - wide - 1, body.y - high - 1, body.x + wide + 1, body.y + high + 1)
    canvas.take(box)
    if item.name:
        canvas.bodies[item.name] = body
    if item.marked and ("outside" in item.flags or body.wide < 8):
        canvas.write(item.name, around(box), flags=item.flags, upright=True)
    elif item.marked:
        canvas.mark(item.name, body.x, body.y)
    for text in item.texts:
        canvas.write(text, around(box), flags=item.flags)


def measured(canvas: Canvas, item: FigureItem, word: str, usual: float) -> float:
    """A length in the drawing's units: the author's, or the usual size on paper."""
    length = item.number(word)
    return usual if length is None else abs(length) * canvas.scale


@primitive("ball", N_("a ball"), "at on along radius", "standing dashed small big outside", laid=0, texts=4)
def ball(canvas: Canvas, item: FigureItem) -> None:
    usual = next((radius for flag, radius in RADII.items() if flag in item.flags), 18.0)
    radius = measured(canvas, item, "radius", usual)
    x, y, _ = put(canvas, item, radius, radius)
    colour = canvas.next_colour(item)
    dashed = "dashed" in item.flags
    canvas.circle(
        x,
        y,
        radius,
        stroke=INK if not dashed else colour,
        fill="none" if dashed else TINTS[colour],
        dashed=dashed,
    )
    known(canvas, item, Attachment(x, y, radius, radius, colour, round=True))


@primitive("block", N_("a block"), "at on along size turn", "standing dashed outside", laid=0, texts=4)
def block(canvas: Canvas, item: FigureItem) -> None:
    sizes = item.numbers.get("size")
    wide, high = BLOCK if sizes is None else (sizes[0] * canvas.scale, sizes[-1] * canvas.scale)
    x, y, turn = put(canvas, item, wide / 2, high / 2)
    colour = canvas.next_colour(item)
    body = Attachment(x, y, wide / 2, high / 2, colour, turn=turn)
    c, s = math.cos(turn), math.sin(turn)
    corners = [
        (x + a * wide / 2 * c - b * high / 2 * s, y + a * wide / 2 * s + b * high / 2 * c)
        for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))
    ]
    dashed = "dashed" in item.flags
    canvas.path(
        corners, fill="none" if dashed else TINTS[colour], stroke=colour if dashed else INK, polygon=True, dashed=dashed,
        solid=False,
    )  # fmt: skip
    known(canvas, item, body)


@primitive("pulley", N_("a pulley"), "at radius", laid=0, texts=2)
def pulley(canvas: Canvas, item: FigureItem) -> None:
    radius = measured(canvas, item, "radius", 22.0)
    x, y, _ = put(canvas, item, radius, radius)
    canvas.circle(x, y, radius, fill=TINTS[INK], width=3)
    if not item.marked:
        canvas.circle(x, y, 3, fill=INK, width=0)
    known(canvas, item, Attachment(x, y, radius, radius, round=True))


@primitive("pivot", N_("a pivot"), "at", laid=0, texts=2)
def pivot(canvas: Canvas, item: FigureItem) -> None:
    x, y = canvas.at(item.place("at"))
    canvas.path([(x, y), (x - 13, y - 24), (x + 13, y - 24)], fill=TINTS[DARK_GREY], polygon=True)
    canvas.path([(x - 20, y - 24), (x + 20, y - 24)], width=3)
    canvas.circle(x, y, 3.5, fill="#fff")
    known(canvas, item, Attachment(x, y, 4, 4, round=True), (x - 20, y - 26, x + 20, y + 4))


@primitive("point", N_("a point"), "at", "hidden", laid=0, texts=2)
def point(canvas: Canvas, item: FigureItem) -> None:
    x, y = canvas.at(item.place("at"))
    if "hidden" not in item.flags:
        canvas.circle(x, y, 3.5, fill=canvas.colour(item), width=0)
    texts = (item.name, *item.texts) if item.marked and "hidden" not in item.flags else item.texts
    for text in texts:
        canvas.write(text, around((x - 4, y - 4, x + 4, y + 4)), flags=item.flags)
    if item.name:
        canvas.bodies[item.name] = Attachment(x, y, 0, 0, round=True)


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
