"""What was handed in, marked: run, judged, recorded, with feedback for each student; what is unchanged is left alone."""

# pyright: reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

from corollary.atomic import write_whole
from corollary.course.batches import together
from corollary.course.workers import Execute, here
from corollary.grading.solutions import Solutions
from corollary.grading.submission import GradingContext, Submission, state_by_name, state_of
from corollary.nbgrader.from_record import from_record
from corollary.nbgrader.gradebook import gradebook, has_nbgrader
from corollary.nbgrader.graded import GradedSubmission
from corollary.nbgrader.marks import current_manual, stale_pages, synchronized, write_graded
from corollary.nbgrader.register import follow_points, register
from corollary.nbgrader.source import source_notebook
from corollary.problem.problem_set import ProblemSet
from corollary.records.assigned import read_assigned
from corollary.records.causes import dependencies, is_extended, is_handed_in_anew, why
from corollary.records.collusion import find_shared, write_shared
from corollary.records.deadlines import read_deadlines
from corollary.records.files import Course, students
from corollary.records.hand_in_time import GuessedTime, guessed_time, settle_time
from corollary.records.marks import (
    page_facts_place,
    read_marks,
    read_record,
    read_records,
    report_place,
    settle,
    with_out_of,
    write_page,
)
from corollary.records.record import Record, with_manual
from corollary.records.regrading import Change, change, largest_first
from corollary.records.report_model import Report, report_of
from corollary.records.settings import read_settings
from corollary.records.submission import fingerprint, read_submission, submissions, unclear
from corollary.render.report_page import report_page
from corollary.sandbox.runner import Runner

if TYPE_CHECKING:
    from nbgrader.api import Gradebook


class NotGenerated(LookupError):
    """The set was never generated for this course; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a run of grading did. `not_run` are those whose notebook the machine failed to run, with a sentence: nothing is
    recorded for them, and the next run marks them. `records` holds every student's marks, those skipped included; `refilled`
    are those who had marks on record that nbgrader no longer had, `guessed` those of whom no time of handing in is known.
    `changed` are those whose marks are others than before, or would be; when not all of it is `written`, nothing was written of
    `held`. `extended` are the changes that follow from more time given to one student."""

    graded: tuple[str, ...]
    skipped: tuple[str, ...]
    failed: tuple[str, ...]
    strangers: tuple[str, ...]
    records: dict[str, Record]
    in_gradebook: bool
    report: Report
    page: Path
    changed: tuple[Change, ...] = ()
    extended: tuple[Change, ...] = ()
    held: tuple[str, ...] = ()
    written: bool = True
    unclear: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    not_run: Mapping[str, str] = field(default_factory=dict)
    refilled: tuple[str, ...] = ()
    guessed: Mapping[str, GuessedTime] = field(default_factory=dict)


def grade_set(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    runner: Callable[[], Runner],
    *,
    regrade: bool = False,
    dry_run: bool = False,
    ask: Callable[[tuple[Change, ...]], bool] = lambda changed: True,
    progress: Callable[[str, int], None] = lambda student, left: None,
    jobs: int | None = None,
    execute: Execute | None = None,
    begin: Callable[[], None] = lambda: None,
    now: datetime | None = None,
) -> Outcome:
    """Marks every submission that is new or changed. Killed at any moment, the next run finishes the rest.

    Marks already given are moved only when `ask` agrees to the changes, unless the student handed in something else or was
    given more time; a regrade marks everything again, and runs every notebook again but where only points, rubrics or dates have
    changed, and writes all or nothing of it; a dry run writes nothing, and asks nothing.
    `jobs` processes mark side by side (None: as many as there are cores), or whatever `execute` brings; only this one writes.
    `begin` is called before the first notebook is run. `now` (None: this moment) decides what is revealed.
    `progress` gets each student as their marks are written, and how many are left. Raises NotGenerated, NotDerivable, CannotStart,
    WeakIsolation, and what the gradebook refuses (GradebookLocked, GradebookUnusable, NotRegistered, BrokenConfig).
    """
    name = problem_set.name
    assigned = read_assigned(course, problem_set)
    if not assigned:
        raise NotGenerated(
            f"{name} was never generated in {course.folder}; run corollary generate {name} first"
        )
    if not dry_run:
        settle(course, problem_set)
    roster = {student.id: student for student in students(course)}
    files = submissions(course, name)
    strangers = tuple(student for student in files if student not in roster or student not in assigned)
    state = state_of(problem_set, solutions)
    deadlines, moment = read_deadlines(course, problem_set), now or datetime.now(UTC)
    terms = {student: deadlines.terms(student, moment) for student in files}
    by_name = state_by_name(problem_set, solutions)
    if not dry_run:
        for student in files.keys() - set(strangers):
            settle_time(course, name, student, terms[student])
    digests = {
        student: fingerprint(course, name, student, path, assigned[student], state, terms[student])
        for student, path in files.items()
        if student not in strangers
    }
    manual = current_manual(course) if dry_run else synchronized(course)
    done = {
        student: record
        for student, record in read_records(course, problem_set, digests).items()
        if record.fingerprint == digests[student]
    }
    written = _written(course, problem_set, done, dry_run)
    todo = [student for student in digests if regrade or student not in written]

    def submission(one: str) -> Submission:
        about = assigned[one], terms[one]
        depends = dependencies(course, name, one, files[one], *about, by_name)
        read = read_submission(
            course, problem_set, roster[one], files[one], assigned[one], digests[one], terms[one]
        )
        return replace(read, depends=depends)

    given = with_out_of(course, name, manual).by_student(name)

    def standing(one: GradedSubmission) -> Record | None:
        """The marks already given; None as well where the student handed in something else."""
        student, depends = one.marked.student.id, one.submission.depends
        old = read_record(course, problem_set, student)
        if old is None or (not dry_run and is_handed_in_anew(old, depends, one.answers)):
            return None
        return old

    def change_by(one: GradedSubmission, old: Record) -> Change | None:
        """How these would change."""
        student = one.marked.student.id
        by_hand = given.get(student, {})
        found = change(student, with_manual(old, by_hand), with_manual(one.record, by_hand))
        return None if found is None else found.because(why(old, one.submission.depends))

    held: list[GradedSubmission] = []
    found: list[Change] = []
    extended: list[Change] = []
    asked = False
    not_run: dict[str, str] = {}
    changed: tuple[Change, ...] = ()

    def take(several: Sequence[GradedSubmission], book: Gradebook | None) -> None:
        """Writes what may be written at once, and holds the rest."""
        nonlocal asked
        at_once: list[GradedSubmission] = []
        for one in several:
            if one.marked.machine_failed:
                not_run[one.submission.student.id] = one.marked.trouble
                continue
            old, moved = standing(one), None
            if old is not None and (moved := change_by(one, old)) is not None:
                found.append(moved)
                if is_extended(old, one.submission.depends, moved, deadlines):
                    extended.append(moved)
            moves = moved is not None and moved.moves_points and moved not in extended
            asked = asked or moves
            waits = dry_run or moves or (regrade and old is not None)
            (held if waits else at_once).append(one)
        if at_once:
            write_graded(course, problem_set, at_once, given, book)

    left, known = len(todo), set[str]()
    if todo:
        marked_before = (each for each in todo if page_facts_place(course, name, each).exists())
        again = (
            from_record(course, problem_set, solutions, submission(each), only_changed=regrade)
            for each in marked_before
        )
        with _gradebook(course, dry_run) as book:
            for several in together(one for one in again if one is not None):
                take(several, book)
                known |= {one.marked.student.id for one in several}
                left = _counted(progress, several, left)
    to_run = [student for student in todo if student not in known]
    if to_run:
        for problem in problem_set.problems:
            solutions.of(problem)  # once, before there are workers who would each do it
        context = GradingContext(problem_set, solutions, course.key, runner)
        begin()
        with (
            (execute or here(jobs, len(to_run)))(context, map(submission, to_run)) as graded,
            _gradebook(course, dry_run) as book,
        ):
            for several in together(graded):
                take(several, book)
                left = _counted(progress, several, left)
    if todo:
        changed = largest_first(found)
        if not dry_run and (not asked or ask(changed)):
            with _gradebook(course, dry_run) as book:
                for several in together(held):
                    write_graded(course, problem_set, several, given, book)
            held = []
    if not dry_run:
        follow_points(course, problem_set)
    if todo and not dry_run:
        manual = synchronized(course)  # a person may have given some meanwhile
    unwritten = {one.marked.student.id for one in held}
    records = read_marks(course, problem_set, files, manual)
    if not dry_run:
        programs_own = read_records(course, problem_set, files)
        write_shared(course, problem_set, find_shared(problem_set, solutions, assigned, programs_own))
    report = report_of(course, problem_set, manual)
    page = report_place(course, name)
    if not dry_run:
        write_whole(
            page, report_page(report, problem_set, formgrader=read_settings(course.folder).formgrader)
        )
        for student, text in stale_pages(course, name, manual, files).items():
            write_page(course, name, student, text)
    return Outcome(
        graded=tuple(student for student in todo if student not in not_run and student not in unwritten),
        written=not unwritten and not dry_run,
        skipped=tuple(student for student in digests if student not in todo),
        failed=(*not_run, *(one.student for one in report.failed if one.student not in not_run)),
        strangers=strangers,
        records=records,
        in_gradebook=has_nbgrader(),
        report=report,
        page=page,
        changed=changed,
        extended=() if dry_run else tuple(extended),
        held=tuple(student for student in todo if student in unwritten),
        unclear=unclear(course, name),
        not_run=not_run,
        refilled=tuple(student for student in done if student not in written),
        guessed={one: guess for one in digests if (guess := guessed_time(course, name, one)) is not None},
    )


def _counted(progress: Callable[[str, int], None], several: Sequence[GradedSubmission], left: int) -> int:
    for one in several:
        left -= 1
        progress(one.submission.student.id, left)
    return left


def _written(
    course: Course, problem_set: ProblemSet, records: Mapping[str, Record], dry_run: bool
) -> set[str]:
    """Whose marks stand everywhere as they are recorded. A page may have been made by a version that could not make it again,
    nbgrader may have thrown its notebook away, and the gradebook may have been deleted or restored from a backup; one that
    does not know the set is told of it."""
    name = problem_set.name
    there = {
        each
        for each in records
        if page_facts_place(course, name, each).exists()
        and course.notebook("autograded", each, name).exists()
    }
    if not has_nbgrader() or dry_run:
        return there
    from corollary.nbgrader.record import in_gradebook
    from corollary.nbgrader.registered import is_registered

    with gradebook(course) as book:
        known = is_registered(book, problem_set)
        there &= in_gradebook(course, book, problem_set, records) if known else set[str]()
    if not known:
        register(course, problem_set, source_notebook(problem_set))
    return there


def _gradebook(course: Course, dry_run: bool) -> AbstractContextManager[Gradebook | None]:
    """Opened once for all that is written, and after the workers have started: a connection does not survive a fork."""
    return gradebook(course) if has_nbgrader() and not dry_run else nullcontext()
