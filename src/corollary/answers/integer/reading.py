"""Integers, asked for and read: one number, with its unit where there is one, or the formula for it."""

from __future__ import annotations

from typing import final

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import scalar
from corollary.answers.question import Question
from corollary.formula.value import Value
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)


@final
class IntegerType(AnswerType):
    name, word = "integer", "whole number"

    def heading(self, question: Question) -> str:
        unit = show(question.unit)
        return _("A whole number, in {unit}.", unit=unit) if unit else _("A whole number.")

    def blank(self, question: Question) -> str:
        return f"{question.name} = None   # " + _("a whole number (8)")

    def read(self, value: Value, question: Question) -> Answer:
        return scalar(value, question)


TYPE = IntegerType()
