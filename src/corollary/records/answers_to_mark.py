"""Answers laid out for a person to mark, part by part; those that are equal are one."""

from __future__ import annotations

from dataclasses import dataclass

from corollary.records.manual import ManualMark
from corollary.records.near_misses import NearMisses


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
    them, `again` says that it was for another answer. `near_miss` are answers, not all equal, that one other reading makes right."""

    students: tuple[str, ...]
    cells: tuple[WrittenCell, ...]
    late: int
    why: str
    given: ManualMark | None
    again: bool
    near_miss: NearMisses | None = None


@dataclass(frozen=True, slots=True)
class PartToMark:
    """One part with its answers; `key` is its name in the notebook."""

    key: str
    problem: str
    part: str
    title: str
    out_of: float
    rubric: tuple[str, ...]
    groups: tuple[AnswerGroup, ...]
