"""One writer to a course: a second grading run is told so at once, and a lock never outlives the process that held it."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager

from corollary.records.course import Course


class BeingGraded(Exception):
    """Another run is writing in this course; one sentence says what to do."""


@contextmanager
def one_writer(course: Course) -> Iterator[None]:
    """Held while marks are written. Raises BeingGraded. The system gives the lock back when its holder ends, however it ends."""
    place = os.open(course.folder / ".corollary", os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    try:
        fcntl.flock(place, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(place)
        raise BeingGraded(
            f"another run is grading in {course.folder}; wait until it is done, then run this again"
        ) from None
    try:
        yield
    finally:
        os.close(place)
