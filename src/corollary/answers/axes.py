"""Axes a student chose and named: in `(3, 4) m/s, x to the left` the component along x counts the other way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from corollary.answers.answer import Answer, Formulas, Numbers, Unclear
from corollary.answers.remark import Axes, axes_of, has_axes
from corollary.formula.ast import Negative
from corollary.formula.value import Text, Value
from corollary.problem.part import Part


def in_own_axes(given: Value, part: Part, read: Callable[[Value], Answer]) -> Answer:
    """The answer on the problem's axes, when a text names others; `read` reads what is beside the remark."""
    if not isinstance(given, Text) or not has_axes(part.unit, part.components):
        return read(given)
    axes = axes_of(given.text, part.components)
    return turned(read(Text(axes.text)), axes) if axes.said else read(given)


def turned(answer: Answer, axes: Axes) -> Answer:
    """An answer taken to the usual axes."""
    match answer:
        case Numbers() if len(answer.values) == len(axes.signs):
            values = tuple(sign * value + 0.0 for sign, value in zip(axes.signs, answer.values, strict=True))
            return replace(answer, values=values, shown=f"{answer.shown}, {axes.said}")
        case Formulas(trees, shown) if len(trees) == len(axes.signs):
            there = (
                tree if sign > 0 else Negative(tree) for sign, tree in zip(axes.signs, trees, strict=True)
            )
            return Formulas(tuple(there), f"{shown}, {axes.said}")
        case Unclear(readings=readings):
            found = (turned(each, axes) for each in readings)
            return replace(answer, readings=tuple(each for each in found if isinstance(each, Numbers)))
        case _:
            return answer
