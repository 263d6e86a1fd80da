"""A formula judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.answer import Answer, Formulas
from corollary.answers.expected import Expected
from corollary.answers.formula_in_numbers import has_own_numbers, judge_in_numbers
from corollary.answers.judge_formulas import judge_formulas
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Verdict


def judge(answer: Answer, expected: Expected) -> Verdict:
    """In symbols: numbers put in for some of them are not enough. A formula of a variable may have numbers for all the givens."""
    assert isinstance(answer, Formulas)
    assert expected.quantity is not None
    if has_own_numbers(answer, expected.question):
        return judge_in_numbers(answer, expected.quantity, expected.question)
    return judge_formulas(answer, expected.quantity, expected.question, in_symbols=True)


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` is the formula as text; those of components are parted by semicolons."""
    assert isinstance(truth, str)
    formulas = truth.split("; ")

    def typed(around: str) -> str | list[str]:
        texts = [around.replace("…", each) for each in formulas]
        return texts if question.components else texts[0]

    return (
        Sample(typed("…"), "right"),
        Sample(typed("(…)*7/7"), "right"),
        Sample(typed("1.37*(…)"), "wrong"),
        Sample(typed("… +"), "unread"),
        Sample(typed("q_unknown*(…)"), "unread"),
        Sample(3.0, "unread"),
        Sample(None, "unread"),
    )
