"""One quantity judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.answer import Answer, Formulas, Numbers
from corollary.answers.expected import Expected
from corollary.answers.judge_formulas import judge_formulas
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth, to_be_typed
from corollary.answers.verdict import Verdict


def judge(answer: Answer, expected: Expected) -> Verdict:
    """By its number, or by the formula for it."""
    assert expected.quantity is not None
    match answer:
        case Numbers():
            return judge_numbers(answer, expected.quantity, expected.question)
        case Formulas():
            return judge_formulas(answer, expected.quantity, expected.question)
        case _:
            raise TypeError(f"a value is judged by numbers or formulas, not by {type(answer).__name__}")


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """The number itself, four figures of it, with a decimal comma; a number far off; text that is none."""
    assert not isinstance(truth, str)
    (value,), unit = to_be_typed(truth, question)
    comma = f"{value:.4e}".replace(".", ",")
    off = value * 1.37 + (7 if value == 0 else 0)
    return (
        Sample(f"{value!r}{unit}", "right"),
        Sample(f"{value:.4g}{unit}" if value else f"0{unit}", "right"),
        Sample(f"{comma}{unit}", "right"),
        Sample(f"{off!r}{unit}", "wrong"),
        Sample("rather a lot", "unread"),
        Sample(float("nan"), "unread"),
        Sample(None, "unread"),
        Sample([1.0, 2.0, 3.0, 4.0], "unread"),
        Sample(f"{value!r} kg*m^5", "wrong"),
    )
