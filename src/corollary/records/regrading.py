"""What a corrected solution changes: whose points, by how much, in which parts, and why; known before anything is written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

import msgspec

from corollary.records.record import PartRecord, Record

CENT = 0.005  # half of the last decimal that anybody sees
NOTHING = PartRecord("", 0.0, 0.0)  # a part that was not there before, or is no longer


@dataclass(frozen=True, slots=True)
class PartChange:
    """One part, named as in the notebook (X12_5_a), before and after: its verdict, its points, and what these are out of;
    `by_hand`: a person gave the points, and no verdict is the program's."""

    part: str
    verdict_before: str
    verdict: str
    before: float
    after: float
    out_of_before: float
    out_of: float
    by_hand: bool = False


@dataclass(frozen=True, slots=True)
class Change:
    """One student whose marks change: points after lateness and what they are out of, before and after, every part that
    differs, and why."""

    student: str
    before: float
    after: float
    out_of_before: float
    out_of: float
    parts: tuple[PartChange, ...]
    why: str = ""

    @property
    def by(self) -> float:
        return self.after - self.before

    @property
    def moves_points(self) -> bool:
        """Whether any points move, or what they are out of; else a part is only called otherwise."""
        return (
            _differ(self.after, self.before)
            or _differ(self.out_of, self.out_of_before)
            or any(
                _differ(part.after, part.before) or _differ(part.out_of, part.out_of_before)
                for part in self.parts
            )
        )

    def because(self, why: str) -> Change:
        return replace(self, why=why)


def change(student: str, old: Record, new: Record) -> Change | None:
    """What is otherwise in the new marks of one student; None when nothing is."""
    parts = tuple(_parts(old.parts, new.parts))
    if not (parts or _differ(new.points, old.points) or _differ(new.out_of, old.out_of)):
        return None
    return Change(student, old.points, new.points, old.out_of, new.out_of, parts)


def largest_first(found: Iterable[Change]) -> tuple[Change, ...]:
    """The order in which people read them."""
    return tuple(sorted(found, key=lambda one: (-abs(one.by), one.student)))


def _parts(old: Mapping[str, PartRecord], new: Mapping[str, PartRecord]) -> Iterator[PartChange]:
    """Parts with another verdict, other points, or out of others."""
    for name in dict.fromkeys((*old, *new)):
        before, after = old.get(name, NOTHING), new.get(name, NOTHING)
        points = before.points, after.points, before.out_of, after.out_of
        by_hand = all(_is_by_hand(each) for each in (before, after) if each is not NOTHING)
        called_otherwise = before.verdict != after.verdict and not by_hand
        if called_otherwise or _differ(*points[:2]) or _differ(*points[2:]):
            yield PartChange(name, before.verdict, after.verdict, *points, by_hand)


def _is_by_hand(part: PartRecord) -> bool:
    return part.manual is not msgspec.UNSET and part.manual.score is not None


def _differ(one: float, other: float) -> bool:
    return abs(one - other) >= CENT
