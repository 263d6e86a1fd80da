"""Parts that no machine reads as a value: free text, and the code and figures that are judged by what they do."""

from __future__ import annotations

from collections.abc import Sequence
from typing import final

from corollary.answers.answer import Answer, Blank, Prose, Unclear
from corollary.answers.answer_type import AnswerType, Sample
from corollary.answers.numbers import PLACEHOLDERS
from corollary.formula.value import Nothing, Refused, Text, Value
from corollary.problem.part import Part
from corollary.problem.problem import Problem


@final
class TextType(AnswerType):
    """Explanations and the source of a program: text as it is."""

    def read(self, given: Value, part: Part, problem: Problem) -> Answer:
        match given:
            case Nothing():
                return Blank()
            case Text(text):
                return (
                    Blank()
                    if text.strip().strip("*_").strip() in PLACEHOLDERS | {"Your answer here."}
                    else Prose(text.strip())
                )
            case Refused(why, shown):
                return Unclear(why, shown)
            case _:
                return Unclear("text is asked for", "no text")

    def samples(self, truth: Sequence[float] | str, part: Part) -> tuple[Sample, ...]:
        """Free text waits for a person; none is blank."""
        verdict = "unmarked" if part.kind == "explain" else "right"
        return (Sample(truth if isinstance(truth, str) else "Because.", verdict), Sample(None, "unread"))
