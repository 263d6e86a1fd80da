"""From a student to an index in the grid: a keyed digest, no random-number state, the same in ten years."""

from __future__ import annotations

import hashlib
import hmac
from collections.abc import Iterator

from corollary.problem.axes import GridAxis
from corollary.problem.problem import Problem
from corollary.problem.variant import Variant, at, first_broken, index_of, size


def digest(key: bytes, *words: str) -> int:
    """A number of 256 bits that nobody can predict without the key; the words are kept apart by their lengths."""
    message = b"".join(len(word.encode()).to_bytes(4, "big") + word.encode() for word in words)
    return int.from_bytes(hmac.new(key, message, hashlib.sha256).digest(), "big")


def draws(problem: Problem, key: bytes, student: str, *, limit: int = 2000) -> Iterator[Variant]:
    """The variants a student may get, in the order of preference: the first that is free and admissible is dealt.

    Breaks of the problem's own conditions are left out; what only the solution can judge is not.
    """
    total = size(problem)
    for attempt in range(limit):
        variant = at(problem, digest(key, "draw", problem.code, student, str(attempt)) % total)
        if first_broken(variant) is None:
            yield variant


def sample(problem: Problem, count: int, *, salt: str = "sample") -> Iterator[Variant]:
    """Distinct variants spread over the grid, the same every time; all of them where the grid is small."""
    for variant in spread(problem, count, salt=salt):
        if first_broken(variant) is None:
            yield variant
            count -= 1
            if not count:
                return


def sample_of_row(problem: Problem, columns: GridAxis, place: int, count: int) -> Iterator[Variant]:
    """As many points of the grid that have one row of a table, the same every time, those too that break a condition."""
    row = {given.symbol: given.grid[place] for given in columns}
    seen = set[int]()
    for n in range(count):
        drawn = at(problem, digest(b"corollary", "row", problem.code, str(n)) % size(problem))
        index = index_of(problem, values := {**drawn.values, **row})
        if index is not None and index not in seen:
            seen.add(index)
            yield Variant(problem, values, index)


def spread(problem: Problem, count: int, *, salt: str = "sample") -> Iterator[Variant]:
    """Distinct points of the grid, those too that break a condition: all where there are no more than `count`, else many more."""
    total = size(problem)
    seen: set[int] = set()
    indices = (
        range(total)
        if total <= count
        else (digest(b"corollary", salt, problem.code, str(n)) % total for n in range(50 * count))
    )
    for index in indices:
        if index not in seen:
            seen.add(index)
            yield at(problem, index)
