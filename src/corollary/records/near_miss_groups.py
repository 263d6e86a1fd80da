"""Answers laid out for a person to mark, and near misses of reading, grouped."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from hashlib import sha256

from corollary.records.manual_marks import ManualMark, RubricItem
from corollary.records.marks import Row
from corollary.records.outside_changes import OutsideChange
from corollary.records.regrade_requests import RegradeRequest

NUMBER = re.compile(r"\d+(?:[.,]\d+)*")
LONGEST = 120


@dataclass(frozen=True, slots=True)
class NearMissOf:
    """One student's answer as typed, how it would be read to be right, and the points that are at stake, before lateness."""

    student: str
    typed: str
    read: str
    points: float


@dataclass(frozen=True, slots=True)
class NearMisses:
    """Answers to one part that one other reading makes right. `text` is what they have in common: with `…` in the place of each
    number, for everybody has other numbers."""

    problem: str
    part: str
    kind: str
    text: str
    answers: tuple[NearMissOf, ...]

    @property
    def id(self) -> str:
        """A short name, the same in every run; what `corollary mark --accept` takes."""
        return group_id(self.problem, self.part, self.kind, self.text)

    @property
    def students(self) -> tuple[str, ...]:
        return tuple(each.student for each in self.answers)


def near_misses(rows: Iterable[Row]) -> tuple[NearMisses, ...]:
    """The groups, the largest first; nothing on which a person has decided."""
    found: dict[tuple[str, str, str, str], list[NearMissOf]] = {}
    for row in rows:
        if (near := row.near_miss) is not None:
            place = row.problem, row.part, near.kind, in_common(near.text)
            found.setdefault(place, []).append(NearMissOf(row.student, near.text, near.read, row.out_of))
    groups = (NearMisses(*place, tuple(answers)) for place, answers in found.items())
    return tuple(sorted(groups, key=lambda one: -len(one.answers)))


def near_misses_record(group: NearMisses) -> dict[str, object]:
    """A group as plain data."""
    return {"id": group.id, **asdict(group), "students": list(group.students)}


def in_common(text: str) -> str:
    """The text without its numbers and the size of its blanks."""
    return " ".join(NUMBER.sub("…", text).split())[:LONGEST]


def group_id(problem: str, part: str, kind: str, text: str) -> str:
    """Eight letters and digits."""
    return sha256("\n".join((problem, part, kind, text)).encode()).hexdigest()[:8]


@dataclass(frozen=True, slots=True)
class WrittenCell:
    """What a student wrote in one cell, harmless for a page and `verbatim`, and the pictures in it or below it as data URIs."""

    source: str
    verbatim: str
    is_code: bool
    pictures: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class AnswerGroup:
    """Equal answers to one part, marked together: `late` counts those that came late. `given` is what a person gave all of
    them, `again` says that it was for another answer. `near_miss` are answers, not all equal, that one other reading makes right.
    `outside` is a score changed in the gradebook that nobody has agreed to, `request` a student's request for regrading; `points`
    are those that stand, `seen` names for each student what the marker sees."""

    students: tuple[str, ...]
    cells: tuple[WrittenCell, ...]
    late: int
    why: str
    given: ManualMark | None
    again: bool
    near_miss: NearMisses | None = None
    outside: OutsideChange | None = None
    request: RegradeRequest | None = None
    points: float | None = None
    seen: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class PartToMark:
    """One part with its answers; `key` is its name in the notebook, `items` the rubric with what each item is worth."""

    key: str
    problem: str
    part: str
    title: str
    out_of: float
    items: tuple[RubricItem, ...]
    groups: tuple[AnswerGroup, ...]

    @property
    def rubric(self) -> tuple[str, ...]:
        """The texts of the items."""
        return tuple(item.text for item in self.items)
