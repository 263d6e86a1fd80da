"""Deadlines of each student: the set's date, extensions and excuses, and what may be revealed by now."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

import msgspec

from corollary.atomic import write_whole
from corollary.problem.dates import Reveal
from corollary.problem.late_penalty import LateSteps
from corollary.problem.problem_set import ProblemSet
from corollary.records.assignments import printed_dates
from corollary.records.files import Course, NotACourse
from corollary.records.manual_marks import append, entries, login_name


class Extension(msgspec.Struct, frozen=True):
    """What one student has of their own in one set: another date, or an excuse."""

    until: datetime | None = None
    excused: bool = False


class ExtensionEntry(msgspec.Struct, frozen=True):
    """A line of the journal of extensions: what was given, or that it was taken back; by whom and when."""

    set: str
    student: str
    until: datetime | None = None
    excused: bool = False
    removed: bool = False
    by: str = ""
    at: str = ""


@dataclass(frozen=True, slots=True)
class Terms:
    """What holds for one student in one set: `due` is the own deadline, `reveal` whether right values may be seen by now, and
    `rubric` whether by what answers in words are marked may."""

    due: datetime | None = None
    excused: bool = False
    reveal: bool = False
    rubric: bool = False


@dataclass(frozen=True, slots=True)
class Deadlines:
    """The dates of a set in a course. `by_hand`: its solutions were revealed by hand; `printed`: what students' sheets say,
    which were handed out before a date was changed."""

    due: datetime | None
    reveal: Reveal
    extensions: Mapping[str, Extension]
    by_hand: bool = False
    rubric: bool = False
    printed: Mapping[str, datetime] = field(default_factory=dict[str, datetime])
    late_steps: LateSteps | None = None

    def of(self, student: str) -> datetime | None:
        """A student's own deadline: an extension never shortens what everybody has, and nobody is late before the moment
        that their own sheet prints."""
        given = self.given(student)
        return None if given is None else _later(given, self.printed.get(student))

    def given(self, student: str) -> datetime | None:
        """What the set and an extension give a student, whatever the sheet prints."""
        return None if self.due is None else _later(self.due, self.extensions.get(student, Extension()).until)

    @property
    def by_sheet(self) -> tuple[str, ...]:
        """Those whose sheet prints a later moment than they are given."""
        return tuple(student for student in self.printed if self.of(student) != self.given(student))

    @property
    def last(self) -> datetime | None:
        """The last student's deadline; an excuse has none."""
        own = (
            each
            for student in {*self.extensions, *self.printed}
            if not self.excused(student) and (each := self.of(student))
        )
        return None if self.due is None else max((self.due, *own), key=datetime.timestamp)

    def terms(self, student: str, now: datetime) -> Terms:
        """What holds for a student at a moment."""
        due, excused = self.of(student), self.excused(student)
        own, everybody = self._closes(due), self._closes(self.last)
        until = {"no": None, "by hand": None, "after due": own, "after extensions": everybody}[self.reveal]
        revealed = self.reveal in {"after due", "after extensions"} and (until is None or now > until)
        over = everybody if self.reveal == "after extensions" else own
        rubric = self.rubric and (over is None or now > over)
        return Terms(due, excused, revealed or (self.reveal == "by hand" and self.by_hand), rubric)

    def _closes(self, due: datetime | None) -> datetime | None:
        """When what was handed in could still earn all of its points, or with a last day anything, is over."""
        return due if due is None or self.late_steps is None else self.late_steps.closes(due)

    def excused(self, student: str) -> bool:
        return self.extensions.get(student, Extension()).excused

    def early(self, student: str, now: datetime) -> bool:
        """Whether a student may still hand in."""
        due = self.of(student)
        return due is not None and now <= due and not self.excused(student)


def read_deadlines(course: Course, problem_set: ProblemSet) -> Deadlines:
    """The dates of a set as they are now. Raises NotACourse when the record of an extension, or of what was assigned, is
    damaged."""
    name = problem_set.name
    own = read_extensions(course, name)
    by_hand, printed = _revealed(course, name).exists(), printed_dates(course, problem_set)
    return Deadlines(
        problem_set.due, problem_set.reveal, own, by_hand, problem_set.rubric, printed, problem_set.late_steps
    )


def read_extensions(course: Course, set_name: str) -> dict[str, Extension]:
    """Who has an extension, or is excused. Raises NotACourse when a record is damaged."""
    return {path.stem: _read(path) for path in sorted(_folder(course, set_name).glob("[!.]*.json"))}


def write_extension(course: Course, set_name: str, student: str, extension: Extension) -> None:
    """Records it: one file a student, so that two who give extensions at once lose none."""
    write_whole(_place(course, set_name, student), msgspec.json.encode(extension) + b"\n")
    _note(course, set_name, student, extension, removed=False)


def remove_extension(course: Course, set_name: str, student: str) -> bool:
    """Takes it back; False when there was none."""
    path = _place(course, set_name, student)
    there = path.exists()
    path.unlink(missing_ok=True)
    if there:
        _note(course, set_name, student, Extension(), removed=True)
    return there


def extension_history(course: Course) -> Iterator[ExtensionEntry]:
    """Every extension and excuse that was ever given or taken back, oldest first."""
    for entry in entries(course.record("extensions", "journal.jsonl")):
        with suppress(msgspec.ValidationError):
            yield msgspec.convert(entry, ExtensionEntry)


def _note(course: Course, set_name: str, student: str, extension: Extension, *, removed: bool) -> None:
    at = datetime.now(UTC).isoformat(timespec="seconds")
    until, excused = extension.until, extension.excused
    line = ExtensionEntry(set_name, student, until, excused, removed, login_name(), at)
    append(course.record("extensions", "journal.jsonl"), [line])


def all_extensions(course: Course) -> dict[str, dict[str, Extension]]:
    """Everybody who has an extension or is excused, by set. Raises NotACourse when a record is damaged."""
    places = sorted(course.record("extensions", "").glob("*/"))
    return {place.name: own for place in places if (own := read_extensions(course, place.name))}


def reveal_by_hand(course: Course, set_name: str) -> None:
    """Records that the solutions of a set may be seen from now on."""
    write_whole(_revealed(course, set_name), "")


def _later(one: datetime, other: datetime | None) -> datetime:
    """In the zone of the first; compared as moments, for a clock may show a time twice."""
    return one if other is None or other <= one.astimezone(UTC) else other.astimezone(one.tzinfo)


def _read(path: Path) -> Extension:
    try:
        found = msgspec.json.decode(path.read_bytes(), type=Extension)
    except (OSError, msgspec.DecodeError) as error:
        raise NotACourse(
            f"{path} is damaged ({error}); delete it and give the extension again with corollary extend"
        ) from None
    if found.until is not None and found.until.tzinfo is None:
        return Extension(found.until.replace(tzinfo=UTC), found.excused)
    return found


def _folder(course: Course, set_name: str) -> Path:
    return course.record("extensions", set_name)


def _place(course: Course, set_name: str, student: str) -> Path:
    return _folder(course, set_name) / f"{student}.json"


def _revealed(course: Course, set_name: str) -> Path:
    return course.record("revealed", set_name)
