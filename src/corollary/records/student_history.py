"""The history of one student's marks: who gave what, when, for which answer, with extensions and requests for regrading."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime

import msgspec

from corollary.records.deadlines import extension_history, read_extensions
from corollary.records.files import Course
from corollary.records.manual_marks import ManualMark, manual_history, read_manual
from corollary.records.marks import Record, graded_sets, history, stored_record, with_manual
from corollary.records.outside_changes import read_outside
from corollary.records.regrade_requests import read_requests
from corollary.records.submissions import read_arrivals

PROGRAM, STUDENT, EXTENSION, COLLECTED, PENDING = "program", "student", "extension", "collected", "pending"


@dataclass(frozen=True, slots=True)
class MarkEvent:
    """One thing that happened: `at` in UTC (ISO, empty: not known), `part` as in the notebook (empty: the whole set), `kind` where it
    is from (program, page, command, file, gradebook, rubric, student, extension, collected, pending), `by` the login name. `answer`
    is the student's, as it was read then; `text` a comment, a reason, a request."""

    at: str
    part: str
    kind: str
    by: str
    what: str
    points: float | None = None
    out_of: float | None = None
    answer: str = ""
    text: str = ""
    rubric: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class SetHistory:
    """What happened in one set, oldest first; points as they stand."""

    set: str
    points: float | None
    out_of: float | None
    events: tuple[MarkEvent, ...]


@dataclass(slots=True)
class _Answers:
    """Answers as they were read, by part and digest."""

    texts: dict[tuple[str, str], str] = field(default_factory=dict[tuple[str, str], str])

    def learn(self, record: Record) -> None:
        for name, part in record.parts.items():
            self.texts[name, record.answers.get(name, "")] = part.answer

    def of(self, part: str, digest: str) -> str:
        return self.texts.get((part, digest), "")


def student_history(course: Course, student: str, set_name: str = "") -> list[SetHistory]:
    """Set by set, or of one set alone. Raises NotACourse."""
    names = {
        *graded_sets(course),
        *(each.set for each in extension_history(course) if each.student == student),
    }
    return [_of_set(course, student, name) for name in sorted(names) if set_name in ("", name)]


def _of_set(course: Course, student: str, name: str) -> SetHistory:
    answers = _Answers()
    events = [
        *_by_program(course, student, name, answers),
        *_by_hand(course, student, name, answers),
        *_extensions(course, student, name),
        *_requests(course, student, name),
        *_collected(course, student, name),
    ]
    record = stored_record(course, name, student)
    now = (
        None if record is None else with_manual(record, read_manual(course).by_student(name).get(student, {}))
    )
    in_order = sorted(events, key=lambda one: one.at)
    waiting = tuple(_pending(course, student, name))
    points, out_of = (None, None) if now is None else (now.points, now.out_of)
    return SetHistory(name, points, out_of, (*in_order, *waiting))


def _by_program(course: Course, student: str, name: str, answers: _Answers) -> Iterator[MarkEvent]:
    """What each run of grading changed; nothing of one that gave the same marks."""
    before: Record | None = None
    for line in history(course, name):
        if line.get("student") != student:
            continue
        try:
            record = msgspec.convert(line, Record)
        except msgspec.ValidationError:
            continue
        answers.learn(record)
        at = str(line.get("at", ""))
        for part, now in record.parts.items():
            old = None if before is None else before.parts.get(part)
            same_answer = before is not None and before.answers.get(part) == record.answers.get(part)
            if (
                old is not None
                and same_answer
                and (old.verdict, old.points, old.out_of) == (now.verdict, now.points, now.out_of)
            ):
                continue
            points = None if now.verdict == "unmarked" else now.points
            version = f"version {record.version}" if record.version else ""
            yield MarkEvent(at, part, PROGRAM, "", now.verdict, points, now.out_of, now.answer, version)
        if record.late_share < 1 and (before is None or before.late_share != record.late_share):
            what = f"late, {record.late_share:.0%} of the points are kept"
            yield MarkEvent(at, "", PROGRAM, "", what, record.points, record.out_of)
        before = record


def _by_hand(course: Course, student: str, name: str, answers: _Answers) -> Iterator[MarkEvent]:
    for place, mark in manual_history(course):
        if (place.set_name, place.student) != (name, student):
            continue
        yield MarkEvent(
            mark.at,
            place.part,
            mark.source or "by hand",
            mark.by,
            _words(mark),
            mark.score,
            mark.out_of or None,
            answers.of(place.part, mark.answer),
            mark.comment or "",
            tuple(item.text for item in mark.rubric or ()),
        )


def _words(mark: ManualMark) -> str:
    if not mark.is_given:
        return "mark taken back"
    extra = f", {mark.extra_credit:g} as extra credit" if mark.extra_credit else ""
    if mark.request is not None:
        return (
            "request answered: mark changed" if mark.request.changed else "request answered: mark stands"
        ) + extra
    return ("mark by hand" if mark.score is not None else "comment") + extra


def _extensions(course: Course, student: str, name: str) -> Iterator[MarkEvent]:
    noted = False
    for each in extension_history(course):
        if (each.set, each.student) == (name, student):
            noted = True
            until = "" if each.until is None else f"until {each.until.isoformat(timespec='minutes')}"
            what = "taken back" if each.removed else "excused" if each.excused else until
            yield MarkEvent(each.at, "", EXTENSION, each.by, f"extension: {what}")
    own = read_extensions(course, name).get(student)
    if own is not None and not noted:
        until = "" if own.until is None else own.until.isoformat(timespec="minutes")
        yield MarkEvent(
            "", "", EXTENSION, "", "extension: excused" if own.excused else f"extension: until {until}"
        )


def _requests(course: Course, student: str, name: str) -> Iterator[MarkEvent]:
    for each in read_requests(course, name).get(student, ()):
        state = "request for regrading" if each.decided else "request for regrading, open"
        yield MarkEvent(_in_utc(each.at), each.part, STUDENT, student, state, text=each.text)


def _collected(course: Course, student: str, name: str) -> Iterator[MarkEvent]:
    for each in read_arrivals(course, name):
        if each.student == student:
            yield MarkEvent(
                _in_utc(each.when), "", COLLECTED, "", f"{each.file}: {each.outcome}", text=each.why
            )


def _pending(course: Course, student: str, name: str) -> Iterator[MarkEvent]:
    for place, each in read_outside(course, name).items():
        if place.student == student:
            what = "changed in the gradebook, not agreed to"
            yield MarkEvent(
                each.at, place.part, PENDING, each.by, what, each.after, text=each.mark.comment or ""
            )


def _in_utc(text: str) -> str:
    """A moment of any of our files as ISO in UTC; empty where it is none."""
    try:
        found = datetime.fromisoformat(text.replace(" UTC", "+00:00").strip())
    except ValueError:
        return ""
    moment = found if found.tzinfo is not None else found.replace(tzinfo=UTC)
    return moment.astimezone(UTC).isoformat(timespec="seconds")


def history_record(histories: list[SetHistory], student: str, names: Mapping[str, str]) -> dict[str, object]:
    """The same as plain data."""
    return {
        "student": student,
        "name": names.get(student, student),
        "sets": [msgspec.to_builtins(each) for each in histories],
    }
