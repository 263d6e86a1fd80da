"""A choice judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth


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
