"""Lettering of a drawing: letters of quantities slanted, indices below the line, and the room that a text takes."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final, NamedTuple

SIZE: Final = 15
SMALL: Final = 12
GREEK_NAMES: Final = """
    alpha α  beta β  gamma γ  delta δ  epsilon ε  eta η  theta θ  kappa κ  lambda λ  lam λ  mu μ  nu ν  rho ρ
    sigma σ  tau τ  phi φ  chi χ  psi ψ  omega ω  Delta Δ
"""
GREEK: Final[dict[str, str]] = dict(zip(GREEK_NAMES.split()[::2], GREEK_NAMES.split()[1::2], strict=True))
NAMED = re.compile(rf"(?<![\w.])({'|'.join(GREEK)})(?=$|[^\w]|_|\d)")
CHANGE = re.compile(r"Δ +(?=[A-Za-z])")
SYMBOL = re.compile(
    r"(?<![\w.])(?P<change>Δ?)(?P<letter>[A-Za-zα-ω])(?:_(?P<long>\w+)|(?P<digits>\d+))?(?![\w'’])"
)
UNIT_AHEAD: Final = "\N{NO-BREAK SPACE}"
"""Stands between a number and its unit, and nowhere else: a text with one is more than a formula."""
OF_AN_AXIS = re.compile(rf" [^\W\d]+{UNIT_AHEAD}\D")
"""What stands behind the letter of an axis: ` in kg`."""
NARROW, WIDE = frozenset("ijlI.,:;'|!()[] ft"), frozenset("mwMW@%—Δ")


@lru_cache(maxsize=4096)
def spoken(text: str) -> str:
    """The text as it is read aloud: Greek letters as letters, indices behind an underscore."""
    return CHANGE.sub("Δ", NAMED.sub(lambda found: GREEK[found[1]], text)).replace("-", "−")


@lru_cache(maxsize=4096)
def lettered(text: str, size: int = SIZE) -> tuple[str, float]:
    """The text as what stands inside of an SVG `text`, and its width in the drawing's units, rather too large than too small."""
    text = spoken(text)
    formula = UNIT_AHEAD not in text and not re.search(r"(?<!_)\b[A-Za-z]{2,}|\([a-z]\)", text)
    out, width, at, lowered = "", 0.0, 0, False
    for found in SYMBOL.finditer(text):
        index = found["long"] or found["digits"] or ""
        letter = found["letter"]
        named = index or letter > "z" or re.match(r"\s*[=<>≈]", text[found.end() :])
        named = named or OF_AN_AXIS.match(text[found.end() :])
        named = named or text[: found.start()].rstrip().endswith(("<", ">", "≈"))
        if not (named or formula) or text[: found.start()].endswith(UNIT_AHEAD):
            continue
        before = text[at : found.start()] + found["change"]
        slanted = f'<tspan font-style="italic">{letter}</tspan>'
        out += _back(before, lowered) + (
            f'<tspan dy="-4">{slanted}</tspan>' if lowered and not before else slanted
        )
        lowered = bool(index)
        if index:
            out += f'<tspan dy="4" font-size="{round(size * 0.74)}">{html.escape(index)}</tspan>'
        width += _width(before + letter, size) + _width(index, size * 0.74)
        at = found.end()
    return out + _back(text[at:], lowered), width + _width(text[at:], size)


def _back(text: str, lowered: bool) -> str:
    """The text on the line again, after an index."""
    words = html.escape(text, quote=False)
    return f'<tspan dy="-4">{words}</tspan>' if lowered and words else words


def _width(text: str, size: float) -> float:
    """By the widths of DejaVu Sans, the widest of the usual sans-serif fonts."""
    return size * sum(0.36 if each in NARROW else 0.96 if each in WIDE else 0.66 for each in text)


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
