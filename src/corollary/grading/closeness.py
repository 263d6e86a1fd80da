"""Whether numbers are close enough: against the length of the answer, or because they were written with few figures."""

from __future__ import annotations

import math
from collections.abc import Sequence


def within(values: Sequence[float], target: Sequence[float], tolerance: float, scale: float) -> bool:
    """Whether the distance of two vectors (or numbers) is within the tolerance of the scale."""
    if len(values) != len(target) or not all(map(math.isfinite, values)):
        return False
    return math.dist(values, target) <= tolerance * scale


def same_signs(values: Sequence[float], target: Sequence[float], doubt: Sequence[float]) -> bool:
    """Whether every component points the right way, but for those that are within doubt of nought."""
    return all(x * y >= 0 or abs(y) <= small for x, y, small in zip(values, target, doubt, strict=True))


def coarse(
    values: Sequence[float],
    figures: Sequence[int],
    target: Sequence[float],
    sizes: Sequence[float],
    near: Sequence[float],
) -> int:
    """The fewest figures written, when the target rounded to the figures written gives just these values; else 0.

    `sizes` are the SI values of the units in which the numbers were written, for figures are counted there. A component that
    is `near` the target (in SI) has figures enough.
    """
    few = []
    for value, count, wanted, size, enough in zip(values, figures, target, sizes, near, strict=True):
        if abs(value - wanted) <= enough:
            continue
        if value == 0 or not count:
            return 0
        unit = 10.0 ** (math.floor(math.log10(abs(value / size)) + 1e-12) - count + 1) * size
        if abs(value - wanted) > 0.5 * unit * (1 + 1e-9):
            return 0
        few.append(count)
    return min(few or figures)
