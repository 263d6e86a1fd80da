"""Marks on their way to the records: written at once, or held until it is agreed that they move what was already given."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from corollary.course.batches import together
from corollary.nbgrader.graded import GradedSubmission
from corollary.nbgrader.marks import write_graded
from corollary.problem.problem_set import ProblemSet
from corollary.records.causes import is_extended, is_handed_in_anew, why
from corollary.records.deadlines import Deadlines
from corollary.records.files import Course
from corollary.records.manual import OfStudent
from corollary.records.marks import read_record
from corollary.records.record import Record, with_manual
from corollary.records.regrading import Change, change, largest_first

if TYPE_CHECKING:
    from nbgrader.api import Gradebook


@dataclass(slots=True)
class ProposedMarks:
    """The marks of a run of grading. `by_hand` is what persons gave, by student; a regrade is written whole or not at all, a dry
    run never. `not_run` says why the machine failed to run somebody's notebook; `extended` are the changes that follow from
    more time given to one student; `moves_marks` says that others are moved, too, which nobody has agreed to yet."""

    course: Course
    problem_set: ProblemSet
    deadlines: Deadlines
    by_hand: Mapping[str, OfStudent]
    regrade: bool
    dry_run: bool
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
            if one.marked.machine_failed:
                self.not_run[one.submission.student.id] = one.marked.trouble
            else:
                (self._held if self._has_to_wait(one) else at_once).append(one)
        if at_once:
            write_graded(self.course, self.problem_set, at_once, self.by_hand, book)

    def write_held(self, book: Gradebook | None) -> None:
        """What was held, once it is agreed to."""
        for several in together(self._held):
            write_graded(self.course, self.problem_set, several, self.by_hand, book)
        self._held.clear()

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
        if old is None or (not self.dry_run and is_handed_in_anew(old, one.submission.depends, one.answers)):
            return None
        return old

    def _change(self, one: GradedSubmission, old: Record) -> Change | None:
        """How these would change."""
        student = one.marked.student.id
        by_hand = self.by_hand.get(student, {})
        found = change(student, with_manual(old, by_hand), with_manual(one.record, by_hand))
        return None if found is None else found.because(why(old, one.submission.depends))
