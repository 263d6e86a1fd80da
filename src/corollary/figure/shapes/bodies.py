"""Bodies: what arrows, strings and springs can be attached to."""

from __future__ import annotations

import math

from corollary.figure.drawing_sheet import DARK_GREY, INK, TINTS, Attachment, Canvas
from corollary.figure.item import FigureItem, NotDrawable
from corollary.figure.primitive import primitive
from corollary.figure.room import Box, around
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
