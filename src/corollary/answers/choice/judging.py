"""A choice judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.answer import Answer, Letter
from corollary.answers.expected import Expected
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Mistaken, Right, Unmarked, Verdict, Wrong
from corollary.messages import catalogue

_ = catalogue(__name__)


def judge(answer: Answer, expected: Expected) -> Verdict:
    """Right, or what the option chosen overlooks."""
    assert isinstance(answer, Letter)
    assert expected.option is not None
    if not expected.option.letter:
        return Unmarked(
            _("The options were corrected after this sheet was handed out, so your teacher will decide.")
        )
    if answer.letter == expected.option.letter:
        return Right()
    overlooked = expected.option.misconceptions.get(answer.letter)
    return Mistaken(overlooked) if overlooked else Wrong(_("Another option is the right one."))


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` is the letter of the right option."""
    assert isinstance(truth, str)
    other = next(letter for letter in question.options if letter != truth)
    return (
        Sample(truth, "right"),
        Sample(f" ({truth.upper()}) ", "right"),
        Sample(other, "wrong"),
        Sample("z", "unread"),
        Sample(7, "unread"),
        Sample(None, "unread"),
        Sample([truth, other], "unread"),
    )
