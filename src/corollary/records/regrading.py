"""What a corrected solution changes: whose points, by how much, in which parts, and why; known before anything is written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from corollary.grading.grade import Marked
from corollary.records.record import PartRecord, Record, record_of

CENT = 0.005  # half of the last decimal that anybody sees
NOTHING = PartRecord("", 0.0, 0.0)  # a part that was not there before, or is no longer


@dataclass(frozen=True, slots=True)
class PartChange:
    """One part, named as in the notebook (X12_5_a), before and after."""

    part: str
    verdict_before: str
    verdict: str
    before: float
    after: float


@dataclass(frozen=True, slots=True)
class Change:
    """One student whose marks change: points after lateness, before and after, every part that differs, and why."""

    student: str
    before: float
    after: float
    parts: tuple[PartChange, ...]
    why: str = ""

    @property
    def by(self) -> float:
        return self.after - self.before

    @property
    def moves_points(self) -> bool:
        """Whether any points move; else a part is only called otherwise."""
        return abs(self.by) >= CENT or any(abs(part.after - part.before) >= CENT for part in self.parts)

    def because(self, why: str) -> Change:
        return replace(self, why=why)


def change(student: str, old: Record, new: Record) -> Change | None:
    """What is otherwise in the new marks of one student; None when nothing is."""
    parts = tuple(_parts(old.parts, new.parts))
    if not parts and abs(new.points - old.points) < CENT:
        return None
    return Change(student, old.points, new.points, parts)


def changes(records: Mapping[str, Record], new_marked: Iterable[Marked]) -> tuple[Change, ...]:
    """Who had marks and gets others, the largest change first; who is marked for the first time changes nothing."""
    found = (
        change(marked.student.id, records[marked.student.id], record_of(marked, ""))
        for marked in new_marked
        if marked.student.id in records
    )
    return largest_first(each for each in found if each is not None)


def largest_first(found: Iterable[Change]) -> tuple[Change, ...]:
    """The order in which people read them."""
    return tuple(sorted(found, key=lambda one: (-abs(one.by), one.student)))


def _parts(old: Mapping[str, PartRecord], new: Mapping[str, PartRecord]) -> Iterator[PartChange]:
    """Parts with another verdict or other points."""
    for name in dict.fromkeys((*old, *new)):
        before, after = old.get(name, NOTHING), new.get(name, NOTHING)
        if before.verdict != after.verdict or abs(after.points - before.points) >= CENT:
            yield PartChange(name, before.verdict, after.verdict, before.points, after.points)
