"""Vectors, asked for and read: a list of numbers or formulas, or a text such as `(3, 4) m/s`."""

from __future__ import annotations

from typing import final

from corollary.answers.answer import Answer
from corollary.answers.answer_type import AnswerType
from corollary.answers.blanks import blank_numbers
from corollary.answers.direction import on_usual_axes
from corollary.answers.open_words import with_open_words
from corollary.answers.question import Question
from corollary.answers.vectors import vector
from corollary.formula.value import Value
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)


@final
class VectorType(AnswerType):
    name, word, formulas_too = "vector", "vector", True
    accepts = needs = frozenset({"components"})

    def heading(self, question: Question) -> str:
        unit, names = show(question.unit), ", ".join(question.components)
        return (
            _("A list [{names}], in {unit}.", names=names, unit=unit)
            if unit
            else _("A list [{names}].", names=names)
        )

    def blank(self, question: Question) -> str:
        return blank_numbers(question)

    def read(self, value: Value, question: Question) -> Answer:
        found = on_usual_axes(value, question, lambda own: vector(own, question))
        return with_open_words(found, value, question)


TYPE = VectorType()
