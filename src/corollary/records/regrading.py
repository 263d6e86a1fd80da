"""What a corrected solution changes: whose points, by how much, and in which parts; known before anything is written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

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
    """One student whose marks change: points after lateness, before and after, and every part that differs."""

    student: str
    before: float
    after: float
    parts: tuple[PartChange, ...]

    @property
    def by(self) -> float:
        return self.after - self.before


def changes(records: Mapping[str, Record], new_marked: Iterable[Marked]) -> tuple[Change, ...]:
    """Who had marks and gets others, the largest change first; who is marked for the first time changes nothing."""
    found: list[Change] = []
    for marked in new_marked:
        old = records.get(marked.student.id)
        if old is None:
            continue
        new = record_of(marked, "")
        parts = tuple(_parts(old.parts, new.parts))
        if parts or abs(new.points - old.points) >= CENT:
            found.append(Change(marked.student.id, old.points, new.points, parts))
    return tuple(sorted(found, key=lambda one: (-abs(one.by), one.student)))


def _parts(old: Mapping[str, PartRecord], new: Mapping[str, PartRecord]) -> Iterator[PartChange]:
    """Parts with another verdict or other points."""
    for name in dict.fromkeys((*old, *new)):
        before, after = old.get(name, NOTHING), new.get(name, NOTHING)
        if before.verdict != after.verdict or abs(after.points - before.points) >= CENT:
            yield PartChange(name, before.verdict, after.verdict, before.points, after.points)
