"""Axes a student chose and named: in `(3, 4) m/s, x to the left` the component along x counts the other way."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, replace

from corollary.kind.answer import Answer, Formulas, Numbers, Unclear
from corollary.problem.part import Part
from corollary.quantity.plain import Plain, Text
from corollary.quantity.tree import Negative
from corollary.quantity.unit import unit

LONGEST = 200
DIRECTED = frozenset(unit(text).dimension for text in ("m/s", "m/s^2", "kg*m/s", "N"))  # a mass or an energy turns with no axis
REMARK = re.compile(
    r"[\s,;]\s*\(?(?:with |where |taking )?(?P<axis>[xyz+]|positive)(?:[ -](?:axis|direction|component))?"
    r"(?: is| points?| pointing| taken)?(?: to)?(?: the)? (?P<way>left|right|up|down|upwards?|downwards?|reversed"
    r"|other way|opposite way|opposite)\)?\.?\s*$",
    re.IGNORECASE,
)
USUAL = frozenset({"right", "up", "upward", "upwards"})  # x to the right and y up, as in every figure of the chapter
LETTER = {"left": "x", "right": "x", "up": "y", "upward": "y", "upwards": "y", "down": "y", "downward": "y", "downwards": "y"}


@dataclass(frozen=True, slots=True)
class Axes:
    """A text without its remarks on axes; the sign that takes each component to the usual axes; the remarks as written."""

    text: str
    signs: tuple[int, ...]
    said: str


def in_own_axes(given: Plain, part: Part, read: Callable[[Plain], Answer]) -> Answer:
    """The answer on the problem's axes, when a text names others; `read` reads what is beside the remark."""
    if not isinstance(given, Text) or len(given.text) > LONGEST or not (part.components or part.unit.dimension in DIRECTED):
        return read(given)
    axes = axes_of(given.text, part.components)
    return turned(read(Text(axes.text)), axes) if axes.said else read(given)


def axes_of(text: str, components: tuple[str, ...]) -> Axes:
    """What a text says of axes. A remark on an axis that the answer does not have stays in the text."""
    signs, said = [1] * max(1, len(components)), []
    while (remark := REMARK.search(text)) is not None:
        places = _places(remark["axis"].lower(), remark["way"].lower(), tuple(map(str.lower, components)))
        if not places:
            break
        if remark["way"].lower() not in USUAL:
            for place in places:
                signs[place] = -signs[place]
        said.insert(0, remark[0].strip(" ,;().\t\n"))
        text = text[: remark.start()]
    return Axes(text.rstrip(" ,;"), tuple(signs), ", ".join(said))


def _places(axis: str, way: str, components: tuple[str, ...]) -> list[int]:
    """The components a remark is about. Where they are bodies on one line, or there is but one, it is about them all."""
    if not {"x", "y", "z"} & set(components):
        return list(range(max(1, len(components))))
    letter = axis if axis in {"x", "y", "z"} else LETTER.get(way)
    return [place for place, name in enumerate(components) if letter in (None, name)]


def turned(answer: Answer, axes: Axes) -> Answer:
    """An answer taken to the usual axes."""
    match answer:
        case Numbers() if len(answer.values) == len(axes.signs):
            values = tuple(sign * value + 0.0 for sign, value in zip(axes.signs, answer.values, strict=True))
            return replace(answer, values=values, shown=f"{answer.shown}, {axes.said}")
        case Formulas(trees, shown) if len(trees) == len(axes.signs):
            there = (tree if sign > 0 else Negative(tree) for sign, tree in zip(axes.signs, trees, strict=True))
            return Formulas(tuple(there), f"{shown}, {axes.said}")
        case Unclear(readings=readings):
            found = (turned(each, axes) for each in readings)
            return replace(answer, readings=tuple(each for each in found if isinstance(each, Numbers)))
        case _:
            return answer
