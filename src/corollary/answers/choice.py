"""One of several options, by its letter."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import final

from corollary.answers.answer import Answer, Blank, Letter, Unclear
from corollary.answers.answer_type import AnswerType, Sample
from corollary.answers.numbers import PLACEHOLDERS
from corollary.formula.numerals import PLAIN
from corollary.formula.value import Items, Nothing, Refused, Text, Value
from corollary.problem.part import Part
from corollary.problem.problem import Problem

LONGEST = 200
AROUND = r"[\s()\[\].:;,!*_\"'“”„‘’`$]*"
LETTER = re.compile(
    rf"{AROUND}(?:(?:the )?(?:option|answer|choice|alternative|letter|svar|antwort)(?: is)?{AROUND})?(?P<letter>[A-Za-z]){AROUND}",
    re.I,
)


@final
class ChoiceType(AnswerType):
    def read(self, given: Value, part: Part, problem: Problem) -> Answer:
        letters = [option.letter for option in part.options]
        while isinstance(given, Items) and len(given.items) == 1:
            given = given.items[0]
        match given:
            case Nothing():
                return Blank()
            case Text(text) if text.strip() in PLACEHOLDERS:
                return Blank()
            case Text(text):
                found = LETTER.fullmatch(text.translate(PLAIN)) if len(text) <= LONGEST else None
                if found and (letter := found["letter"].lower()) in letters:
                    return Letter(letter, f"({letter})")
                return Unclear(f"answer with one letter of {', '.join(letters)}", text.strip()[:40])
            case Refused(why, shown):
                return Unclear(why, shown)
            case _:
                return Unclear(f"answer with one letter of {', '.join(letters)}, as text", "no letter")

    def samples(self, truth: Sequence[float] | str, part: Part) -> tuple[Sample, ...]:
        assert isinstance(truth, str)
        other = next(option.letter for option in part.options if option.letter != truth)
        return (
            Sample(truth, "right"), Sample(f" ({truth.upper()}) ", "right"), Sample(other, "wrong"),
            Sample("z", "unread"), Sample(7, "unread"), Sample(None, "unread"), Sample([truth, other], "unread"),
        )  # fmt: skip
