"""A count judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth
from corollary.answers.value.judging import judge

__all__ = ["judge", "samples"]


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """The whole number, with its noun and as a double; one too many; a little too much; words that are none."""
    assert not isinstance(truth, str)
    count = round(truth[0])
    return (
        Sample(str(count), "right"),
        Sample(f"{count} bounces", "right"),
        Sample(float(count), "right"),
        Sample(str(count + 1), "wrong"),
        Sample(f"{count}.3", "wrong"),
        Sample("rather a lot", "unread"),
        Sample(None, "unread"),
    )
