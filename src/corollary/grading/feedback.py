"""What the student reads of each verdict: a sentence or two that help, and never the value unless it is to be revealed."""

from __future__ import annotations

from typing import assert_never

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.formula.numerals import decimal_text
from corollary.grading.key import Key
from corollary.problem.part import Part
from corollary.units.unit import show


def sentence(verdict: Verdict) -> str:
    """The verdict in the student's words, as Markdown."""
    match verdict:
        case Right(note):
            return note or "Right."
        case Follows(earlier):
            return f"This follows correctly from your answer in {_parts(earlier)}, though that answer is not right."
        case Mistaken(mistake, earlier):
            return mistake + (
                f" (Your answer in {_parts(earlier)} was carried along and costs nothing here.)"
                if earlier
                else ""
            )
        case Slip(slip):
            return f"Nearly. {slip}"
        case Wrong(why):
            return f"Not right. {why}".strip()
        case Unread(why, _):
            return why
        case Unmarked(why, _):
            return why
        case _:
            assert_never(verdict)


def revealed(key: Key, part: Part) -> str:
    """The answer in words, for feedback that may show it; empty where a part has none."""
    if part.id in key.choices:
        return f"The answer is ({key.choices[part.id]})."
    truth = key.truths.get(part.id)
    if truth is None:
        return ""
    size = part.unit.si
    numbers = [decimal_text(value / size, 4) for value in truth.values]
    unit = show(part.unit)
    body = numbers[0] if len(numbers) == 1 else f"({', '.join(numbers)})"
    return f"The answer is {body}{' ' if unit else ''}{unit}."


def _parts(earlier: tuple[str, ...]) -> str:
    return " and ".join(f"({part})" for part in earlier)
