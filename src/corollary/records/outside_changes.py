"""Scores changed in nbgrader's gradebook after they counted: shown, and asked about before anything moves."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from datetime import UTC, datetime

import msgspec

from corollary.atomic import write_whole
from corollary.records.files import Course
from corollary.records.manual_marks import ManualMark, Place, login_name


class OutsideChange(msgspec.Struct, frozen=True):
    """One part's points as they stand and as the gradebook has them now (None: no score); `mark` is what is recorded if it is
    agreed to, `by` and `at` say who noticed it and when."""

    set: str
    student: str
    part: str
    before: float | None
    after: float | None
    mark: ManualMark
    by: str = ""
    at: str = ""

    @property
    def place(self) -> Place:
        return Place(self.set, self.student, self.part)


def noticed(place: Place, before: float | None, after: float | None, mark: ManualMark) -> OutsideChange:
    """A change that this command met."""
    at = datetime.now(UTC).isoformat(timespec="seconds")
    return OutsideChange(place.set_name, place.student, place.part, before, after, mark, login_name(), at)


def read_outside(course: Course, set_name: str = "") -> dict[Place, OutsideChange]:
    """The changes that wait for an answer, of one set or of all."""
    try:
        found = msgspec.json.decode(
            course.record("manual", "outside.json").read_bytes(), type=list[OutsideChange]
        )
    except (OSError, msgspec.DecodeError):
        return {}
    return {each.place: each for each in found if set_name in ("", each.set)}


def write_outside(course: Course, changes: Mapping[Place, OutsideChange]) -> None:
    """Records them in the place of those before; one that was noticed earlier keeps who noticed it and when."""
    before = read_outside(course)
    if before.keys() == changes.keys() and all(_same(before[one], changes[one]) for one in changes):
        return
    merged = [before[place] if _same(before.get(place), each) else each for place, each in changes.items()]
    with suppress(OSError):
        write_whole(course.record("manual", "outside.json"), msgspec.json.encode(merged))


def settle_outside(course: Course, places: Iterable[Place]) -> None:
    """Takes those out for which a person has given a mark since."""
    waiting, gone = read_outside(course), set(places)
    if gone & waiting.keys():
        write_outside(course, {place: each for place, each in waiting.items() if place not in gone})


def _same(one: OutsideChange | None, other: OutsideChange) -> bool:
    return (
        one is not None
        and (one.before, one.after) == (other.before, other.after)
        and one.mark.equals(other.mark)
    )
