"""An explanation waits for a person; samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """Words wait for a person; none is blank."""
    return (Sample("Because.", "unmarked"), Sample(None, "unread"))
