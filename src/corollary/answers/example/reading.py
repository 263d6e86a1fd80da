"""Examples: numbers of the student's own, which must have a property, asked for and read."""

from __future__ import annotations

from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Formulas, Numbers, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.blanks import blank_number, blank_numbers
from corollary.answers.numbers import scalar
from corollary.answers.open_words import with_open_words
from corollary.answers.question import Question
from corollary.answers.vectors import vector
from corollary.formula.value import Value
from corollary.messages import catalogue

_ = catalogue(__name__)


@final
class ExampleType(AnswerType):
    name, word, stated_by = "example", "example", "example"
    accepts = frozenset({"components"})

    def blank(self, question: Question) -> str:
        return blank_numbers(question) if question.components else blank_number(question)

    def read(self, value: Value, question: Question) -> Answer:
        found = vector(value, question) if question.components else scalar(value, question)
        if isinstance(found, Formulas):
            return Unclear(_("give numbers for an example, not formulas"), found.as_read)
        if isinstance(found, Numbers) and found.misfit:
            # Components of several kinds (a mass and a velocity) are asked for as plain numbers in SI: their own units will do.
            own_units = question.unit.text == "1"
            found = replace(found, misfit="") if own_units else Unclear(found.misfit, found.as_read)
        return with_open_words(found, value, question)


TYPE = ExampleType()
