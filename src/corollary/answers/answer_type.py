"""What every kind of question can do: say how it is answered, read an answer, and make up samples of its own."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from corollary.answers.answer import Answer
from corollary.formula.value import Value
from corollary.problem.part import Part
from corollary.problem.problem import Problem


@dataclass(frozen=True, slots=True)
class Sample:
    """An answer as it could be typed, and the verdict it must get ("right", "wrong" or "unread")."""

    answer: Any
    verdict: str


class AnswerType(ABC):
    """One way to ask and to answer."""

    @abstractmethod
    def read(self, given: Value, part: Part, problem: Problem) -> Answer:
        """What the student's value says. Never raises, whatever it is."""

    @abstractmethod
    def samples(self, truth: Sequence[float] | str, part: Part) -> tuple[Sample, ...]:
        """Answers whose verdict is known beforehand, made from the truth (values in SI, or a letter)."""
