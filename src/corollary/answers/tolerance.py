"""Tolerance of numbers: by their distance, by the signs of their components, or as far as their figures tell."""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.answers.answer import Numbers

ROUNDING_NOISE = 1e-9  # of the scale: what is left where large doubles cancel
NEAR = 0.1  # of the tolerance: a component so near the target is not rounded too far
SAME_VALUE = 0.05  # relative: two sides of an equation, each rounded for itself, often to one figure
EDGE = 1e-12  # of the scale: the doubles of a number that lies exactly on the edge of a tolerance are off by less
ENOUGH = 3  # figures that a book asks for


def within(
    values: Sequence[float], target: Sequence[float], tolerance: float, scale: float, residue: float = 0.0
) -> bool:
    """True if the distance of two vectors (or numbers) is at most the tolerance of the scale, or the `residue` (absolute).

    The edge itself is inside, on both sides, whatever the doubles make of it.
    """
    if len(values) != len(target) or not all(map(math.isfinite, values)):
        return False
    return math.dist(values, target) <= max((tolerance + EDGE) * scale, residue)


def same_value(value: float, reference: float, residue: float = 0.0) -> bool:
    """True if two sides of an equation are one value, each rounded for itself; the share is of the reference."""
    return within((value,), (reference,), SAME_VALUE, abs(reference), residue)


def same_signs(values: Sequence[float], target: Sequence[float], uncertain: Sequence[float]) -> bool:
    """Whether every component points the right way, but for those that are within what is uncertain of zero."""
    return all(x * y >= 0 or abs(y) <= small for x, y, small in zip(values, target, uncertain, strict=True))


def coarse(
    values: Sequence[float],
    figures: Sequence[int],
    target: Sequence[float],
    sizes: Sequence[float],
    near: Sequence[float],
    zeros: Sequence[float] = (),
) -> int:
    """The fewest figures written, when the target rounded to the figures written gives just these values; else 0.

    `sizes` are the SI values of the units in which the numbers were written, `zeros` (absolute, none: 0) where these begin, for
    figures are counted there: 293 K are 20 °C in whole kelvins. A component that is `near` the target (in SI) has figures enough.
    """
    few: list[int] = []
    several = zip(values, figures, target, sizes, near, zeros or (0.0,) * len(values), strict=True)
    for value, count, wanted, size, enough, zero in several:
        if abs(value - wanted) <= enough:
            continue
        written = value - zero
        if written == 0 or not count:
            return 0
        place = last_place(written, count, size)
        if abs(value - wanted) > 0.5 * place * (1 + 1e-9):
            return 0
        # 290 K in two figures are 20 °C to ten degrees: one figure, if any
        few.append(count if count >= ENOUGH or not zero or abs(value) >= 10 * place else 1)
    return min(few or figures)


def coarse_polar(
    values: Sequence[float], polar: tuple[Numbers, Numbers], target: Sequence[float], size: float, near: float
) -> int:
    """The same for a length and an angle: the figures of each bound just that. `near` is relative to the length.

    `4.8 N at 12.45°` may be off in its length as 4.8 may, in its direction only by half a hundredth of a degree.
    """
    (x, y), (u, v) = values, target
    (turn,), (count,), (angle_size,) = polar[1].values, polar[1].figures, polar[1].sizes
    length, wanted = math.hypot(x, y), math.hypot(u, v)
    turned = math.atan2(x * v - y * u, x * u + y * v)  # from the answer to the target
    few = coarse(
        (length, turn),
        (polar[0].figures[0], count),
        (wanted, turn + turned),
        (size, angle_size),
        (near * wanted, near),
    )
    if not few or not turn or not count or abs(turned) <= near:
        return few
    # whole degrees are two figures of a radian, be they written as 30° or as 150°
    return min(few, math.ceil(-math.log10(last_place(turn, count, angle_size))))


def last_place(value: float, figures: int, size: float) -> float:
    """What one in the last figure written is worth, in SI."""
    return 10.0 ** (math.floor(math.log10(abs(value / size)) + 1e-12) - figures + 1) * size
