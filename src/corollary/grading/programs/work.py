"""Limits of comparing the figures of one part: beyond them nothing is concluded, and a person looks."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from contextvars import ContextVar

MOST_COMPARED = (
    1_000_000  # places: a few thousand are enough for a usual figure, and forty of them remain far below
)


class TooMuchCompared(Exception):
    """More was drawn than is compared for one part."""


class Work:
    """Counts the places of drawn curves that are compared, up to `most`."""

    def __init__(self, most: int) -> None:
        self.most, self.compared = most, 0

    def add(self, places: int) -> None:
        """Raises TooMuchCompared where these are beyond the limit."""
        self.compared += places
        if self.compared > self.most:
            raise TooMuchCompared(f"{self.compared} places")


_of_part: ContextVar[Work | None] = ContextVar("_of_part", default=None)


@contextmanager
def limited(most: int = MOST_COMPARED) -> Generator[Work]:
    """All comparisons within count together."""
    work = Work(most)
    token = _of_part.set(work)
    try:
        yield work
    finally:
        _of_part.reset(token)


def count(places: int) -> None:
    """So many places are about to be compared; raises TooMuchCompared where that is beyond the limit."""
    work = _of_part.get()
    if work is not None:
        work.add(places)
