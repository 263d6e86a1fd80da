"""How a ratio is asked for and read: `3 : 2`, `3 to 2`, `1.5`, a formula."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import final

from corollary.answers.answer import Answer, Numbers
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import scalar
from corollary.answers.question import Question
from corollary.formula.value import Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST = 200
SIDES = re.compile(r"\s*(?P<top>[^:]+?)\s*(?::|\bto\b)\s*(?P<bottom>[^:]+?)\s*")


@final
class RatioType(AnswerType):
    name, word = "ratio", "ratio"

    def heading(self, question: Question) -> str:
        return _("A ratio, such as 3 : 2.")

    def blank(self, question: Question) -> str:
        return f"{question.name} = None   # " + _('a ratio as text: "3 : 2"')

    def read(self, value: Value, question: Question) -> Answer:
        found = (
            SIDES.fullmatch(value.text) if isinstance(value, Text) and len(value.text) <= LONGEST else None
        )
        if found is None:
            return scalar(value, question)
        top, bottom = (scalar(Text(found[side]), question) for side in ("top", "bottom"))
        if not (isinstance(top, Numbers) and isinstance(bottom, Numbers) and bottom.values[0]):
            return scalar(Text(f"({found['top']})/({found['bottom']})"), question)
        as_read = f"{top.as_read} : {bottom.as_read}"
        return replace(top, values=(top.values[0] / bottom.values[0],), figures=(0,), as_read=as_read)


TYPE = RatioType()
