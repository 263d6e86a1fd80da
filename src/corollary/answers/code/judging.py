"""A program is judged by what its function returns; its samples are run, not read."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """None: programs have theirs run elsewhere."""
    return ()
