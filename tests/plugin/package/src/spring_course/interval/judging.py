"""An interval judged by its two ends, in whichever order they were given."""

from __future__ import annotations

from dataclasses import replace

from corollary.answers.answer import Answer, Formulas, Numbers
from corollary.answers.expected import Expected
from corollary.answers.judge_formulas import judge_formulas
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth, to_be_typed
from corollary.answers.verdict import Verdict


def judge(answer: Answer, expected: Expected) -> Verdict:
    """Both ends together, the smaller first."""
    assert expected.quantity is not None
    match answer:
        case Numbers(values) if values[0] > values[1]:
            turned = replace(
                answer, values=values[::-1], figures=answer.figures[::-1], sizes=answer.sizes[::-1]
            )
            return judge_numbers(turned, expected.quantity, expected.question)
        case Numbers():
            return judge_numbers(answer, expected.quantity, expected.question)
        case Formulas():
            return judge_formulas(answer, expected.quantity, expected.question)
        case _:
            raise TypeError(f"an interval is judged by its ends, not by {type(answer).__name__}")


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """Both ends in words, in brackets, the other way round; too wide an interval; one number."""
    assert not isinstance(truth, str)
    (low, high), unit = to_be_typed(truth, question)
    return (
        Sample(f"{low!r}{unit} to {high!r}{unit}", "right"),
        Sample(f"between {high!r}{unit} and {low!r}{unit}", "right"),
        Sample(f"{low!r}{unit} < x < {high!r}{unit}", "right"),
        Sample([f"{low!r}{unit}", f"{high!r}{unit}"], "right"),
        Sample(f"{low - 0.4 * (high - low)!r}{unit} to {high!r}{unit}", "wrong"),
        Sample(f"{low!r}{unit}", "unread"),
        Sample(None, "unread"),
    )
