"""Integers, asked for and read: one number, with its unit or the noun of what is counted, or the formula for it."""

from __future__ import annotations

import re
from typing import final

from corollary.answers.answer import Answer, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import scalar
from corollary.answers.question import Question
from corollary.formula.value import Text, Value
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)

WITH_NOUN = re.compile(
    r"(?P<count>\s*[-+]?[0-9][0-9.,]{0,20})\s+\(?[^\W\d_]{2,30}(?: [^\W\d_]{2,30}){0,2}\)?\s*[.!]?\s*"
)


@final
class IntegerType(AnswerType):
    name, word = "integer", "whole number"

    def heading(self, question: Question) -> str:
        unit = show(question.unit)
        return _("A whole number, in {unit}.", unit=unit) if unit else _("A whole number.")

    def blank(self, question: Question) -> str:
        return f"{question.name} = None   # " + _("a whole number (8)")

    def read(self, value: Value, question: Question) -> Answer:
        found = scalar(value, question)
        noun = (
            WITH_NOUN.fullmatch(value.text)
            if isinstance(found, Unclear) and isinstance(value, Text)
            else None
        )
        if noun is None or not question.unit.bare:
            return found
        bare = scalar(Text(noun["count"]), question)
        return found if isinstance(bare, Unclear) else bare


TYPE = IntegerType()
