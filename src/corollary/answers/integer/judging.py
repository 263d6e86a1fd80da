"""An integer judged without a tolerance, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

import math

from corollary.answers.answer import Answer, Formulas, Numbers
from corollary.answers.expected import Expected
from corollary.answers.judge_formulas import judge_formulas, values_of
from corollary.answers.judge_numbers import judge_numbers
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth, to_be_typed
from corollary.answers.verdict import Verdict, Wrong
from corollary.messages import catalogue

_ = catalogue(__name__)

NEARLY_WHOLE = 1e-9  # relative: what doubles leave of a whole number


def judge(answer: Answer, expected: Expected) -> Verdict:
    """As a value; a wrong number that is not whole is said to be none."""
    wanted, question = expected.quantity, expected.question
    assert wanted is not None
    match answer:
        case Numbers(values):
            found = judge_numbers(answer, wanted, question)
        case Formulas(trees):
            found, values = judge_formulas(answer, wanted, question), values_of(trees, wanted.givens())
        case _:
            raise TypeError(f"a whole number is no {type(answer).__name__}")
    if isinstance(found, Wrong) and not all(map(_is_whole, map(question.unit.from_si, values or ()))):
        return Wrong(_("A whole number is asked for, and this is none."))
    return found


def _is_whole(value: float) -> bool:
    return math.isfinite(value) and abs(value - round(value)) <= NEARLY_WHOLE * max(1.0, abs(value))


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """The whole number, as an integer and as a double; one more; a little more; words that are none."""
    assert not isinstance(truth, str)
    number = round(question.unit.from_si(truth[0]))
    _values, unit = to_be_typed(truth, question)
    unit = f" {question.unit.text}" if unit else ""
    with_noun = () if unit else (Sample(f"{number} bounces", "right"),)
    return (
        *with_noun,
        Sample(f"{number}{unit}", "right"),
        Sample(f"{number}.0{unit}", "right"),
        Sample(f"{number + 1}{unit}", "wrong"),
        Sample(f"{number}.3{unit}", "wrong"),
        Sample("rather a lot", "unread"),
        Sample(None, "unread"),
    )
