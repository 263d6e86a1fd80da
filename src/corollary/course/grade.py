"""Marking submissions: run, judged, recorded, with feedback for each student; unchanged ones are left, and marks that would move held back."""

# pyright: reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from functools import partial
from itertools import count
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Final

from corollary.atomic import write_whole
from corollary.course.failure_log import LONGEST, FailureLog
from corollary.course.workers import Execute, here
from corollary.grading.solutions import Solutions
from corollary.grading.submission import GradingContext, Submission, state_by_name, state_of
from corollary.guard import Failure, guarded
from corollary.nbgrader.from_record import from_record
from corollary.nbgrader.gradebook import concerns_everybody, gradebook, has_nbgrader
from corollary.nbgrader.graded import GradedSubmission, not_graded
from corollary.nbgrader.hand_marking import take_outside
from corollary.nbgrader.register import follow_points, register, source_notebook
from corollary.nbgrader.written_marks import current_manual, stale_pages, synchronized, write_graded
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.records.assignments import AssignedSheet, read_assigned
from corollary.records.collusion import find_shared, write_shared
from corollary.records.deadlines import Deadlines, Terms, read_deadlines
from corollary.records.files import Course, students
from corollary.records.manual_marks import ManualMarks, OfStudent
from corollary.records.marks import (
    Record,
    packages_now,
    page_facts_place,
    read_marks,
    read_record,
    read_records,
    report_place,
    settle,
    with_manual,
    write_page,
)
from corollary.records.outside_changes import OutsideChange, read_outside
from corollary.records.regrade_requests import gather_requests
from corollary.records.regrading import (
    Change,
    change,
    dependencies,
    is_completed,
    is_extended,
    is_handed_in_anew,
    largest_first,
    why,
)
from corollary.records.report_model import Report, report_of
from corollary.records.settings import read_settings
from corollary.records.submissions import (
    GuessedTime,
    fingerprint,
    guessed_time,
    read_submission,
    settle_time,
    submissions,
    unclear,
    write_failures,
)
from corollary.render.report_page import report_page
from corollary.sandbox.runner import Runner

if TYPE_CHECKING:
    from nbgrader.api import Gradebook

TOGETHER: Final = 16
"""Submissions that are written in one transaction."""
LONGEST_UNWRITTEN: Final = 2.0
"""Seconds after which those that are marked are written with the next one, however few."""


def together(graded: Iterable[GradedSubmission]) -> Iterator[list[GradedSubmission]]:
    """Submissions in groups that are written at once: a transaction and a disk that is waited for cost as much for one."""
    several: list[GradedSubmission] = []
    since = monotonic()
    for one in graded:
        several.append(one)
        if len(several) >= TOGETHER or monotonic() - since > LONGEST_UNWRITTEN:
            yield several
            several, since = [], monotonic()
    if several:
        yield several


@dataclass(slots=True)
class ProposedMarks:
    """The marks of a run of grading. `by_hand` is what persons gave, by student; a regrade is written whole or not at all, a dry
    run never. `not_run` says why the machine failed to run somebody's notebook; `extended` are the changes that follow from
    more time given to one student; `moves_marks` says that others are moved, too, which nobody has agreed to yet. What cannot be
    written of somebody is among the `failures`, and written as `unmarked`: without anything of what was handed in."""

    course: Course
    problem_set: ProblemSet
    deadlines: Deadlines
    by_hand: Mapping[str, OfStudent]
    regrade: bool
    dry_run: bool
    failures: FailureLog
    unmarked: Callable[[Submission], GradedSubmission]
    not_run: dict[str, str] = field(default_factory=dict[str, str])
    extended: list[Change] = field(default_factory=list[Change])
    moves_marks: bool = False
    _changes: list[Change] = field(default_factory=list[Change])
    _held: list[GradedSubmission] = field(default_factory=list[GradedSubmission])

    @property
    def changed(self) -> tuple[Change, ...]:
        """Whose marks are others than before, the largest change first."""
        return largest_first(self._changes)

    @property
    def held_students(self) -> frozenset[str]:
        """Those of whom nothing is written."""
        return frozenset(one.marked.student.id for one in self._held)

    def take(self, several: Sequence[GradedSubmission], book: Gradebook | None) -> None:
        """Writes what may be written at once, and holds the rest."""
        at_once: list[GradedSubmission] = []
        for one in several:
            student = one.submission.student.id
            self.failures.add(student, one.failures)
            if one.marked.machine_failed:
                self.not_run[student] = one.marked.trouble
                continue
            waits = self.failures.guarded(student, partial(self._has_to_wait, one))
            (at_once if waits is False else self._held).append(one)
        self._write(at_once, book)

    def write_held(self, book: Gradebook | None) -> None:
        """What was held, once it is agreed to."""
        for several in together(self._held):
            self._write(several, book)
        self._held.clear()

    def _write(self, several: Sequence[GradedSubmission], book: Gradebook | None) -> None:
        """All at once; each by itself where one of them cannot be written, and that one without what was handed in."""
        if len(several) > 1:
            if isinstance(self._written(several, book), Failure):
                for one in several:
                    self._write([one], book)
            return
        for one in several:
            student = one.submission.student.id
            if isinstance(failure := self._written([one], book), Failure):
                self.failures.add(student, [failure])
                if isinstance(failure := self._written([self.unmarked(one.submission)], book), Failure):
                    self.failures.add(student, [failure])
                    self.not_run[student] = f"no result can be written ({failure.what})."

    def _written(self, several: Sequence[GradedSubmission], book: Gradebook | None) -> Failure | None:
        if not several:
            return None
        work = partial(write_graded, self.course, self.problem_set, several, self.by_hand, book)
        done = guarded(work, LONGEST, concerns_everybody())
        if isinstance(done, Failure) and book is not None:
            book.db.rollback()  # pyright: ignore[reportUnknownMemberType]
        return done

    def _has_to_wait(self, one: GradedSubmission) -> bool:
        old = self._standing(one)
        moved = None if old is None else self._change(one, old)
        moves = False
        if old is not None and moved is not None:
            self._changes.append(moved)
            if is_completed(old, one.submission.depends, moved):
                moves = False
            elif is_extended(old, one.submission.depends, moved, self.deadlines):
                self.extended.append(moved)
            else:
                moves = moved.moves_points
        self.moves_marks = self.moves_marks or moves
        return self.dry_run or moves or (self.regrade and old is not None)

    def _standing(self, one: GradedSubmission) -> Record | None:
        """The marks already given; None as well where the student handed in something else."""
        old = read_record(self.course, self.problem_set, one.marked.student.id)
        if old is None or (not self.dry_run and is_handed_in_anew(old, one.submission.depends)):
            return None
        return old

    def _change(self, one: GradedSubmission, old: Record) -> Change | None:
        """How these would change."""
        student = one.marked.student.id
        by_hand = self.by_hand.get(student, {})
        found = change(student, with_manual(old, by_hand), with_manual(one.record, by_hand))
        return None if found is None else found.because(why(old, one.submission.depends))


class NotGenerated(LookupError):
    """The set was never generated for this course; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a run of grading did. `not_run` are those whose notebook the machine failed to run, with a sentence: nothing is
    recorded for them, and the next run marks them. `records` holds every student's marks, those skipped included; `refilled`
    are those who had marks on record that nbgrader no longer had, `gone` those who have marks and whose notebook lies there no
    more, `guessed` those of whom no time of handing in is known. `changed` are those whose marks are others than before, or would
    be; when not all of it is `written`, nothing was written of `held`. `extended` are the changes that follow from more time given
    to one student. `failures` are those over whose work this program failed, and how; the `log` says where. `outside` are scores
    changed in the gradebook that nobody has agreed to."""

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
    gone: tuple[str, ...] = ()
    refilled: tuple[str, ...] = ()
    guessed: Mapping[str, GuessedTime] = field(default_factory=dict)
    failures: Mapping[str, str] = field(default_factory=dict)
    log: Path | None = None
    outside: tuple[OutsideChange, ...] = ()


def grade_set(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    runner: Callable[[], Runner],
    *,
    regrade: bool = False,
    dry_run: bool = False,
    ask: Callable[[tuple[Change, ...]], bool] = lambda changed: True,
    ask_outside: Callable[[tuple[OutsideChange, ...]], bool] = lambda outside: False,
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
    name, failures = problem_set.name, FailureLog(course, problem_set.name)
    handed_in = _handed_in(course, problem_set, solutions, now or datetime.now(UTC), dry_run, failures)
    digests = handed_in.digests
    if not dry_run:
        gather_requests(course, problem_set)
    manual = current_manual(course) if dry_run else synchronized(course)
    outside = tuple(read_outside(course, name).values())
    if outside and not dry_run and ask_outside(outside):
        manual, outside = take_outside(course, name), ()
    records = read_records(course, problem_set, digests)
    done = {
        one: record
        for one, record in records.items()
        if record.fingerprint == digests[one] and not is_package_changed(record, problem_set)
    }
    written = _written(course, problem_set, done, dry_run)
    todo = [student for student in digests if regrade or student not in written]
    given = manual.by_student(name)
    context = GradingContext(problem_set, solutions, course.key, runner)
    proposed = ProposedMarks(
        course,
        problem_set,
        handed_in.deadlines,
        given,
        regrade,
        dry_run,
        failures,
        partial(not_graded, context),
    )
    left = count(len(todo) - 1, -1)

    def take(graded: Iterable[GradedSubmission]) -> set[str]:
        ids = set[str]()
        with _gradebook(course, dry_run) as book:
            for several in together(graded):
                proposed.take(several, book)
                for one in several:
                    ids.add(one.submission.student.id)
                    progress(one.submission.student.id, next(left))
        return ids

    known = take(_marked_again(handed_in, todo, failures, only_changed=regrade)) if todo else set[str]()
    if to_run := [student for student in todo if student not in known and student not in failures.found]:
        for problem in problem_set.problems:
            solutions.of(problem)  # once, before there are workers who would each do it
        begin()
        run = execute or here(jobs, len(to_run))
        read = (failures.guarded(student, partial(handed_in.submission, student)) for student in to_run)
        with run(context, (each for each in read if each is not None)) as graded:
            take(graded)
    if not dry_run:
        if todo and (not proposed.moves_marks or ask(proposed.changed)):
            with _gradebook(course, dry_run) as book:
                proposed.write_held(book)
        follow_points(course, problem_set)
        manual = synchronized(course) if todo else manual  # a person may have given some meanwhile
        own = read_records(course, problem_set, handed_in.files)
        write_shared(course, problem_set, find_shared(problem_set, solutions, handed_in.assigned, own))
    if not dry_run:
        write_failures(course, name, failures.by_student, digests.keys() - set(todo))
    report = report_of(course, problem_set, manual, failures.by_student if dry_run else None)
    if not dry_run:
        _write_pages(course, problem_set, report, manual, handed_in.files, failures)
    failures.write()
    held, not_run, without = proposed.held_students, proposed.not_run, unclear(course, name)
    there = {*handed_in.files, *without}
    without_marks = failures.found.keys() - {one.student for one in report.handed_in}
    return Outcome(
        graded=tuple(student for student in todo if student not in not_run and student not in held),
        written=not held and not dry_run,
        skipped=tuple(student for student in digests if student not in todo),
        failed=tuple(dict.fromkeys((*not_run, *(one.student for one in report.failed), *without_marks))),
        strangers=handed_in.strangers,
        records=read_marks(course, problem_set, handed_in.files, manual),
        in_gradebook=has_nbgrader(),
        report=report,
        page=report_place(course, name),
        outside=outside,
        changed=proposed.changed,
        extended=() if dry_run else tuple(proposed.extended),
        held=tuple(student for student in todo if student in held),
        unclear=without,
        not_run=not_run,
        gone=tuple(one.student for one in report.handed_in if one.student not in there),
        refilled=tuple(student for student in done if student not in written),
        failures=failures.by_student,
        log=failures.place,
        guessed={one: guess for one in digests if (guess := guessed_time(course, name, one)) is not None},
    )


@dataclass(frozen=True, slots=True)
class _HandedIn:
    """What was handed in, before any of it is marked: `files`, `terms` and what was `assigned` by student. `digests` are the
    fingerprints of those who can be marked; `strangers` are those to whom nothing was assigned, or whom no roster names.
    `states` is what marks of the set depend on, by name."""

    course: Course
    problem_set: ProblemSet
    solutions: Solutions
    roster: Mapping[str, Student]
    assigned: Mapping[str, AssignedSheet]
    files: Mapping[str, Path]
    strangers: tuple[str, ...]
    deadlines: Deadlines
    terms: Mapping[str, Terms]
    digests: Mapping[str, str]
    states: Mapping[str, bytes]

    def submission(self, student: str) -> Submission:
        """What a student handed in, read."""
        course, about, owner = self.course, self.problem_set, self.roster[student]
        file, sheet, terms = self.files[student], self.assigned[student], self.terms[student]
        read = read_submission(course, about, owner, file, sheet, self.digests[student], terms)
        depends = dependencies(course, about.name, student, file, sheet, terms, self.states)
        packages = packages_now(read_record(course, about, student), about.packages)
        return replace(read, depends=depends | packages)


def is_package_changed(record: Record, problem_set: ProblemSet) -> bool:
    """Whether a package that was missing is there now, or is declared by now as one that may not be used."""
    now = packages_now(record, problem_set.packages)
    return any(record.depends[name] != state for name, state in now.items())


def _handed_in(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    now: datetime,
    dry_run: bool,
    failures: FailureLog,
) -> _HandedIn:
    """But for a dry run, this settles when each was handed in. Raises NotGenerated."""
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
    deadlines = read_deadlines(course, problem_set)
    terms = {student: deadlines.terms(student, now) for student in files}
    if not dry_run:
        for student in files.keys() - set(strangers):
            failures.guarded(student, partial(settle_time, course, name, student, terms[student]))
    state, digests = state_of(problem_set, solutions), dict[str, str]()
    for student in files.keys() - set(strangers) - failures.found.keys():
        work = partial(
            fingerprint, course, name, student, files[student], assigned[student], state, terms[student]
        )
        if (digest := failures.guarded(student, work)) is not None:
            digests[student] = digest
    digests = {student: digests[student] for student in files if student in digests}
    return _HandedIn(
        course, problem_set, solutions, roster, assigned, files, strangers, deadlines, terms, digests,
        state_by_name(problem_set, solutions),
    )  # fmt: skip


def _marked_again(
    handed_in: _HandedIn, those: Iterable[str], failures: FailureLog, *, only_changed: bool
) -> Iterator[GradedSubmission]:
    """Those whose notebooks need not be run again: what came of them is on record."""
    course, about, solutions = handed_in.course, handed_in.problem_set, handed_in.solutions
    for student in those:
        if page_facts_place(course, about.name, student).exists():
            read = failures.guarded(student, partial(handed_in.submission, student))
            if read is None:
                continue
            # Where that fails, the notebook is run again.
            found = guarded(partial(from_record, course, about, solutions, read, only_changed=only_changed))
            if isinstance(found, GradedSubmission):
                yield found


def _write_pages(
    course: Course,
    problem_set: ProblemSet,
    report: Report,
    manual: ManualMarks,
    those: Iterable[str],
    failures: FailureLog,
) -> None:
    """The report, and the feedback of those to whom a person gave something since theirs was made, or whose was lost."""
    page = report_page(report, problem_set, formgrader=read_settings(course.folder).formgrader)
    write_whole(report_place(course, problem_set.name), page)
    for one in those:
        failures.guarded(one, partial(_write_page_anew, course, problem_set.name, one, manual))


def _write_page_anew(course: Course, name: str, student: str, manual: ManualMarks) -> None:
    for one, text in stale_pages(course, name, manual, (student,)).items():
        write_page(course, name, one, text)


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
    from corollary.nbgrader.gradebook_record import in_gradebook
    from corollary.nbgrader.register import is_registered

    with gradebook(course) as book:
        known = is_registered(book, problem_set)
        there &= in_gradebook(course, book, problem_set, records) if known else set[str]()
    if not known:
        register(course, problem_set, source_notebook(problem_set))
    return there


def _gradebook(course: Course, dry_run: bool) -> AbstractContextManager[Gradebook | None]:
    """Opened once for all that is written, and after the workers have started: a connection does not survive a fork."""
    return gradebook(course) if has_nbgrader() and not dry_run else nullcontext()
