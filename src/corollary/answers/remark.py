"""What a student says of axes: in `(3, 4) m/s, x to the left` the remark is `x to the left`, and the component along x turns."""

from __future__ import annotations

import re
from dataclasses import dataclass

from corollary.units.unit import Unit, unit

LONGEST = 200
DIRECTED = frozenset(
    unit(text).dimension for text in ("m/s", "m/s^2", "kg*m/s", "N")
)  # a mass or an energy turns with no axis
REMARK = re.compile(
    r"[\s,;]\s*\(?(?:with |where |taking )?(?P<axis>[xyz+]|positive)(?:[ -](?:axis|direction|component))?"
    r"(?: is| points?| pointing| taken)?(?: to)?(?: the)? (?P<way>left|right|up|down|upwards?|downwards?|reversed"
    r"|other way|opposite way|opposite)\)?\.?\s*$",
    re.IGNORECASE,
)
USUAL = frozenset(
    {"right", "up", "upward", "upwards"}
)  # x to the right and y up, as in every figure of the chapter
LETTER = {
    "left": "x",
    "right": "x",
    "up": "y",
    "upward": "y",
    "upwards": "y",
    "down": "y",
    "downward": "y",
    "downwards": "y",
}


@dataclass(frozen=True, slots=True)
class Axes:
    """A text without its remarks on axes; the sign that takes each component to the usual axes; the remarks as written."""

    text: str
    signs: tuple[int, ...]
    said: str


def has_axes(unit: Unit, components: tuple[str, ...]) -> bool:
    """Whether an answer of this kind turns with the axes, so that a remark on them means something."""
    return bool(components) or unit.dimension in DIRECTED


def axes_of(text: str, components: tuple[str, ...]) -> Axes:
    """What a text says of axes. A remark on an axis that the answer does not have stays in the text, as in a text too long."""
    signs, said = [1] * max(1, len(components)), []
    while len(text) <= LONGEST and (remark := REMARK.search(text)) is not None:
        places = _places(remark["axis"].lower(), remark["way"].lower(), tuple(map(str.lower, components)))
        if not places:
            break
        if remark["way"].lower() not in USUAL:
            for place in places:
                signs[place] = -signs[place]
        said.insert(0, text[remark.start("axis") :].strip(" ,;().\t\n"))
        text = text[: remark.start()]
    return Axes(text.rstrip(" ,;"), tuple(signs), ", ".join(said)) if said else Axes(text, tuple(signs), "")


def _places(axis: str, way: str, components: tuple[str, ...]) -> list[int]:
    """The components a remark is about. Where they are bodies on one line, or there is but one, it is about them all."""
    if not {"x", "y", "z"} & set(components):
        return list(range(max(1, len(components))))
    letter = axis if axis in {"x", "y", "z"} else LETTER.get(way)
    return [place for place, name in enumerate(components) if letter in (None, name)]
