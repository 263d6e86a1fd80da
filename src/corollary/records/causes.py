"""Why marks change: what they depend on, by name, recorded with them and compared when they are given again."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path

from corollary.records.assigned import AssignedSheet
from corollary.records.deadlines import Deadlines, Terms
from corollary.records.files import Course
from corollary.records.hand_in_time import handed_in, moment
from corollary.records.record import Record
from corollary.records.regrading import Change
from corollary.sandbox.file import bytes_of

HAND_IN, DEADLINE = "what was handed in", "the deadline"


def dependencies(
    course: Course,
    set_name: str,
    student: str,
    path: Path,
    assigned: AssignedSheet,
    terms: Terms,
    state: Mapping[str, bytes],
) -> dict[str, str]:
    """What one student's marks depend on: a short digest of each, under the name that people read. `state` is what they share
    with everybody's."""
    content = bytes_of(path, within=course.folder / "submitted")
    file = content if isinstance(content, bytes) else content.why.encode()
    found = {
        HAND_IN: file + str(handed_in(course, set_name, student)).encode(),
        DEADLINE: repr((terms.due and terms.due.isoformat(), terms.excused)).encode(),
        "the numbers": assigned.identity.encode(),
        **state,
    }
    return {name: hashlib.sha256(each).hexdigest()[:12] for name, each in found.items()}


def is_handed_in_anew(
    course: Course, set_name: str, student: str, old: Record, depends: Mapping[str, str]
) -> bool:
    """Whether the student handed in something else since the marks were given; the records of earlier versions do not say, but
    nbgrader has the moment of what was marked."""
    if old.depends:
        return old.depends.get(HAND_IN) != depends.get(HAND_IN)
    stamp = course.place("autograded", student, set_name) / "timestamp.txt"
    try:
        return moment(stamp.read_text(encoding="utf-8")) != handed_in(course, set_name, student)
    except (OSError, ValueError, LookupError):
        return False


def is_extended(old: Record, depends: Mapping[str, str], change: Change, deadlines: Deadlines) -> bool:
    """Whether a student's marks change by nothing but more time that this student was given, or an excuse: whoever gave it has
    agreed to that. Time that is taken back takes marks, and is asked about."""
    lateness_alone = not change.parts and change.out_of == change.out_of_before and change.by > 0
    return lateness_alone and change.student in deadlines.extensions and _changed(old, depends) == [DEADLINE]


def why(old: Record, depends: Mapping[str, str]) -> str:
    """A few words on why marks are others than before."""
    if not old.depends:
        return "they were given by an earlier version, which did not record what they depend on"
    names = _changed(old, depends)
    return (
        f"changed: {', '.join(names)}"
        if names
        else "nothing was changed; the notebook ran otherwise than before"
    )


def _changed(old: Record, depends: Mapping[str, str]) -> list[str]:
    return [name for name in {**old.depends, **depends} if old.depends.get(name) != depends.get(name)]
