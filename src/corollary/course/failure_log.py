"""This program's own failures over single students' work: collected in a run, and logged in the course with their tracebacks."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import TypeVar

from corollary.atomic import open_to_append
from corollary.guard import Failure, guarded
from corollary.records.files import Course
from corollary.records.submissions import writable

T = TypeVar("T")

LONGEST = 30.0
"""Seconds of the processor for one step of one student's in the process that writes: all that runs or judges is elsewhere."""


@dataclass(slots=True)
class FailureLog:
    """The failures of a run over one set, by student."""

    course: Course
    set_name: str
    found: dict[str, list[Failure]] = field(default_factory=dict[str, list[Failure]])

    @property
    def place(self) -> Path:
        """The file with the tracebacks."""
        return self.course.record("failures", f"{self.set_name}.log")

    @property
    def by_student(self) -> dict[str, str]:
        """What failed, in a few words."""
        return {student: several[-1].what for student, several in self.found.items()}

    def add(self, student: str, failures: Sequence[Failure]) -> None:
        """Remembers failures over one student's work; one that was met twice is one."""
        known = self.found.setdefault(student, []) if failures else []
        known += [each for each in failures if each not in known]

    def guarded(
        self, student: str, work: Callable[[], T], passing: tuple[type[Exception], ...] = ()
    ) -> T | None:
        """What the work on one student's input returns; None where it failed, which is remembered."""
        done = guarded(work, LONGEST, passing)
        if isinstance(done, Failure):
            self.add(student, [done])
            return None
        return done

    def write(self) -> None:
        """Appends them to the course's file, which nobody but its owner and a team can read: a message may quote an answer."""
        if not self.found:
            return
        now = f"{datetime.now(UTC):%Y-%m-%d %H:%M:%S} UTC"
        text = "".join(_entries(now, self.found))
        with open(open_to_append(self.place, 0o600), "a", encoding="utf-8") as file:
            file.write(text)


def _entries(now: str, found: Mapping[str, Sequence[Failure]]) -> list[str]:
    return [
        writable(f"{now} {student}: {each.what}\n{each.trace}\n")
        for student, several in found.items()
        for each in several
    ]
