"""Students over whose work this program failed when it was last marked, with the reason of each."""

from __future__ import annotations

from collections.abc import Collection, Mapping

import msgspec

from corollary.atomic import write_whole
from corollary.records.files import Course


def read_failures(course: Course, set_name: str) -> dict[str, str]:
    """What failed, in a few words, by student; nothing where nothing did."""
    try:
        found = course.record("failures", f"{set_name}.json").read_bytes()
        return msgspec.json.decode(found, type=dict[str, str])
    except (OSError, msgspec.DecodeError):  # none, or damaged: found again when it is marked again
        return {}


def write_failures(course: Course, set_name: str, found: Mapping[str, str], stay: Collection[str]) -> None:
    """Records what failed now; of what failed before, that of who was not marked again stays."""
    before = read_failures(course, set_name)
    now = {student: what for student, what in before.items() if student in stay} | dict(found)
    if now != before:
        text = msgspec.json.encode(
            {student: what.encode("utf-8", "replace").decode() for student, what in now.items()}
        )
        write_whole(course.record("failures", f"{set_name}.json"), text)
