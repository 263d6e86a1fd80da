"""Numbers of the student's own that must have a property."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Formulas, Numbers, Unclear
from corollary.answers.answer_type import AnswerType, Sample
from corollary.answers.numbers import vector
from corollary.formula.value import Value
from corollary.problem.part import Part
from corollary.problem.problem import Problem


@final
class ExampleType(AnswerType):
    def read(self, given: Value, part: Part, problem: Problem) -> Answer:
        found = vector(given, part.unit, part.components, problem)
        if isinstance(found, Formulas):
            return Unclear("give numbers for an example, not formulas", found.shown)
        if isinstance(found, Numbers) and found.misfit:
            # components of several kinds (a mass and a velocity) are asked for as plain numbers in SI: their own units will do
            return replace(found, misfit="") if part.unit.text == "1" else Unclear(found.misfit, found.shown)
        return found

    def samples(self, truth: Sequence[float] | str, part: Part) -> tuple[Sample, ...]:
        """`truth` is one good example."""
        assert not isinstance(truth, str)
        scale = max(map(abs, truth)) or 1.0
        return (
            Sample(list(truth), "right"),
            Sample([value + 0.31 * scale for value in truth], "wrong"),
            Sample(list(truth)[:-1], "unread"),
            Sample("any", "unread"),
            Sample([None] * len(truth), "unread"),
        )
