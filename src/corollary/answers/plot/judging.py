"""A figure is judged by what was drawn; its samples are run, not read."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """None: figures have theirs drawn elsewhere."""
    return ()
