"""Explanations, asked for and read: words, for a person to mark."""

from __future__ import annotations

from typing import final

from corollary.answers.answer import Answer, Blank, Prose, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import PLACEHOLDERS, turned_away
from corollary.answers.question import Question
from corollary.formula.value import Nothing, Refused, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)


@final
class ExplainType(AnswerType):
    name, word, stated_by = "explain", "explanation", "explain"
    found_in = "cell"

    def blank(self, question: Question) -> str:
        return _("*Your answer here.*")

    def read(self, value: Value, question: Question) -> Answer:
        match value:
            case Nothing():
                return Blank()
            case Text(text):
                bare = text.strip().strip("*_").strip()
                empty = bare in PLACEHOLDERS or bare == self.blank(question).strip("*_")
                return Blank() if empty else Prose(text.strip())
            case Refused():
                return turned_away(value)
            case _:
                return Unclear(_("text is asked for"), _("no text"))


TYPE = ExplainType()
