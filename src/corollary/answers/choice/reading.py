"""How one of several options is asked for and read, by its letter."""

from __future__ import annotations

import re
from typing import final

from corollary.answers.answer import Answer, Blank, Letter, Unclear
from corollary.answers.answer_type import AnswerType
from corollary.answers.numbers import PLACEHOLDERS, turned_away
from corollary.answers.question import Question
from corollary.formula.numerals import TO_ASCII
from corollary.formula.value import Items, Nothing, Refused, Text, Value
from corollary.messages import catalogue

_ = catalogue(__name__)

LONGEST = 200
AROUND = r"[\s()\[\].:;,!*_\"'“”„‘’`$]*"
LETTER = re.compile(
    rf"{AROUND}(?:(?:the )?(?:option|answer|choice|alternative|letter|svar|antwort)(?: is)?{AROUND})?(?P<letter>[A-Za-z]){AROUND}",
    re.IGNORECASE,
)


@final
class ChoiceType(AnswerType):
    name, word, stated_by = "choice", "choice", "choice"
    accepts = needs = frozenset({"options"})

    def heading(self, question: Question) -> str:
        return _("One letter.")

    def blank(self, question: Question) -> str:
        first, last = question.options[0], question.options[-1]
        remark = _('one letter, "{first}" to "{last}"', first=first, last=last)
        return f"{question.name} = None   # {remark}"

    def read(self, value: Value, question: Question) -> Answer:
        wanted = _("answer with one letter of {letters}", letters=", ".join(question.options))
        while isinstance(value, Items) and len(value.items) == 1:
            value = value.items[0]
        match value:
            case Nothing():
                return Blank()
            case Text(text) if text.strip() in PLACEHOLDERS:
                return Blank()
            case Text(text):
                found = LETTER.fullmatch(text.translate(TO_ASCII)) if len(text) <= LONGEST else None
                if found and (letter := found["letter"].lower()) in question.options:
                    return Letter(letter, f"({letter})")
                return Unclear(wanted, text.strip()[:40])
            case Refused():
                return turned_away(value)
            case _:
                return Unclear(_("{wanted}, as text", wanted=wanted), _("no letter"))


TYPE = ChoiceType()
