"""Answers whose verdict is known beforehand: each answer type makes its own, and `verify` has them judged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from corollary.answers.question import Question
from corollary.units.unit import ONE, canonical, si_unit

Truth = Sequence[float] | str
"""What is right: values in SI, or a letter, a formula, lines of a proof as text."""


@dataclass(frozen=True, slots=True)
class Sample:
    """An answer as it could be typed, and the verdict it must get ("right", "wrong", "unread" or "unmarked")."""

    answer: Any
    verdict: str


def to_be_typed(truth: Sequence[float], question: Question) -> tuple[list[float], str]:
    """The numbers as they are typed, and what is typed behind them: the SI unit; that of the part where it is an angle, a
    percentage or a temperature."""
    unit = question.unit
    if (unit.dimension == ONE or unit.offset or unit.is_difference) and unit.text != "1":
        return [unit.from_si(value) for value in truth], f" {canonical(unit)}"
    name = canonical(si_unit(unit.dimension))
    return list(truth), "" if name == "1" else f" {name}"
