"""Marked submissions in the groups that are written at once."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from time import monotonic
from typing import Final

from corollary.nbgrader.graded import GradedSubmission

TOGETHER: Final = 16
"""Submissions that are written in one transaction."""
LONGEST_UNWRITTEN: Final = 2.0
"""Seconds after which those that are marked are written with the next one, however few."""


def together(graded: Iterable[GradedSubmission]) -> Iterator[list[GradedSubmission]]:
    """Submissions in groups that are written at once: a transaction and a disk that is waited for cost as much for one."""
    several: list[GradedSubmission] = []
    since = monotonic()
    for one in graded:
        several.append(one)
        if len(several) >= TOGETHER or monotonic() - since > LONGEST_UNWRITTEN:
            yield several
            several, since = [], monotonic()
    if several:
        yield several
