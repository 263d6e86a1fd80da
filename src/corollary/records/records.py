"""What is kept of every mark: the newest record of each student, and a history that only grows."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from corollary import __version__
from corollary.grading.grade import Marked
from corollary.grading.record import marked_record
from corollary.grading.solutions import Solutions
from corollary.problem.problem_set import ProblemSet
from corollary.records.course import Course, handed_in, write_atomically
from corollary.records.report import handed_in as row_of
from corollary.records.report import rows
from corollary.records.report_model import Shared
from corollary.render.feedback_page import feedback_page
from corollary.sandbox.file import content_of

Record = dict[str, Any]


def keep(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    marked: Marked,
    fingerprint: str,
    page: str | None = None,
) -> None:
    """The feedback page, the history's line and the record, in this order: the record says that everything before it is done.

    Cut short anywhere, `settle` and a second run leave one page, one line and one record. `page` is the feedback page where it
    is made already.
    """
    if page is None:
        shown = marked.grades if problem_set.reveal else ()
        stories = {grade.variant.problem.code: solutions.story(grade.variant) for grade in shown}
        page = feedback_page(marked, problem_set, solutions=stories)
    student = marked.student.id
    for place in feedback_places(course, problem_set, student):
        write_atomically(place, page)
    entry = record_of(marked, fingerprint)
    _remember(course, problem_set, student, entry)
    _write_record(course, problem_set, student, entry)


def record_of(marked: Marked, fingerprint: str) -> Record:
    """How a mark came about: answers, verdicts, variants, isolation, and what it depended on (the fingerprint)."""
    return marked_record(marked) | {
        "fingerprint": fingerprint, "handed_in": asdict(row_of(marked)), "rows": [asdict(each) for each in rows(marked)],
        "version": __version__,
    }  # fmt: skip


def read_record(course: Course, problem_set: ProblemSet, student: str) -> Record | None:
    """What was kept of a student's marks; None when nothing was, or what was there is damaged (then it is marked again)."""
    try:
        entry = json.loads(_record_path(course, problem_set, student).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return (
        entry
        if isinstance(entry, dict) and {"fingerprint", "rows", "handed_in", "parts"} <= entry.keys()
        else None
    )


def history(course: Course, set_name: str) -> Iterator[Record]:
    """Every mark ever given in a set, oldest first, each with its `student` and the moment `at`."""
    try:
        lines = _history_path(course, set_name).read_bytes().splitlines()
    except FileNotFoundError:
        return
    for line in lines:
        try:
            yield json.loads(line)
        except ValueError:  # a line that the power cut short: its mark was given again afterwards
            continue


def settle(course: Course, problem_set: ProblemSet) -> None:
    """Completes what a run that was cut short left undone: its last line is in the history, and the record not yet written.

    Everything else of that mark was written before its line, so that it need not be given again.
    """
    try:
        entry = json.loads(_last_line(_history_path(course, problem_set.name)) or b"null")
    except ValueError:  # cut short within the line: that mark will be given again
        return
    if isinstance(entry, dict) and isinstance(student := entry.pop("student", None), str):
        entry.pop("at", None)
        if read_record(course, problem_set, student) != entry:
            _write_record(course, problem_set, student, entry)


def feedback_places(course: Course, problem_set: ProblemSet, student: str) -> tuple[Path, Path]:
    """Where our own page lies: beside nbgrader's, and beside the marked notebook, from where nbgrader copies it back when it
    makes the feedback folder anew."""
    name = problem_set.name
    feedback, autograded = (
        course.place(step, student, name) / f"{name}.feedback.html" for step in ("feedback", "autograded")
    )
    return feedback, autograded


def lateness(course: Course, problem_set: ProblemSet, student: str) -> float:
    """Seconds after the date on which it was due; 0 in time."""
    when = handed_in(course, problem_set.name, student)
    if when is None or problem_set.due is None:
        return 0.0
    return max(0.0, (when - problem_set.due).total_seconds())


def fingerprint(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    student: str,
    path: Path,
    row: Mapping[str, int],
) -> str:
    """What the marks depend on: the paper, its moment, the numbers, the problems and solutions, the scheme, and this program."""
    digest = hashlib.sha256()

    def add(content: bytes) -> None:
        digest.update(len(content).to_bytes(8, "big") + content)

    add(content_of(path))
    add(str(handed_in(course, problem_set.name, student)).encode())
    add(json.dumps(dict(row), sort_keys=True).encode())
    add(
        repr(
            (problem_set.scheme, problem_set.due, problem_set.weights, problem_set.reveal, __version__)
        ).encode()
    )
    for problem in problem_set.problems:
        add(problem.path.read_bytes())
        add(solutions.source(problem))
    return digest.hexdigest()


def keep_sharing(course: Course, problem_set: ProblemSet, shared: Iterable[Shared]) -> None:
    """What was found at the last grading, beside the records."""
    text = json.dumps([asdict(one) for one in shared], ensure_ascii=False)
    write_atomically(course.folder / ".corollary" / "sharing" / f"{problem_set.name}.json", text)


def kept_sharing(course: Course, problem_set: ProblemSet) -> tuple[Shared, ...]:
    """Empty when nothing was found, or nothing graded yet."""
    try:
        found = json.loads(
            (course.folder / ".corollary" / "sharing" / f"{problem_set.name}.json").read_text(
                encoding="utf-8"
            )
        )
        return tuple(Shared(**one | {"parts": tuple(one["parts"])}) for one in found)
    except (OSError, ValueError, TypeError, KeyError):  # none, or damaged: found again at the next grading
        return ()


def _remember(course: Course, problem_set: ProblemSet, student: str, entry: Record) -> None:
    path = _history_path(course, problem_set.name)
    path.parent.mkdir(parents=True, exist_ok=True)
    last = _last_line(path)
    moment = datetime.now(UTC).isoformat(timespec="seconds")
    line = json.dumps({"student": student, "at": moment, **entry}, ensure_ascii=False)
    # A line that was cut short has no end: the new one must not be glued to it.
    torn = b"" if last is None or last.endswith(b"\n") else b"\n"
    with path.open("ab", buffering=0) as file:
        file.write(torn + line.encode() + b"\n")
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


def _write_record(course: Course, problem_set: ProblemSet, student: str, entry: Record) -> None:
    write_atomically(_record_path(course, problem_set, student), json.dumps(entry, ensure_ascii=False))


def _record_path(course: Course, problem_set: ProblemSet, student: str) -> Path:
    return course.folder / ".corollary" / "graded" / problem_set.name / f"{student}.json"


def _history_path(course: Course, set_name: str) -> Path:
    return course.folder / ".corollary" / "history" / f"{set_name}.jsonl"
