"""One quantity judged, and samples of answers whose verdict is known beforehand."""

from __future__ import annotations

from corollary.answers.question import Question
from corollary.answers.sample import Sample, Truth, unit_name


def samples(truth: Truth, question: Question) -> tuple[Sample, ...]:
    """The number itself, four figures of it, with a decimal comma; a number far off; text that is none."""
    assert not isinstance(truth, str)
    value, unit = truth[0], unit_name(question)
    comma = f"{value:.4e}".replace(".", ",")
    off = value * 1.37 + (7 if value == 0 else 0)
    return (
        Sample(f"{value!r}{unit}", "right"),
        Sample(f"{value:.4g}{unit}" if value else f"0{unit}", "right"),
        Sample(f"{comma}{unit}", "right"),
        Sample(f"{off!r}{unit}", "wrong"),
        Sample("about five", "unread"),
        Sample(float("nan"), "unread"),
        Sample(None, "unread"),
        Sample([1.0, 2.0, 3.0, 4.0], "unread"),
        Sample(f"{value!r} kg*m^5", "wrong"),
    )
