"""Answers whose verdict is known beforehand: each answer type makes its own, and `verify` has them judged."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from corollary.answers.question import Question
from corollary.units.unit import canonical, si_unit

Truth = Sequence[float] | str
"""What is right: values in SI, or a letter, a formula, lines of a proof as text."""


@dataclass(frozen=True, slots=True)
class Sample:
    """An answer as it could be typed, and the verdict it must get ("right", "wrong", "unread" or "unmarked")."""

    answer: Any
    verdict: str


def unit_name(question: Question) -> str:
    """The SI unit of what is asked for, to be written behind a number; "" for a plain number."""
    unit = canonical(si_unit(question.unit.dimension))
    return "" if unit == "1" else f" {unit}"
