"""An example judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` is one good example."""
    assert not isinstance(truth, str)
    scale = max(map(abs, truth)) or 1.0
    return (
        Sample(list(truth), "right"),
        Sample([value + 0.31 * scale for value in truth], "wrong"),
        Sample(list(truth)[:-1], "unread"),
        Sample("any", "unread"),
        Sample([None] * len(truth), "unread"),
    )
