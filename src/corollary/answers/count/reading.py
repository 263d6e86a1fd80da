"""Counts, asked for and read: a whole number, with the noun or without, or the formula for it."""

from __future__ import annotations

import re
from typing import final

from corollary.answers.answer import Answer, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import scalar
from corollary.answers.question import Question
from corollary.formula.value import Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

WITH_NOUN = re.compile(
    r"(?P<count>\s*[-+]?[0-9][0-9.,]{0,20})\s+\(?[^\W\d_]{2,30}(?: [^\W\d_]{2,30}){0,2}\)?\s*[.!]?\s*"
)


@final
class CountType(AnswerType):
    name, word = "count", "count"

    def heading(self, question: Question) -> str:
        return _("A whole number.")

    def blank(self, question: Question) -> str:
        return f"{question.name} = None   # " + _("a whole number (8)")

    def read(self, value: Value, question: Question) -> Answer:
        found = scalar(value, question)
        if (
            isinstance(found, Unclear)
            and isinstance(value, Text)
            and (noun := WITH_NOUN.fullmatch(value.text))
        ):
            bare = scalar(Text(noun["count"]), question)
            return found if isinstance(bare, Unclear) else bare
        return found


TYPE = CountType()
