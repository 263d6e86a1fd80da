"""Fields in the text of a question, as Moodle reads them (*Embedded answers*, Cloze), and the ranges that earn marks in them."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction
from xml.sax.saxutils import escape

from corollary.render.item import ChoiceAsked, Credit, NumbersAsked, PartAsked
from corollary.render.tex_html import tex_inline
from corollary.units.unit import show

SPECIAL = frozenset("&#~{}=%\\\"'<>:")
"""What means something inside of a field."""


def cloze(asked: PartAsked, size: int) -> str:
    """The fields of a part; `size` times its points are whole numbers. Raises TypeError for a part that has no fields."""
    points = int(_points(asked) * size)
    match asked:
        case ChoiceAsked(options=options):
            alternatives = (
                _alternative(each.share, _inside(tex_inline(each.option.text)), each.feedback)
                for each in options
            )
            return f"<p>{{{points}:MCV:{'~'.join(alternatives)}}}</p>"
        case NumbersAsked(components=components):
            unit = f" {escape(show(asked.unit))}" if show(asked.unit) else ""
            lines: list[str] = []
            for place, name in enumerate(components):
                alternatives = (
                    _alternative(mark.share, f"{middle}:{reach}", mark.feedback)
                    for middle, reach, mark in answers_in(asked, place)
                )
                before = f"{escape(name)}: " if name else ""
                lines.append(f"{before}{{{points}:NUMERICAL:{'~'.join(alternatives)}}}{unit}")
            return f"<p>{'<br>'.join(lines)}</p>"
        case _:
            raise TypeError(f"{type(asked).__name__} has no field")


def size_of_points(asked: Sequence[PartAsked]) -> int:
    """What makes whole numbers of the points of every field, which Moodle wants."""
    return math.lcm(*(_points(each).denominator for each in asked))


def answers_in(asked: NumbersAsked, place: int) -> Iterator[tuple[str, str, Credit]]:
    """The middle of each range and how far it reaches, as Moodle has them."""
    for low, high, mark in _ranges(asked, place):
        yield f"{(low + high) / 2 + 0.0:.7g}", f"{(high - low) / 2:.6g}", mark


def by_component(asked: NumbersAsked, numbers: Sequence[float]) -> float:
    """What Moodle gives for these numbers: each component earns its share by itself."""
    earned = 0.0
    for place, number in enumerate(numbers):
        fields = ((low, high, each.share) for low, high, each in _ranges(asked, place))
        earned += next((share for low, high, share in fields if low <= number <= high), 0.0)
    return earned / len(asked.components)


def _points(asked: PartAsked) -> Fraction:
    """Those of one field: components share them."""
    fields = len(asked.components) if isinstance(asked, NumbersAsked) else 1
    return Fraction(asked.prompt.out_of).limit_denominator(1000) / fields


def _ranges(asked: NumbersAsked, place: int) -> Iterator[tuple[float, float, Credit]]:
    """What one component may lie between, in the order of trying, without what an earlier range covers."""
    seen: list[tuple[float, float]] = []
    for mark in asked.marks:
        low, high = mark.ranges()[place]
        room = 1e-6 * (high - low)
        if not any(a - room <= low and high <= b + room for a, b in seen):
            seen.append((low, high))
            yield low, high, mark


def _alternative(share: float, answer: str, feedback: str) -> str:
    grade = "=" if share == 1 else f"%{100 * share:.5g}%"
    return grade + answer + (f"#{_inside(tex_inline(feedback))}" if feedback else "")


def _inside(html: str) -> str:
    """HTML as it may stand in a field: Moodle decodes entities there."""
    return "".join(f"&#{ord(sign)};" if sign in SPECIAL else sign for sign in html)
