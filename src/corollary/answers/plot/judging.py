"""A figure is judged by what was drawn; its samples are run, not read."""

from __future__ import annotations

from corollary.answers.answer import Answer
from corollary.answers.expected import Expected
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.verdict import Unread, Verdict
from corollary.messages import catalogue

_ = catalogue(__name__)


def judge(answer: Answer, expected: Expected) -> Verdict:
    """What was drawn when the notebook was run."""
    run = expected.runs.get("plot")
    return run() if run is not None else Unread(_("Nothing was run for this part."), blank=True)


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """None: figures have theirs drawn elsewhere."""
    return ()
