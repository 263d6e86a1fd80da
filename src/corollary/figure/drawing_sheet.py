"""The sheet on which a figure is drawn: places of its things, room for texts, and the table of things that there are."""

from __future__ import annotations

import html
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from typing import Final, Literal

from corollary.figure.lettering import SIZE, Box, TextSpot, WaitingText, box_of, lettered, lies, shared
from corollary.figure.svg import BLUE, GREEN, ORANGE, PURPLE, VERMILLION

Point = tuple[float, float]
Place = Point | str
"""Coordinates, or a thing by its name: `A`, or one of its sides, `A.top`."""


@dataclass(frozen=True, slots=True)
class FigureItem:
    """Lengths are in one unit, whichever; angles in radians; `vectors` are grouped by what they measure, so that arrows of one
    group are drawn to one scale."""

    kind: str
    name: str = ""
    texts: tuple[str, ...] = ()
    places: Mapping[str, tuple[Place, ...]] = field(default_factory=dict[str, tuple[Place, ...]])
    numbers: Mapping[str, tuple[float, ...]] = field(default_factory=dict[str, tuple[float, ...]])
    flags: frozenset[str] = frozenset()
    group: str = ""
    data: tuple[tuple[float, float], ...] = ()
    """On the axes of a graph: the points that somebody who cannot see it is told, in the units of the axes."""
    smooth: bool = False

    @property
    def label(self) -> str:
        return self.texts[0] if self.texts else ""

    @property
    def marked(self) -> bool:
        """Whether its name is written on it: a capital letter or a number; a small letter is for the author's use."""
        return self.name[:1].isupper() or self.name[:1].isdigit()

    def number(self, word: str) -> float | None:
        return self.numbers[word][0] if word in self.numbers else None

    def place(self, word: str) -> Place:
        """Raises NotDrawable when the word is missing."""
        if word not in self.places:
            raise NotDrawable(f"{self.kind} needs {word}=, such as {word}=0,0 or {word}=A")
        return self.places[word][0]


class NotDrawable(ValueError):
    """Something in a figure cannot be drawn; one sentence says what and what to do. `item` is the thing, where it is known."""

    item: FigureItem | None = None


INK: Final = "#222"
DARK_GREY: Final = "#6b6b6b"
"""The grey of curves is too faint for an arrow, on paper and on a dark page."""
COLOURS: Final = {
    "blue": BLUE,
    "red": VERMILLION,
    "green": GREEN,
    "purple": PURPLE,
    "orange": ORANGE,
    "grey": DARK_GREY,
    "black": INK,
}
TINTS: Final = {
    BLUE: "#cfe6f7",
    VERMILLION: "#fbe0cf",
    GREEN: "#cdeee2",
    PURPLE: "#f3dfea",
    ORANGE: "#f8e6bf",
    DARK_GREY: "#e8e8e8",
    INK: "#f4f4f4",
}
IN_TURN: Final = (BLUE, VERMILLION, GREEN, PURPLE)
HEAD: Final = 11
SIDES: Final = {"right": (1, 0), "left": (-1, 0), "top": (0, 1), "bottom": (0, -1)}
BEHIND, MIDDLE, FRONT = range(3)
APART: Final = 3
"""Between texts side by side."""
FREE: Final = 0.5
"""Square units that a text may share with something without anybody noticing."""


@dataclass(frozen=True, slots=True)
class Attachment:
    """What other things can be attached to: the middle and half the size, in the drawing's units, y upwards."""

    x: float
    y: float
    wide: float
    high: float
    colour: str = INK
    round: bool = False
    turn: float = 0.0

    def edge(self, angle: float) -> Point:
        """Where a ray from the middle leaves it."""
        c, s = abs(math.cos(angle - self.turn)), abs(math.sin(angle - self.turn))
        across, up = self.wide / max(c, 1e-9), self.high / max(s, 1e-9)
        reach = self.wide if self.round else min(across, up)
        return self.x + reach * math.cos(angle), self.y + reach * math.sin(angle)


def fixed(number: float) -> str:
    """A coordinate with one decimal at most, and without a minus before zero."""
    text = f"{number:.1f}".removesuffix(".0")
    return "0" if text == "-0" else text


class Canvas:
    """Collects shapes; places are occupied in the author's lengths, everything else in the drawing's units, y upwards."""

    def __init__(self, scale: float, arrow_scale: Mapping[str, float]) -> None:
        self.scale = scale
        self.bodies: dict[str, Attachment] = {}
        self.slopes: dict[str, tuple[Point, float, float]] = {}
        self.shapes: list[tuple[int, str]] = []
        self.areas: list[Box] = []
        self.occupied: list[Box] = []
        self.words: list[Box] = []
        self.waiting: list[WaitingText] = []
        self.arrow_scale = arrow_scale
        self._turns = 0

    # places

    def at(self, place: Place, towards: Place | None = None) -> Point:
        """A place in the drawing's units; of a body its middle, or with `towards` its edge on that side. Raises NotDrawable."""
        if not isinstance(place, str):
            return place[0] * self.scale, place[1] * self.scale
        name, _, side = place.partition(".")
        if name not in self.bodies:
            known = ", ".join(sorted(self.bodies)) or "none"
            raise NotDrawable(
                f"nothing here is called {name}; what has a name: {known} (it stands behind the kind of thing: ball {name} at=…)"
            )
        body = self.bodies[name]
        if side:
            if side not in SIDES:
                raise NotDrawable(f"{place}: the sides are {', '.join(SIDES)}")
            c, s = SIDES[side]
            return body.edge(math.atan2(s, c))
        if towards is None:
            return body.x, body.y
        x, y = self.at(towards)
        return body.edge(math.atan2(y - body.y, x - body.x))

    def colour(self, item: FigureItem, other: str = INK) -> str:
        """The colour the author names, or the usual one."""
        return next((COLOURS[flag] for flag in item.flags if flag in COLOURS), other)

    def next_colour(self, item: FigureItem) -> str:
        """A body's: those with a name on them take colours in turn, so that their arrows can be told apart."""
        if not item.marked:
            return self.colour(item)
        self._turns += 1
        return self.colour(item, IN_TURN[(self._turns - 1) % len(IN_TURN)])

    # shapes

    def path(
        self, points: Sequence[Point], *, stroke: str = INK, width: float = 2, fill: str = "none", dashed: bool = False,
        polygon: bool = False, layer: int = MIDDLE, solid: bool = True,
    ) -> None:  # fmt: skip
        """Straight lines through points; what is `solid` keeps texts away."""
        drawn = "M" + "L".join(f"{fixed(x)} {fixed(-y)}" for x, y in points) + ("Z" if polygon else "")
        dashes = ' stroke-dasharray="5 4"' if dashed else ""
        ends = ' stroke-linejoin="round"' if len(points) > 2 else ""
        line = f' stroke="{stroke}" stroke-width="{width:g}"' if width else ""
        self.shapes.append((layer, f'<path d="{drawn}" fill="{fill}"{line}{dashes}{ends}/>'))
        if solid:
            for one, other in pairwise(points):
                self._take_line(one, other, width / 2 + 1)

    def circle(
        self, x: float, y: float, radius: float, *, stroke: str = INK, fill: str = "none", width: float = 2, dashed: bool = False
    ) -> None:  # fmt: skip
        """A circle; a text lies inside of a large one or outside, not across its edge."""
        dashes = ' stroke-dasharray="5 4"' if dashed else ""
        line = f' stroke="{stroke}" stroke-width="{width:g}"' if width else ""
        place = f'cx="{fixed(x)}" cy="{fixed(-y)}" r="{fixed(radius)}"'
        self.shapes.append((MIDDLE, f'<circle {place} fill="{fill}"{line}{dashes}/>'))
        if radius > 30:
            for k in range(24):
                a, b = x + radius * math.cos(k * math.pi / 12), y + radius * math.sin(k * math.pi / 12)
                self.occupied.append((a - 3, b - 3, a + 3, b + 3))

    def take(self, box: Box) -> None:
        """Keeps texts out of a box, but for those that the author wants on that side."""
        self.areas.append(box)

    def _take_line(self, one: Point, other: Point, half: float) -> None:
        (x, y), (to_x, to_y) = one, other
        parts = 1
        if abs(to_x - x) > 6 and abs(to_y - y) > 6:
            parts = min(24, int(max(abs(to_x - x), abs(to_y - y)) / 8) + 1)
        dx, dy = (to_x - x) / parts, (to_y - y) / parts
        for k in range(parts):
            a, b, c, d = x + k * dx, y + k * dy, x + (k + 1) * dx, y + (k + 1) * dy
            self.occupied.append((min(a, c) - half, min(b, d) - half, max(a, c) + half, max(b, d) + half))

    def head(self, tip: Point, angle: float, colour: str, size: float = HEAD) -> None:
        """The head of an arrow."""
        c, s = math.cos(angle), math.sin(angle)
        back, side = size, size * 0.42
        x, y = tip
        corners = [
            tip,
            (x - back * c - side * s, y - back * s + side * c),
            (x - back * c + side * s, y - back * s - side * c),
        ]
        self.path(corners, fill=colour, width=0, polygon=True, layer=FRONT)

    def arrow(
        self,
        tail: Point,
        tip: Point,
        colour: str,
        width: float = 3,
        *,
        both: bool = False,
        size: float = HEAD,
    ) -> None:
        """A line with a head at its tip, or at both ends."""
        (x, y), (to_x, to_y) = tail, tip
        angle, length = math.atan2(to_y - y, to_x - x), math.hypot(to_x - x, to_y - y)
        size = min(size, length / (2 if both else 1))
        inset = size * 0.7
        c, s = math.cos(angle), math.sin(angle)
        start = (x + inset * c, y + inset * s) if both else tail
        self.path([start, (to_x - inset * c, to_y - inset * s)], stroke=colour, width=width, layer=FRONT)
        self.head(tip, angle, colour, size)
        if both:
            self.head(tail, angle + math.pi, colour, size)

    # texts

    def write(
        self, text: str, spots: Sequence[TextSpot], *, size: int = SIZE, fill: str = INK, flags: Iterable[str] = (),
        upright: bool = False,
    ) -> None:  # fmt: skip
        """Puts a text at the first of the spots where it covers nothing; once everything is drawn."""
        if text:
            wanted = [spot for flag in flags for spot in spots if lies(spot, flag)]
            self.waiting.append(WaitingText(text, [*wanted, *spots], len(wanted), size, fill, upright))

    def mark(self, text: str, x: float, y: float) -> None:
        """A name in the middle of a body."""
        self.shapes.append((FRONT, _text(html.escape(text), x, y - SIZE * 0.36, "middle", SIZE, INK)))
        half = lettered(text)[1] / 2
        self.occupied.append((x - half, y - SIZE / 2, x + half, y + SIZE / 2))

    def finish(self) -> None:
        """Writes what waits, each text where nothing is covered or the least."""
        for each in self.waiting:
            size = each.size
            inside, width = lettered(each.text, size)
            best, cost = each.spots[0], math.inf
            for place, spot in enumerate(each.spots):
                box = box_of(spot, width, size)
                found = self.covered(box, wanted=place < each.wanted)
                if found < cost:
                    best, cost = spot, found
                if cost <= FREE:
                    break
            box = box_of(best, width, size)
            self.words.append((box[0] - APART, box[1], box[2] + APART, box[3]))
            # Narrow fonts leave room to the end: what stands left of a thing is set from its right.
            side = round(best.across) + 1
            x = (box[0], (box[0] + box[2]) / 2, box[2])[side]
            words = html.escape(each.text) if each.upright else inside
            anchor = ("start", "middle", "end")[side]
            self.shapes.append((FRONT, _text(words, x, box[1] + size * 0.28, anchor, size, each.fill)))
        self.waiting.clear()

    def covered(self, box: Box, *, wanted: bool = False) -> float:
        """How much of a box is occupied already; texts weigh more, and an area nothing where the text is `wanted`."""
        areas = 0.0 if wanted else shared(box, self.areas)
        return areas + 2 * shared(box, self.occupied) + 4 * shared(box, self.words)

    def extent(self) -> Box:
        """The box around everything."""
        boxes = [*self.areas, *self.occupied, *self.words] or [(0.0, 0.0, 1.0, 1.0)]
        left, bottom, right, top = zip(*boxes, strict=True)
        return min(left), min(bottom), max(right), max(top)


def _text(inside: str, x: float, y: float, anchor: str, size: int, fill: str) -> str:
    look = "" if size == SIZE else f' font-size="{size}"'
    return f'<text x="{fixed(x)}" y="{fixed(-y)}" text-anchor="{anchor}" fill="{fill}"{look}>{inside}</text>'


Takes = Literal["place", "places", "vector", "lengths", "angles", "number", "axis"]
WORDS: Final[dict[str, Takes]] = {
    "at": "place",
    "from": "place",
    "to": "place",
    "through": "places",
    "by": "vector",
    "radius": "lengths",
    "length": "lengths",
    "size": "lengths",
    "angle": "angles",
    "between": "angles",
    "turn": "angles",
    "along": "number",
    "on": "place",
    "over": "number",
    "x": "axis",
    "y": "axis",
    "units": "axis",
    "steps": "axis",
    "of": "axis",
}
"""What an author can say of a thing, and what kind of value it has."""
TEXT_SIDES: Final = frozenset({"above", "below", "left", "right"})
LAID: Final = 0, 1, 2, 3
"""Bodies first, for others are attached to them; then what joins them; floors below all that; last what goes where there is room."""


@dataclass(frozen=True, slots=True)
class Primitive:
    """`noun` is what a screen reader says; `words` and `flags` are what an author may write of it."""

    kind: str
    noun: str
    draw: Callable[[Canvas, FigureItem], None]
    words: frozenset[str]
    flags: frozenset[str]
    laid: int
    most_texts: int


PRIMITIVES: Final[dict[str, Primitive]] = {}


def primitive(
    kind: str, noun: str, words: str = "", flags: str = "", *, laid: int = 1, texts: int = 1
) -> Callable[[Callable[[Canvas, FigureItem], None]], Callable[[Canvas, FigureItem], None]]:
    """Registers a function as what draws things of a kind; colours and the sides of a text are known to all."""

    def register(draw: Callable[[Canvas, FigureItem], None]) -> Callable[[Canvas, FigureItem], None]:
        every = frozenset(flags.split()) | COLOURS.keys() | TEXT_SIDES
        PRIMITIVES[kind] = Primitive(kind, noun, draw, frozenset(words.split()), every, laid, texts)
        return draw

    return register
