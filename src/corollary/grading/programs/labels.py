"""Labels of axes: the unit that a label names, however it is set (`F [kN]`, `F / kN`, `$p_x$ in kg m/s`), and its letters."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

from corollary.units.dimension import Dimension, Unit
from corollary.units.unit import read_unit

FONTS = r"\\(?:math(?:rm|it|bf|sf)|text(?:rm|it|bf|normal)?|mbox|operatorname)\s*\{((?:[^{}]|\{[^{}]*\})*)\}"
NESTED = (
    (re.compile(FONTS), r"\1 "),
    (re.compile(r"\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}"), r"\1/(\2)"),
)
TEX = (
    (re.compile(r"\\(?:rm|it|left|right|displaystyle)\b"), ""),
    (re.compile(r"\\(?:cdot|times|ast)\b"), "*"),
    (re.compile(r"\\mu\b"), "u"),
    (re.compile(r"\\[,;:! ]|~"), " "),
    (re.compile(r"\\([A-Za-z]+)"), r" \1 "),
    (re.compile(r"[${}]|\\"), ""),
)
BRACKETS = re.compile(r"\[([^\[\]]+)\]|\(((?:[^()]|\([^()]*\))+)\)")
LED_IN = re.compile(r"\bin\s+|[,;:]")  # `time in ms`, `Zeit, ms`
METRES = re.compile(r"\bms(\s?\^?\s?[-⁻][12¹²])")  # no millisecond on an axis is raised to -1
LONGEST = 200
MOST_ENDS = 6  # brackets, or places after which a unit may stand


@dataclass(frozen=True, slots=True)
class Label:
    """What a label names: its letters and words without the unit, in small letters, and the units it may name, likeliest first.

    A unit in brackets is the only one. Without them a last letter may be a unit or a name (`time t`, `F/N`).
    """

    name: str
    units: tuple[Unit, ...]

    def unit(self, dimension: Dimension) -> Unit | None:
        """Its unit, when it may be one of this dimension."""
        return next((unit for unit in self.units if unit.dimension == dimension), None)


def read_label(text: str) -> Label:
    """The label of an axis as typed: a bracket decides; else what stands below a slash, after `in` or a comma, or at the end."""
    text = _without_tex(text[:LONGEST])
    for name, inside in _bracketed(text):
        if (found := _unit(inside.removeprefix("in "))) is not None:
            return Label(name, (found,))
    words = text.split()
    ends = [
        text.partition("/")[2],
        *(text[lead.end() :] for lead in list(LED_IN.finditer(text))[-MOST_ENDS:]),
    ]
    ends += [" ".join(words[-count:]) for count in range(min(4, len(words)), 0, -1)]
    units = [found for end in ends if (found := _unit(_bare(end))) is not None]
    name = text.partition("/")[0] if units and "/" in text else text
    return Label(_name(name), tuple(dict.fromkeys(units)))


def _bracketed(text: str) -> Iterator[tuple[str, str]]:
    """Each bracket from the last one on, with what stands around it."""
    for found in reversed(list(BRACKETS.finditer(text))[-MOST_ENDS:]):
        yield _name(text[: found.start()] + " " + text[found.end() :]), found[1] or found[2]


def _without_tex(text: str) -> str:
    for _ in range(3):  # fractions and fonts stand in each other
        for pattern, by in NESTED:
            text = pattern.sub(by, text)
    for pattern, by in TEX:
        text = pattern.sub(by, text)
    return " ".join(text.split())


def _bare(text: str) -> str:
    text = text.strip()
    return text[1:-1] if text[:1] == "(" and text[-1:] == ")" else text


def _unit(text: str) -> Unit | None:
    text = text.strip()
    found = read_unit(METRES.sub(r"m s\1", text)) if text else None
    return found if isinstance(found, Unit) else None


def _name(text: str) -> str:
    """Letters and words in small letters; `p_x`, `p_{x}` and `p x` are the same."""
    return " ".join(re.sub(r"[^\w]|_", " ", text.lower()).split())
