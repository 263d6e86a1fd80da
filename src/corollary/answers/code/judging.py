"""A program is judged by what its function returns; its samples are run, not read."""

from __future__ import annotations

from corollary.answers.answer import Answer
from corollary.answers.expected import Expected
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Unread, Verdict
from corollary.messages import catalogue

_ = catalogue(__name__)


def judge(answer: Answer, expected: Expected) -> Verdict:
    """What the function returned when it was called."""
    run = expected.runs.get("code")
    return run() if run is not None else Unread(_("Nothing was run for this part."), blank=True)


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """None: programs have theirs run elsewhere."""
    return ()
