"""What Moodle and Canvas give for several numbers: each component earns its share by itself."""

from __future__ import annotations

from collections.abc import Sequence

from corollary.render.lms_item import NumbersAsked


def by_component(asked: NumbersAsked, numbers: Sequence[float]) -> float:
    """The share of the points; of each component the first mark in whose range the number lies counts."""
    earned = 0.0
    for place, number in enumerate(numbers):
        fields = ((*each.ranges()[place], each.share) for each in asked.marks)
        earned += next((share for low, high, share in fields if low <= number <= high), 0.0)
    return earned / len(asked.components)
