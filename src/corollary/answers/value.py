"""One quantity: a number with a unit, or the formula for it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import final

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType, Sample
from corollary.answers.axes import in_own_axes
from corollary.answers.heading import with_heading
from corollary.answers.numbers import scalar
from corollary.formula.value import Value
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.units.unit import canonical, si_unit


@final
class ValueType(AnswerType):
    def read(self, given: Value, part: Part, problem: Problem) -> Answer:
        return in_own_axes(
            given, part, lambda own: with_heading(own, part, lambda plain: scalar(plain, part.unit, problem))
        )

    def samples(self, truth: Sequence[float] | str, part: Part) -> tuple[Sample, ...]:
        assert not isinstance(truth, str)
        return samples(truth[0], part)


def samples(value: float, part: Part) -> tuple[Sample, ...]:
    """The number itself, four figures of it, with a decimal comma; a number far off; text that is none."""
    unit = canonical(si_unit(part.unit.dimension))
    name = "" if unit == "1" else f" {unit}"
    comma = f"{value:.4e}".replace(".", ",")
    off = value * 1.37 + (7 if value == 0 else 0)
    return (
        Sample(f"{value!r}{name}", "right"),
        Sample(f"{value:.4g}{name}" if value else f"0{name}", "right"),
        Sample(f"{comma}{name}", "right"),
        Sample(f"{off!r}{name}", "wrong"),
        Sample("about five", "unread"),
        Sample(float("nan"), "unread"),
        Sample(None, "unread"),
        Sample([1.0, 2.0, 3.0, 4.0], "unread"),
        Sample(f"{value!r} kg*m^5", "wrong"),
    )
