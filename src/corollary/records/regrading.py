"""What a corrected solution changes: whose points, by how much, and in which parts; known before anything is written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from corollary.grading.grade import Marked
from corollary.grading.record import marked_record

CENT = 0.005


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


def changes(old_records: Mapping[str, Mapping[str, Any]], new_marked: Iterable[Marked]) -> tuple[Change, ...]:
    """Who had marks and gets others, the largest change first; who is marked for the first time changes nothing."""
    found = []
    for marked in new_marked:
        old = old_records.get(marked.student.id)
        if old is None:
            continue
        new = marked_record(marked)
        parts = tuple(_parts(old["parts"], new["parts"]))
        if parts or abs(new["points"] - old["points"]) >= CENT:
            found.append(Change(marked.student.id, old["points"], new["points"], parts))
    return tuple(sorted(found, key=lambda one: (-abs(one.by), one.student)))


def _parts(old: Mapping[str, Any], new: Mapping[str, Any]) -> Iterator[PartChange]:
    """Parts with another verdict or other points; a part that was not there before had none."""
    nothing = {"verdict": "", "points": 0.0}
    for name in dict.fromkeys((*old, *new)):
        before, after = old.get(name, nothing), new.get(name, nothing)
        if before["verdict"] != after["verdict"] or abs(after["points"] - before["points"]) >= CENT:
            yield PartChange(name, before["verdict"], after["verdict"], before["points"], after["points"])
