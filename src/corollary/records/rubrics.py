"""Rubrics of a course: the solution's items, changed while marking, and the marks that a change moves."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path

import msgspec

from corollary.records.files import Course
from corollary.records.manual_marks import RUBRIC, ManualMark, RubricItem, append, entries, login_name
from corollary.records.marks import Record

MOST_ITEMS = 30
LONGEST_ITEM = 1000


class UnusableRubric(ValueError):
    """A rubric that cannot be recorded; one sentence says why."""


class _RubricLine(msgspec.Struct, frozen=True):
    """A line of the journal: the whole rubric of one part from then on."""

    set: str
    part: str
    items: tuple[RubricItem, ...]
    by: str = ""
    at: str = ""


@dataclass(frozen=True, slots=True)
class RubricCount:
    """How often one item was ticked among the marks of a part that were given by a rubric."""

    problem: str
    part: str
    text: str
    students: tuple[str, ...]
    of: int


@dataclass(frozen=True, slots=True)
class RubricMove:
    """One student whose mark follows the changed rubric."""

    student: str
    before: float | None
    after: float | None


def item_id(text: str) -> str:
    """The name of a new item, the same for the same text."""
    return sha256(text.encode()).hexdigest()[:8]


def from_solution(texts: Sequence[str]) -> tuple[RubricItem, ...]:
    """The items that a solution lists, worth the same each."""
    return tuple(RubricItem(item_id(text), text, 1 / len(texts)) for text in texts)


def read_rubrics(course: Course, set_name: str) -> dict[str, tuple[RubricItem, ...]]:
    """The rubrics that were changed while marking, by the part's name in the notebook."""
    found: dict[str, tuple[RubricItem, ...]] = {}
    for entry in entries(_journal(course)):
        try:
            line = msgspec.convert(entry, _RubricLine)
        except msgspec.ValidationError:
            continue
        if line.set == set_name:
            found[line.part] = line.items
    return found


def write_rubric(course: Course, set_name: str, part: str, items: Sequence[RubricItem]) -> None:
    """Records the rubric of one part with who changed it and when. Whoever calls it is the only writer."""
    at = datetime.now(UTC).isoformat(timespec="seconds")
    append(_journal(course), [_RubricLine(set_name, part, tuple(items), login_name(), at)])


def checked_rubric(items: Iterable[RubricItem]) -> tuple[RubricItem, ...]:
    """Raises UnusableRubric."""
    found = tuple(items)
    if len(found) > MOST_ITEMS:
        raise UnusableRubric(f"a rubric has at most {MOST_ITEMS} items")
    if any(not each.text.strip() or len(each.text) > LONGEST_ITEM for each in found):
        raise UnusableRubric(f"every item needs a text of 1 to {LONGEST_ITEM} characters")
    if len({each.id for each in found}) < len(found):
        raise UnusableRubric("two items have the same text")
    if any(not -1 <= each.share <= 1 for each in found):
        raise UnusableRubric("an item is worth at most the points of the part")
    return found


def score_of(ticked: Iterable[RubricItem], out_of: float) -> float:
    """The points of the items that are ticked, from 0 to all."""
    return round(min(out_of, max(0.0, out_of * sum(each.share for each in ticked))), 2)


def is_by_rubric(mark: ManualMark) -> bool:
    """True if the score is the sum of the ticked items; points typed instead stand whatever the rubric says."""
    return (
        mark.rubric is not None
        and mark.score is not None
        and abs(score_of(mark.rubric, mark.out_of) - mark.score) < 0.006
    )


def following(mark: ManualMark, items: Sequence[RubricItem]) -> ManualMark:
    """A mark as it is by a changed rubric: ticks stay with their items, and those of removed items go."""
    if mark.rubric is None:
        return mark
    now = {each.id: each for each in items}
    ticked = tuple(now[each.id] for each in mark.rubric if each.id in now)
    score = score_of(ticked, mark.out_of) if is_by_rubric(mark) else mark.score
    if ticked == mark.rubric and score == mark.score:
        return mark
    return msgspec.structs.replace(mark, rubric=ticked, score=score, at="", by=login_name(), source=RUBRIC)


def rubric_counts(records: Mapping[str, Record]) -> tuple[RubricCount, ...]:
    """Item by item in the order of the parts, from the marks as they stand."""
    ticked: dict[tuple[str, str], dict[str, list[str]]] = {}
    of: dict[tuple[str, str], int] = {}
    for student, record in records.items():
        for row, part in zip(record.rows, record.parts.values(), strict=True):
            mark = part.manual
            if isinstance(mark, ManualMark) and mark.rubric is not None and mark.score is not None:
                place = row.problem, row.part
                of[place] = of.get(place, 0) + 1
                for item in mark.rubric:
                    ticked.setdefault(place, {}).setdefault(item.text, []).append(student)
    return tuple(
        RubricCount(*place, text, tuple(students), of[place])
        for place, items in ticked.items()
        for text, students in sorted(items.items(), key=lambda one: -len(one[1]))
    )


def _journal(course: Course) -> Path:
    return course.record("manual", "rubrics.jsonl")
