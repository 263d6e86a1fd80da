"""Manual scores, extra credit and comments that persons gave, in a journal of JSON lines that only grows."""

from __future__ import annotations

import getpass
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import msgspec

from corollary.atomic import open_to_append
from corollary.records.files import Course


def append(path: Path, entries: Iterable[object]) -> None:
    """Adds a line for each entry, and returns when they are on the disk."""
    lines = [msgspec.json.encode(entry) + b"\n" for entry in entries]
    if not lines:
        return
    last = last_lines(path, 1)
    # A line that was cut short has no end: the new one must not be glued to it.
    torn = b"" if not last or last[-1].endswith(b"\n") else b"\n"
    with open(open_to_append(path), "ab", buffering=0) as file:
        file.write(torn + b"".join(lines))
        os.fsync(file.fileno())


def entries(path: Path) -> Iterator[dict[str, Any]]:
    """Every entry, oldest first, as plain data; a line that was cut short is none."""
    try:
        lines = path.read_bytes().splitlines()
    except FileNotFoundError:
        return
    for line in lines:
        try:
            entry = msgspec.json.decode(line)
        except msgspec.DecodeError:
            continue
        if isinstance(entry, dict):
            yield entry


def last_lines(path: Path, most: int) -> list[bytes]:
    """The last lines with their ends, oldest first, read from behind: a journal grows long. None where there is no file."""
    try:
        with path.open("rb") as file:
            size, block, tail = file.seek(0, os.SEEK_END), 1 << 16, b""
            while size and tail[:-1].count(b"\n") < most:
                start = max(0, size - block)
                file.seek(start)
                tail, size = file.read(size - start) + tail, start
    except FileNotFoundError:
        return []
    return tail.splitlines(keepends=True)[-most:]


PAGE, COMMAND, FILE, GRADEBOOK, RUBRIC = (
    "page",
    "command",
    "file",
    "gradebook",
    "rubric",
)  # where a mark is from


class RubricItem(msgspec.Struct, frozen=True):
    """One item of a rubric: `share` of the part's points is added (negative: taken off) where it is ticked."""

    id: str
    text: str
    share: float


class RequestDecision(msgspec.Struct, frozen=True):
    """The answer to a request for regrading: the student's words, and whether the mark was changed or stands."""

    text: str
    changed: bool


class ManualMark(msgspec.Struct, frozen=True, omit_defaults=True):
    """What a person gave for one part; None where they gave nothing. `answer` is the digest of the answer it was given for
    (empty: not known), `by` the login name where it is known, `at` the moment it was recorded. `out_of` is what the score is
    out of (0: not known), `first` the score and what it was out of when the part earned other points than now. `rubric` are the
    items that were ticked (None: it was not marked by a rubric), `source` says where the mark was given."""

    score: float | None = None
    extra_credit: float | None = None
    comment: str | None = None
    answer: str = ""
    by: str = ""
    at: str = ""
    out_of: float = 0.0
    first: tuple[float, float] | None = None
    rubric: tuple[RubricItem, ...] | None = None
    source: str = ""
    request: RequestDecision | None = None

    @property
    def is_given(self) -> bool:
        """Whether there is anything in it; a mark that was withdrawn has nothing."""
        return self.score is not None or bool(self.extra_credit) or bool(self.comment)

    def out_of_now(self, out_of: float) -> ManualMark:
        """The mark where the part earns `out_of` points: the share that a person gave stands, extra credit as it is."""
        if self.score is None or not self.out_of or not out_of or abs(self.out_of - out_of) < 1e-9:
            return self
        score, most = self.first or (self.score, self.out_of)
        if abs(most - out_of) < 1e-9:
            return msgspec.structs.replace(self, score=score, out_of=most, first=None)
        scaled = round(score * out_of / most, 6)
        return msgspec.structs.replace(self, score=scaled, out_of=out_of, first=(score, most))

    def equals(self, other: ManualMark) -> bool:
        """Whether both say the same to the student."""
        return (self.score, self.extra_credit or 0.0, self.comment or "") == (
            other.score,
            other.extra_credit or 0.0,
            other.comment or "",
        )


NOTHING = ManualMark()


def login_name() -> str:
    """The login name of whoever runs the command; empty where the system has none."""
    try:
        return getpass.getuser()
    except (OSError, KeyError, ImportError):
        return ""


OfStudent = Mapping[str, ManualMark]  # by the part's name in the notebook (X12_5_a)


@dataclass(frozen=True, slots=True, order=True)
class Place:
    """Where a mark belongs; `part` is its name in the notebook."""

    set_name: str
    student: str
    part: str


class _Line(msgspec.Struct, frozen=True, omit_defaults=True):
    """A line of the journal."""

    set: str
    student: str
    part: str
    mark: ManualMark


@dataclass(frozen=True, slots=True)
class ManualMarks:
    """Everything that persons gave in a course, withdrawn marks included; `count` says how many entries that took."""

    by_place: Mapping[Place, ManualMark]
    count: int

    def by_student(self, set_name: str) -> dict[str, dict[str, ManualMark]]:
        """The marks in one set, by student and part; those that were withdrawn have nothing in them."""
        found: dict[str, dict[str, ManualMark]] = {}
        for place, mark in self.by_place.items():
            if place.set_name == set_name:
                found.setdefault(place.student, {})[place.part] = mark
        return found

    def and_then(self, given: Mapping[Place, ManualMark]) -> ManualMarks:
        """These, followed by newer ones."""
        return ManualMarks({**self.by_place, **given}, self.count + len(given))


def read_manual(course: Course) -> ManualMarks:
    """What the journal holds."""
    found: dict[Place, ManualMark] = {}
    count = 0
    for place, mark in manual_history(course):
        found[place] = mark
        count += 1
    return ManualMarks(found, count)


def manual_history(course: Course) -> Iterator[tuple[Place, ManualMark]]:
    """Every mark that a person ever gave, oldest first."""
    for entry in entries(journal_place(course)):
        try:
            line = msgspec.convert(entry, _Line)
        except msgspec.ValidationError:
            continue
        yield Place(line.set, line.student, line.part), line.mark


def write_manual(course: Course, given: Mapping[Place, ManualMark]) -> None:
    """Adds marks to the journal, each with its moment."""
    at = datetime.now(UTC).isoformat(timespec="seconds")
    lines: Iterable[_Line] = (
        _Line(place.set_name, place.student, place.part, msgspec.structs.replace(mark, at=mark.at or at))
        for place, mark in given.items()
    )
    append(journal_place(course), lines)


def journal_place(course: Course) -> Path:
    """Where the journal lies, once anything was given by hand."""
    return course.record("manual", "marks.jsonl")
