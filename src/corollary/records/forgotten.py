"""Log of students whose data was taken out of a course; it names them by a digest with the course's key."""

from __future__ import annotations

import hashlib
import hmac
from collections.abc import Iterable, Mapping
from datetime import UTC, datetime
from pathlib import Path

from corollary.records.files import Course
from corollary.records.manual_marks import append, entries, login_name


def note_forgotten(course: Course, student: str, what: str, counts: Mapping[str, int]) -> None:
    """Adds a line: that taking out was `begun` or is `done`. Only somebody with the key and the id finds the student in it."""
    at = datetime.now(UTC).isoformat(timespec="seconds")
    append(_log(course), [{"person": _digest(course, student), what: at, "by": login_name(), **counts}])


def forgotten(course: Course, students: Iterable[str]) -> list[str]:
    """Those of these ids that were taken out of the course."""
    persons = {entry.get("person") for entry in entries(_log(course))}
    return [each for each in students if _digest(course, each) in persons] if persons else []


def _log(course: Course) -> Path:
    return course.record("forgotten", "log.jsonl")


def _digest(course: Course, student: str) -> str:
    return hmac.new(course.key, f"forgotten {student}".encode(), hashlib.sha256).hexdigest()[:32]
