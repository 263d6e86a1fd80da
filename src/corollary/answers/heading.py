"""The sign that words give a number: `0.43 m/s to the left` is read as -0.43 m/s."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from corollary.answers.answer import Answer, Formulas, Numbers, Unclear
from corollary.answers.direction import direction_of
from corollary.answers.remark import has_axes
from corollary.formula.ast import Negative
from corollary.formula.value import Text, Value
from corollary.problem.part import Part


def with_heading(given: Value, part: Part, read: Callable[[Value], Answer]) -> Answer:
    """The answer with the sign that its words give; two readings where the words alone do not tell it."""
    found = (
        direction_of(given.text, has_axes(part.unit, part.components)) if isinstance(given, Text) else None
    )
    if found is None:
        return read(given)
    answer = read(Text(found.text))
    return _either(answer, found.said) if found.sign is None else _signed(answer, found.sign, found.said)


def _signed(answer: Answer, sign: int, said: str) -> Answer:
    match answer:
        case Numbers((value,)) if value * sign < 0 < sign:
            return _either(answer, said)
        case Numbers((value,)):
            return replace(answer, values=(sign * abs(value),), shown=f"{answer.shown} {said}", in_words=True)
        case Formulas((tree,), shown) if sign < 0:
            return Formulas((Negative(tree),), f"{shown} {said}")
        case _:
            return answer


def _either(answer: Answer, said: str) -> Answer:
    match answer:
        case Numbers((value,)) if value:
            why = f"it is not clear which sign \u201c{said}\u201d gives; write the number with its sign"
            return Unclear(why, f"{answer.shown} {said}", (answer, replace(answer, values=(-value,))))
        case _:
            return answer
