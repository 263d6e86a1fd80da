"""What earns nothing though it fits something: one number typed nearly everywhere, and a wrong answer written down again."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from corollary.answers.answer import Numbers
from corollary.answers.expected import Values
from corollary.answers.verdict import Follows, Mistaken, Right, Unmarked, Unread, Verdict, Wrong
from corollary.grading.follow_through import copied
from corollary.messages import catalogue
from corollary.problem.part import Part

_ = catalogue(__name__)

SAME = 1e-9  # a number typed twice, and read in two units


def own_work(verdict: Verdict, values: Values | None, earlier: Mapping[str, Values], again: str) -> Verdict:
    """What only copies a wrong answer earns nothing: where a part is the very same as the part `again`, by a misconception, or one
    number that for these givens happens to follow from itself."""
    if values is None:
        return verdict
    match verdict:
        case Follows(parts) if again in parts and copied(values, earlier[again]):
            return replace(verdict, nothing=True)
        case Follows(parts) if len({*values}) == 1 and any(copied(values, earlier[part]) for part in parts):
            return replace(verdict, nothing=True)
        case Mistaken(_, parts) if any(copied(values, earlier[part]) for part in parts if part in earlier):
            return replace(verdict, nothing=True)
        case _:
            return verdict


def one_number(answer: Numbers, part: Part) -> float:
    """The number as it was typed, the same in every component; else not a number."""
    sizes = answer.sizes or (part.unit.si,) * len(answer.values)
    zero = float(part.unit.offset)
    first, *others = ((value - zero) / size for value, size in zip(answer.values, sizes, strict=True))
    return first if all(abs(other - first) <= SAME * abs(first) for other in others) else math.nan


def repeated(typed: Mapping[str, float], judged: Mapping[str, tuple[Verdict, ...]]) -> list[str]:
    """The parts that hold one number which stands in more than half of all parts with a number, and is wrong in one of them.

    Else it may have been found: two bodies have one velocity, one loss of energy is asked for twice.
    """
    for number in typed.values():
        parts = [part for part, other in typed.items() if abs(other - number) <= SAME * abs(number)]
        wrong = any(
            isinstance(verdict, Wrong) or (isinstance(verdict, Mistaken) and verdict.nothing)
            for part in parts
            for verdict in judged[part]
        )
        if wrong and 1 < len(parts) > len(typed) / 2:
            return parts
    return []


def for_nothing(verdict: Verdict) -> Verdict:
    """Of one number typed nearly everywhere only what is right counts."""
    match verdict:
        case Mistaken():
            return replace(verdict, nothing=True)
        case Right(_, False) | Follows(_, True) | Wrong() | Unread() | Unmarked():
            return verdict
        case _:
            return Wrong(
                _("The same number stands in most parts: it earns nothing where it is not the answer.")
            )
