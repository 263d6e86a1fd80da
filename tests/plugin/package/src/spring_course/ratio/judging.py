"""A ratio judged by its value, however it was written."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.value.judging import judge as judge


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """Two numbers, larger ones, a quotient; the wrong way round; words."""
    assert not isinstance(truth, str)
    (value,) = truth
    return (
        Sample(f"{value!r} : 1", "right"),
        Sample(f"{3 * value!r} to 3", "right"),
        Sample(value, "right"),
        Sample(f"1 : {2.7 * value!r}", "wrong"),
        Sample("more : less", "unread"),
        Sample(None, "unread"),
    )
