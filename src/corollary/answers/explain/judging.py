"""An explanation waits for a person; samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.answer import Answer
from corollary.answers.expected import Expected
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Unmarked, Verdict
from corollary.messages import catalogue

_ = catalogue(__name__)


def by_teacher() -> str:
    """What a student reads of an answer in words."""
    return _("An explanation is marked by your teacher, not by the program.")


def judge(answer: Answer, expected: Expected) -> Verdict:
    """A person decides, by the rubric."""
    return Unmarked(by_teacher(), expected.rubric)


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """Words wait for a person; none is blank."""
    return (Sample("Because.", "unmarked"), Sample(None, "unread"))
