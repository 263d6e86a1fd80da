"""The marks of a course: the newest record of each student, and a history that only grows."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, assert_never

import msgspec

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong, word
from corollary.atomic import write_whole
from corollary.grading.grade import Marked
from corollary.grading.record import marked_record
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course
from corollary.version import __version__


class Row(msgspec.Struct, frozen=True):
    """One part of one student, points before lateness. `verdict` is its word, `error` the mistake or slip, `why` the rest."""

    student: str
    problem: str
    part: str
    verdict: str
    points: float
    out_of: float
    error: str = msgspec.field(default="", name="said")  # in the files of courses by its older name
    why: str = ""


class HandedIn(msgspec.Struct, frozen=True):
    """One submission as a whole: points after lateness; `late` in seconds; `trouble` a sentence, or empty; `notes` tell
    what was noticed."""

    student: str
    name: str
    points: float
    out_of: float
    late: float = 0.0
    late_share: float = 1.0
    trouble: str = ""
    isolation: str = ""
    notes: tuple[str, ...] = ()


class PartRecord(msgspec.Struct, frozen=True):
    """One part as it was marked; a mistake, a slip or a rubric only where the verdict has one."""

    verdict: str
    points: float
    out_of: float
    answer: str = ""
    feedback: str = ""
    mistake: str | msgspec.UnsetType = msgspec.UNSET
    slip: str | msgspec.UnsetType = msgspec.UNSET
    rubric: tuple[str, ...] | msgspec.UnsetType = msgspec.UNSET


class Record(msgspec.Struct, frozen=True):
    """How a student's marks in one set came about: answers, verdicts, variants, isolation, and the fingerprint of all that
    they depend on. Parts go by their name in the notebook (X12_5_a); `late` in seconds."""

    points: float
    out_of: float
    parts: dict[str, PartRecord]
    fingerprint: str
    handed_in: HandedIn
    rows: tuple[Row, ...]
    variants: dict[str, int | None] = {}
    isolation: str = ""
    trouble: str = ""
    late: float = 0.0
    late_share: float = 1.0
    notes: tuple[str, ...] = ()
    version: str = ""


def record_of(marked: Marked, fingerprint: str) -> Record:
    """What is recorded of a submission's marks."""
    about = {"fingerprint": fingerprint, "handed_in": handed_in(marked), "rows": rows(marked)}
    return msgspec.convert(marked_record(marked) | about | {"version": __version__}, Record)


def handed_in(marked: Marked) -> HandedIn:
    """The submission as a whole."""
    return HandedIn(
        marked.student.id,
        marked.student.name,
        marked.points,
        marked.out_of,
        marked.late,
        marked.late_share,
        marked.trouble,
        marked.isolation,
        marked.notes,
    )


def rows(marked: Marked) -> tuple[Row, ...]:
    """One row for each part of one submission."""
    return tuple(
        Row(
            marked.student.id,
            grade.variant.problem.code,
            part.part.id,
            word(part.verdict),
            part.points,
            part.out_of,
            *_reasons(part.verdict),
        )
        for grade in marked.grades
        for part in grade.parts
    )


def _reasons(verdict: Verdict) -> tuple[str, str]:
    """The mistake or slip, and what else there is to know."""
    match verdict:
        case Right(note):
            return "", note
        case Follows(earlier):
            return "", f"from {', '.join(earlier)}"
        case Mistaken(mistake, earlier):
            return mistake, f"from {', '.join(earlier)}" if earlier else ""
        case Slip(slip):
            return slip, ""
        case Wrong(why) | Unread(why) | Unmarked(why):
            return "", why
        case _:
            assert_never(verdict)


def write_marks(
    course: Course, problem_set: ProblemSet, marked: Marked, fingerprint: str, feedback: str
) -> None:
    """The feedback page, the history's line and the record, in this order: the record says that everything before it is done.

    Cut short anywhere, `settle` and a second run leave one page, one line and one record.
    """
    student = marked.student.id
    for place in feedback_places(course, problem_set, student):
        write_whole(place, feedback)
    record = record_of(marked, fingerprint)
    _append(_history(course, problem_set.name), student, record)
    _write_record(course, problem_set, student, record)


def read_record(course: Course, problem_set: ProblemSet, student: str) -> Record | None:
    """The newest record of a student's marks; None when there is none, or it is damaged (then it is marked again)."""
    try:
        return msgspec.json.decode(_place(course, problem_set, student).read_bytes(), type=Record)
    except (OSError, msgspec.DecodeError):
        return None


def read_records(course: Course, problem_set: ProblemSet, students: Iterable[str]) -> dict[str, Record]:
    """The records of those students who have one."""
    found = {student: read_record(course, problem_set, student) for student in students}
    return {student: record for student, record in found.items() if record is not None}


def history(course: Course, set_name: str) -> Iterator[dict[str, Any]]:
    """Every mark ever given in a set, oldest first: a record as plain data, with its `student` and the moment `at`."""
    try:
        lines = _history(course, set_name).read_bytes().splitlines()
    except FileNotFoundError:
        return
    for line in lines:
        try:
            yield msgspec.json.decode(line)
        except msgspec.DecodeError:  # a line that the power cut short: its mark was given again afterwards
            continue


def settle(course: Course, problem_set: ProblemSet) -> None:
    """Completes what a run that was cut short left undone: its last line is in the history, and the record not yet written.

    Everything else of that mark was written before its line, so that it need not be given again.
    """
    line = _last_line(_history(course, problem_set.name))
    try:
        student = str(msgspec.json.decode(line or b"")["student"])
        record = msgspec.json.decode(line or b"", type=Record)
    except (msgspec.DecodeError, KeyError, TypeError):  # none, or cut short: that mark will be given again
        return
    if read_record(course, problem_set, student) != record:
        _write_record(course, problem_set, student, record)


def feedback_places(course: Course, problem_set: ProblemSet, student: str) -> tuple[Path, Path]:
    """Where our own page lies: beside nbgrader's, and beside the marked notebook, from where nbgrader copies it back when it
    makes the feedback folder anew."""
    name = problem_set.name
    feedback, autograded = (
        course.place(step, student, name) / f"{name}.feedback.html" for step in ("feedback", "autograded")
    )
    return feedback, autograded


def _append(path: Path, student: str, record: Record) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    last = _last_line(path)
    about = {"student": student, "at": datetime.now(UTC).isoformat(timespec="seconds")}
    line = msgspec.json.encode(about | msgspec.to_builtins(record))
    # A line that was cut short has no end: the new one must not be glued to it.
    torn = b"" if last is None or last.endswith(b"\n") else b"\n"
    with path.open("ab", buffering=0) as file:
        file.write(torn + line + b"\n")
        os.fsync(file.fileno())


def _last_line(path: Path) -> bytes | None:
    """The last line with its end, read from behind: a history grows long."""
    try:
        with path.open("rb") as file:
            size, block, tail = file.seek(0, os.SEEK_END), 1 << 16, b""
            while size and b"\n" not in tail[:-1]:
                start = max(0, size - block)
                file.seek(start)
                tail, size = file.read(size - start) + tail, start
    except FileNotFoundError:
        return None
    return tail[tail[:-1].rfind(b"\n") + 1 :] or None


def _write_record(course: Course, problem_set: ProblemSet, student: str, record: Record) -> None:
    write_whole(_place(course, problem_set, student), msgspec.json.encode(record))


def _place(course: Course, problem_set: ProblemSet, student: str) -> Path:
    return course.record("graded", f"{problem_set.name}/{student}.json")


def _history(course: Course, set_name: str) -> Path:
    return course.record("history", f"{set_name}.jsonl")
