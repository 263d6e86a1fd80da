"""How an interval is asked for and read: `-0.2 m to 0.2 m`, `[-0.2, 0.2] m`, `-0.2 m < x < 0.2 m`, a list of two numbers."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Numbers
from corollary.answers.answer_type import AnswerType
from corollary.answers.question import Question
from corollary.answers.vectors import vector
from corollary.formula.value import Text, Value
from corollary.messages import catalogue
from corollary.units.unit import show

_ = catalogue(__name__)

LONGEST = 200
FROM_TO = re.compile(r"\s*(?:(?:from|between)\s+)?(?P<low>\S.*?)\s+(?:to|and|\.\.\.?|…)\s+(?P<high>\S.*?)\s*")
CHAIN = re.compile(r"(?P<low>[^<≤]+)(?:<=?|≤)\s*[A-Za-z]\w*\s*(?:<=?|≤)(?P<high>[^<≤]+)")


@final
class IntervalType(AnswerType):
    name, word = "interval", "interval"
    accepts = needs = frozenset({"components"})

    def heading(self, question: Question) -> str:
        return _("An interval, in {unit}: from where to where.", unit=show(question.unit))

    def blank(self, question: Question) -> str:
        return f"{question.name} = None   # " + _('an interval as text: "-1.5 to 2.5"')

    def read(self, value: Value, question: Question) -> Answer:
        if isinstance(value, Text) and len(value.text) <= LONGEST:
            found = CHAIN.fullmatch(value.text) or FROM_TO.fullmatch(value.text)
            if found is not None:
                value = Text(f"{found['low']}; {found['high']}")
        answer = vector(value, question)
        if isinstance(answer, Numbers):
            low, high = answer.as_read.strip("()").split(", ", 1)
            return replace(answer, as_read=_("from {low} to {high}", low=low, high=high))
        return answer


TYPE = IntervalType()
