"""A quantity with components: a list of numbers, a text such as `(3, 4) m/s`, or a list of formulas."""

from __future__ import annotations

from collections.abc import Sequence
from typing import final

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType, Sample
from corollary.answers.axes import in_own_axes
from corollary.answers.numbers import vector
from corollary.formula.value import Value
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.units.unit import canonical, si_unit


@final
class VectorType(AnswerType):
    def read(self, given: Value, part: Part, problem: Problem) -> Answer:
        return in_own_axes(given, part, lambda plain: vector(plain, part.unit, part.components, problem))

    def samples(self, truth: Sequence[float] | str, part: Part) -> tuple[Sample, ...]:
        assert not isinstance(truth, str)
        unit = canonical(si_unit(part.unit.dimension))
        name = "" if unit == "1" else f" {unit}"
        scale = max(map(abs, truth)) or 1.0
        return (
            Sample([f"{value!r}{name}" for value in truth], "right"),
            Sample([f"{value:.4g}{name}" for value in truth], "right"),
            Sample([f"{value + 0.37 * scale * (i + 1)!r}{name}" for i, value in enumerate(truth)], "wrong"),
            Sample([f"{value!r}{name}" for value in truth][:-1], "unread"),
            Sample([None] * len(truth), "unread"),
            Sample("north-east", "unread"),
            Sample([[1.0] * len(truth)] * 2, "unread"),
        )
