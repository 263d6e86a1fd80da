"""Reading a sampled motion between its samples: where a value passes a level, and how long it stays beyond."""

from __future__ import annotations

from collections.abc import Sequence


def crossings(times: Sequence[float], values: Sequence[float], level: float = 0.0) -> list[float]:
    """The times (s) at which the straight lines between samples pass the level, upward or downward.

    Counting samples instead would be wrong by up to a step at each end; this is wrong by a share of a step squared.
    """
    found = []
    for t0, t1, a, b in zip(times, times[1:], values, values[1:], strict=False):
        if (a - level) * (b - level) < 0.0 or (a != level and b == level):
            found.append(t0 + (t1 - t0) * (level - a) / (b - a))
    return found


def time_beyond(times: Sequence[float], values: Sequence[float], level: float = 0.0) -> float:
    """How long (s) the straight lines between samples stay below the level, in all."""
    total = 0.0
    for t0, t1, a, b in zip(times, times[1:], values, values[1:], strict=False):
        below_a, below_b = a < level, b < level
        if below_a and below_b:
            total += t1 - t0
        elif below_a or below_b:
            inside, outside = (a, b) if below_a else (b, a)
            total += (t1 - t0) * (level - inside) / (outside - inside)
    return total
