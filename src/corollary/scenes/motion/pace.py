"""Happenings that come too fast for the end to be reached: seen while they do, and told from bounces that die away."""

from __future__ import annotations

from collections import deque
from statistics import median

MANY = 100
"""So many happenings are held against as many before them."""
SLOWER = 0.9
"""Bounces that die away have lost more than the rest of their speed meanwhile."""


class Pace:
    """The last happenings: when (s) each was, after how many steps, and how fast (m/s) what hits or touches closed then."""

    def __init__(self) -> None:
        self.seen: deque[tuple[float, int, float | None]] = deque(maxlen=2 * MANY + 1)

    def met(self, time: float, steps: int, speed: float | None) -> None:
        """One more; `speed` for hits and touches alone."""
        self.seen.append((time, steps, speed))

    @property
    def lasted(self) -> float:
        """How long (s) the last of them took together."""
        return self.seen[-1][0] - self.seen[-1 - MANY][0]

    def hopeless(self, left: float, steps: int) -> bool:
        """Whether so many steps do not reach an end so far ahead (s) at this pace, and nothing slows down."""
        if len(self.seen) <= 2 * MANY:
            return False
        spent = self.seen[-1][1] - self.seen[-1 - MANY][1]
        if left * spent <= steps * self.lasted:
            return False
        before, now = (self._speed(first, first + MANY) for first in (1, MANY + 1))
        return now >= SLOWER * before

    def _speed(self, first: int, last: int) -> float:
        return median([speed for _, _, speed in list(self.seen)[first:last] if speed is not None] or [0.0])
