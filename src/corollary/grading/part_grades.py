"""Verdicts turned into points, and into what the student reads."""

from __future__ import annotations

from dataclasses import dataclass, replace

from corollary.answers.verdict import Unmarked, Verdict
from corollary.grading.stopped_cells import StoppedCell
from corollary.problem.part import Part
from corollary.problem.roster import Student
from corollary.problem.variant import Variant
from corollary.sandbox.job import CellRun, Figure


@dataclass(frozen=True, slots=True)
class NearMiss:
    """An answer that would be right if it were read otherwise: the kind of other reading, the answer as typed, and so read."""

    kind: str
    text: str
    read: str


@dataclass(frozen=True, slots=True)
class PartGrade:
    """`answer` is how the answer was read (or as typed, when it was not); `feedback` is Markdown for the student.
    `basis` has for each answer type what its share of the points goes by, where the verdict's word does not say it
    (`grading.points`)."""

    part: Part
    verdict: Verdict
    points: float
    out_of: float
    answer: str
    feedback: str
    basis: tuple[str, ...] = ()
    near: NearMiss | None = None

    @property
    def waits(self) -> bool:
        return isinstance(self.verdict, Unmarked)


@dataclass(frozen=True, slots=True)
class Grade:
    """One problem of one student."""

    variant: Variant
    parts: tuple[PartGrade, ...]

    def __getitem__(self, part: str) -> PartGrade:
        """What one part has earned."""
        return next(each for each in self.parts if each.part.id == part)

    def joined(self, earlier: Grade) -> Grade:
        """With the parts of another one of the same problem."""
        problem = self.variant.problem
        parts = (*problem.parts, *earlier.variant.problem.parts)
        return Grade(
            replace(self.variant, problem=replace(problem, parts=parts)), (*self.parts, *earlier.parts)
        )

    @property
    def points(self) -> float:
        return sum(part.points for part in self.parts)

    @property
    def out_of(self) -> float:
        return sum(part.out_of for part in self.parts)


@dataclass(frozen=True, slots=True)
class Marked:
    """A whole submission, marked. `trouble` is a sentence when something went wrong with it as a whole; `late` in seconds;
    `notes` are sentences on what was noticed, such as an edited statement: told, and not marked; `stopped` are the cells that did
    not run to their end."""

    student: Student
    grades: tuple[Grade, ...]
    runs: tuple[CellRun, ...]
    figures: tuple[Figure, ...]
    isolation: str
    trouble: str
    late: float
    late_share: float
    notes: tuple[str, ...] = ()
    stopped: tuple[StoppedCell, ...] = ()
    machine_failed: bool = (
        False  # the notebook could not be run, for no reason of its own: nothing is to be recorded
    )

    def joined(self, earlier: tuple[Grade, ...]) -> Marked:
        """With earlier marks of parts that are not asked any more, each behind its problem's or, where that is gone, behind all."""
        by_code = {grade.variant.problem.code: grade for grade in self.grades}
        for grade in earlier:
            code = grade.variant.problem.code
            by_code[code] = by_code[code].joined(grade) if code in by_code else grade
        return replace(self, grades=tuple(by_code.values()))

    @property
    def points(self) -> float:
        return sum(grade.points for grade in self.grades) * self.late_share

    @property
    def out_of(self) -> float:
        return sum(grade.out_of for grade in self.grades)
