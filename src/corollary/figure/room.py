"""Room for a text: spots about a thing, the room a text takes there, and how much of that is covered."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final, NamedTuple

Box = tuple[float, float, float, float]
"""Left, bottom, right, top."""
ROOM: Final = 4
"""Between a thing and what is written beside it."""


@dataclass(frozen=True, slots=True)
class WaitingText:
    """A text that waits for everything to be drawn; the first `wanted` of the spots are where the author wants it."""

    text: str
    spots: Sequence[TextSpot]
    wanted: int
    size: int
    fill: str
    upright: bool


class TextSpot(NamedTuple):
    """A place for a text: `across` and `up` say which point of the text stands there (-1: its left or lower end; 0: its middle)."""

    x: float
    y: float
    across: float
    up: float


def shared(box: Box, others: Sequence[Box]) -> float:
    """The area that a box shares with others; a loop, for a figure asks this some thousand times."""
    left, bottom, right, top = box
    area = 0.0
    for a, b, c, d in others:
        if a < right and c > left and b < top and d > bottom:
            area += (min(right, c) - max(left, a)) * (min(top, d) - max(bottom, b))
    return area


def around(box: Box) -> list[TextSpot]:
    """Spots about a box, the nearest first: above, below, beside, and further off."""
    left, bottom, right, top = box
    x, y = (left + right) / 2, (bottom + top) / 2
    spots: list[TextSpot] = []
    for gap in (ROOM, 24, 44, 64):
        spots += [TextSpot(x, top + gap, 0, -1), TextSpot(x, bottom - gap, 0, 1)]
        spots += [TextSpot(right + gap + 2, y, -1, 0), TextSpot(left - gap - 2, y, 1, 0)]
    return spots


def lies(spot: TextSpot, flag: str) -> bool:
    match flag:
        case "above":
            return spot.up < 0
        case "below":
            return spot.up > 0
        case "right":
            return spot.across < 0
        case "left":
            return spot.across > 0
        case _:
            return False


def box_of(spot: TextSpot, width: float, size: float) -> Box:
    high = size * 1.25
    x = spot.x - width / 2 - spot.across * width / 2
    y = spot.y - high / 2 - spot.up * high / 2
    return x, y, x + width, y + high
