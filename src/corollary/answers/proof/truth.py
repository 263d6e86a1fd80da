"""Truth of the lines of a derivation, tried at values at which every law holds."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from corollary.answers.answer import Equation
from corollary.answers.evaluation import as_exact, holds_nearly, number, size_of
from corollary.answers.expected import Point
from corollary.formula.ast import Relation, names
from corollary.formula.ball import Undefined

EXACT = 1e-9  # relative: doubles lose some seven digits on the way through a derivation at worst

Truth = Literal["true", "otherwise", "unsure", "false"]
"""A line holds everywhere; or only with its bracket below the line; or not everywhere, as far as is known; or nowhere."""


@dataclass(frozen=True, slots=True)
class World:
    """Values for all letters, those of the student's own too, and how large the terms are that make these up."""

    values: Point
    sizes: dict[str, float]


def truths(steps: Sequence[Equation], points: Sequence[Point]) -> list[Truth]:
    """One for each step."""
    worlds = [_world(steps, point) for point in points]
    return [_truth(step, worlds) for step in steps]


def _truth(step: Equation, worlds: Sequence[World]) -> Truth:
    held = [holds(step.relation, world) for world in worlds]
    if all(held):
        return "true"
    if step.otherwise is not None and all(holds(step.otherwise, world) for world in worlds):
        return "otherwise"
    return "false" if set(held) == {False} else "unsure"


def holds(relation: Relation, world: World) -> bool | None:
    """Whether both sides have a value, and the same; None where a letter of the student's own has none."""
    if not names(relation) - {"pi"} <= world.values.keys():
        return None
    try:
        return holds_nearly(relation, world.values, EXACT, world.sizes)
    except Undefined:
        return False


def _world(steps: Sequence[Equation], point: Point) -> World:
    """Letters of the student's own get a value each after those that they are made of; one without a value has none."""
    values, sizes = dict(point), dict[str, float]()
    waiting = [step for step in steps if step.defines]
    while waiting:
        own = {step.defines for step in waiting}
        step = next(each for each in waiting if not names(each.meaning) & own)
        waiting.remove(step)
        if not names(step.meaning) - {"pi"} <= values.keys():
            continue
        try:
            value, size = as_exact(number(step.meaning, values)), size_of(step.meaning, values, sizes)
        except Undefined:
            continue
        values[step.defines], sizes[step.defines] = value, size
    return World(values, sizes)
