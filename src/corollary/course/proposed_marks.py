"""Marks on their way to the records: written at once, or held until it is agreed that they move what was already given."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING

from corollary.course.batches import together
from corollary.course.failure_log import LONGEST, FailureLog
from corollary.grading.submission import Submission
from corollary.guard import Failure, guarded
from corollary.nbgrader.gradebook import concerns_everybody
from corollary.nbgrader.graded import GradedSubmission
from corollary.nbgrader.written_marks import write_graded
from corollary.problem.problem_set import ProblemSet
from corollary.records.deadlines import Deadlines
from corollary.records.files import Course
from corollary.records.manual_marks import OfStudent
from corollary.records.marks import Record, read_record, with_manual
from corollary.records.regrading import Change, change, is_extended, is_handed_in_anew, largest_first, why

if TYPE_CHECKING:
    from nbgrader.api import Gradebook


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
                    self.not_run[student] = f"nothing of it can be written ({failure.what})."

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
            if is_extended(old, one.submission.depends, moved, self.deadlines):
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
