"""Quantities, asked for and read: a number with a unit, or the formula for it."""

from __future__ import annotations

from typing import final

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType
from corollary.answers.blanks import blank_number
from corollary.answers.bound import bound_in, bounded
from corollary.answers.direction import on_usual_axes, with_direction
from corollary.answers.numbers import scalar
from corollary.answers.open_words import with_open_words
from corollary.answers.question import Question
from corollary.formula.value import Text, Value
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)


@final
class ValueType(AnswerType):
    name, word, formulas_too = "value", "number", True

    def heading(self, question: Question) -> str:
        unit = show(question.unit)
        return _("A number, in {unit}.", unit=unit) if unit else _("A plain number, without a unit.")

    def blank(self, question: Question) -> str:
        return blank_number(question)

    def read(self, value: Value, question: Question) -> Answer:
        if isinstance(value, Text) and (bound := bound_in(value.text)) is not None:
            return bounded(bound, self.read(Text(bound.text), question), question)

        def directed(own: Value) -> Answer:
            return with_direction(own, question, lambda bare: scalar(bare, question))

        return with_open_words(on_usual_axes(value, question, directed), value, question)


TYPE = ValueType()
