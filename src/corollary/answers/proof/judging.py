"""A proof judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """`truth` holds a right chain, one equation a line."""
    assert isinstance(truth, str)
    lines = truth.splitlines()
    return (
        Sample(lines, "right"),
        Sample(["1 = 1", lines[-1]], "wrong"),
        Sample([*lines[:-1], "0 = 1"], "wrong"),
        Sample(["so it is"], "unread"),
        Sample(4, "unread"),
        Sample(None, "unread"),
    )
