"""An interval judged by its two ends, in whichever order they were given."""

from __future__ import annotations

from corollary.answers.answer import Answer
from corollary.answers.expected import Expected
from corollary.answers.in_any_order import judge_in_any_order
from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth, to_be_typed
from corollary.answers.verdict import Verdict


def judge(answer: Answer, expected: Expected) -> Verdict:
    """Both ends together, the smaller first: whether they belong to it is not asked."""
    assert expected.quantity is not None
    return judge_in_any_order(answer, expected.quantity, expected.question)


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """Both ends in words, in brackets, the other way round; too wide an interval; one number."""
    assert not isinstance(truth, str)
    ends, unit = to_be_typed(truth, question)
    low, high = sorted(ends)
    wide = low - 0.4 * ((high - low) or 1.0)
    return (
        Sample(f"{low!r}{unit} to {high!r}{unit}", "right"),
        Sample(f"between {high!r}{unit} and {low!r}{unit}", "right"),
        Sample(f"{low!r}{unit} < x < {high!r}{unit}", "right"),
        Sample(f"[{low!r}; {high!r}]{unit}", "right"),
        Sample([f"{low!r}{unit}", f"{high!r}{unit}"], "right"),
        Sample(f"{wide!r}{unit} to {high!r}{unit}", "wrong"),
        Sample(f"{low!r}{unit}", "unread"),
        Sample(None, "unread"),
    )
