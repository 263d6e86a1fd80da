"""A quantity with components judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.answer import Answer, Formulas, Numbers
from corollary.answers.expected import Expected
from corollary.answers.judge_formulas import judge_formulas
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth, to_be_typed
from corollary.answers.verdict import Verdict


def judge(answer: Answer, expected: Expected) -> Verdict:
    """All components together: a tolerance is relative to their length."""
    assert expected.quantity is not None
    match answer:
        case Numbers():
            return judge_numbers(answer, expected.quantity, expected.question)
        case Formulas():
            return judge_formulas(answer, expected.quantity, expected.question)
        case _:
            raise TypeError(f"a vector is judged by numbers or formulas, not by {type(answer).__name__}")


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """The components with all digits and with four; components that are off; lists that are none."""
    assert not isinstance(truth, str)
    truth, unit = to_be_typed(truth, question)
    scale = max(map(abs, truth)) or 1.0
    return (
        Sample([f"{value!r}{unit}" for value in truth], "right"),
        Sample([f"{value:.4g}{unit}" for value in truth], "right"),
        Sample(
            [f"{value + 0.37 * scale * (place + 1)!r}{unit}" for place, value in enumerate(truth)], "wrong"
        ),
        Sample([f"{value!r}{unit}" for value in truth][:-1], "unread"),
        Sample([None] * len(truth), "unread"),
        Sample("north-east", "unread"),
        Sample([[1.0] * len(truth)] * 2, "unread"),
    )
