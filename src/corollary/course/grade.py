"""What was handed in, marked: run, judged, recorded, with feedback for each student; what is unchanged is left alone."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Any

from corollary.course.submission import GradedSubmission, GradingContext, Submission
from corollary.course.workers import Execute, here
from corollary.grading.solutions import Solutions
from corollary.nbgrader.gradebook import gradebook
from corollary.problem.problem_set import ProblemSet
from corollary.records.collusion import sharing
from corollary.records.course import Course, read_dealt, students, submissions, unclear, write_atomically
from corollary.records.records import fingerprint, keep, keep_sharing, lateness, read_record, settle
from corollary.records.regrading import Change, changes
from corollary.records.report_kept import report_of
from corollary.records.report_model import Report
from corollary.render.report_page import report_page
from corollary.sandbox.file import bytes_of
from corollary.sandbox.runner import Runner

if TYPE_CHECKING:
    from nbgrader.api import Gradebook


class NotDealt(LookupError):
    """The set was never generated for this course; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a run of grading did. `records` holds every student's marks, those skipped included."""

    graded: tuple[str, ...]
    skipped: tuple[str, ...]
    failed: tuple[str, ...]
    strangers: tuple[str, ...]
    records: dict[str, dict[str, Any]]
    in_gradebook: bool
    report: Report
    page: Path
    changed: tuple[Change, ...] = ()
    unclear: Mapping[str, tuple[str, ...]] = field(default_factory=dict)


def grade_set(
    course: Course, problem_set: ProblemSet, solutions: Solutions, runner: Callable[[], Runner], *,
    regrade: bool = False, dry_run: bool = False, show: Callable[[tuple[Change, ...]], None] = lambda changed: None,
    tell: Callable[[str, int], None] = lambda student, left: None, jobs: int | None = None, execute: Execute | None = None,
) -> Outcome:  # fmt: skip
    """Marks every submission that is new or changed. Killed at any moment, the next run finishes the rest.

    A regrade marks everything first and shows who changes before anything is written; a dry run writes nothing at all.
    `jobs` processes mark side by side (None: as many as there are cores), or whatever `execute` brings; only this one writes.
    `tell` gets each student as their marks are written, and how many are left. Raises NotDealt, NotDerivable, CannotStart,
    WeakIsolation, and what the gradebook refuses (GradebookLocked, NotRegistered).
    """
    dealt = read_dealt(course, problem_set.name)
    if not dry_run:
        settle(course, problem_set)
    if not dealt:
        raise NotDealt(
            f"{problem_set.name} was never generated in {course.folder}; run corollary generate {problem_set.name} first"
        )
    roster = {student.id: student for student in students(course)}
    papers = submissions(course, problem_set.name)
    strangers = tuple(student for student in papers if student not in roster or student not in dealt)
    todo: dict[str, str] = {}
    skipped = []
    held: list[GradedSubmission] = []
    changed: tuple[Change, ...] = ()
    for student, path in papers.items():
        if student in strangers:
            continue
        mark_of = fingerprint(course, problem_set, solutions, student, path, dealt[student])
        if not regrade and _done(course, problem_set, student, mark_of):
            skipped.append(student)
        else:
            todo[student] = mark_of
    handed = (
        Submission(
            roster[student],
            bytes_of(papers[student]),
            dealt[student],
            lateness(course, problem_set, student),
            mark_of,
        )
        for student, mark_of in todo.items()
    )
    if todo:
        for problem in problem_set.problems:
            solutions.of(problem)  # once, before there are workers who would each do it
        order = GradingContext(problem_set, solutions, course.key, runner, has_nbgrader())
        with (execute or here(jobs, len(todo)))(order, handed) as marked, _gradebook(course) as book:
            for place, one in enumerate(marked, start=1):
                if regrade or dry_run:
                    held.append(one)
                else:
                    _write(course, problem_set, solutions, one, book)
                tell(one.handed.student.id, len(todo) - place)
            changed = changes(_records(course, problem_set, todo), (one.marked for one in held))
            if regrade or dry_run:
                show(changed)
            for one in held if not dry_run else ():
                _write(course, problem_set, solutions, one, book)
    records = _records(course, problem_set, papers)
    if not dry_run:
        keep_sharing(course, problem_set, sharing(problem_set, solutions, dealt, records))
    found = report_of(course, problem_set)
    page = course.folder / "reports" / f"{problem_set.name}.html"
    if not dry_run:
        write_atomically(page, report_page(found, problem_set))
    failed = tuple(one.student for one in found.failed)
    return Outcome(
        tuple(todo),
        tuple(skipped),
        failed,
        strangers,
        records,
        has_nbgrader(),
        found,
        page,
        changed,
        unclear(course, problem_set.name),
    )


def _done(course: Course, problem_set: ProblemSet, student: str, fingerprint: str) -> bool:
    """Whether these marks are all written; nbgrader may have thrown its notebook away after they were."""
    kept = read_record(course, problem_set, student)
    there = not has_nbgrader() or course.notebook("autograded", student, problem_set.name).exists()
    return there and kept is not None and kept.get("fingerprint") == fingerprint


def _records(course: Course, problem_set: ProblemSet, of: Iterable[str]) -> dict[str, dict[str, Any]]:
    """What is kept of these students' marks, for those of whom anything is."""
    return {
        student: kept for student in of if (kept := read_record(course, problem_set, student)) is not None
    }


def _gradebook(course: Course) -> AbstractContextManager[Gradebook | None]:
    """Opened once for all, and after the workers have started: nbgrader takes its time."""
    return gradebook(course) if has_nbgrader() else nullcontext()


def _write(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    one: GradedSubmission,
    book: Gradebook | None,
) -> None:
    """One submission into the gradebook and the files; its record is written last, so that a run cut short does it again."""
    if book is not None:
        from corollary.nbgrader.record import record_one

        record_one(course, book, problem_set, one.marked, one.notebook)
    keep(course, problem_set, solutions, one.marked, one.handed.fingerprint, one.page)


def has_nbgrader() -> bool:
    return find_spec("nbgrader") is not None
