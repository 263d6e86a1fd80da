"""Marks of parts that are no longer asked: who was given them has them still."""

from __future__ import annotations

from msgspec import UNSET

from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Unread, Verdict, Wrong
from corollary.grading.grade import Grade, PartGrade
from corollary.problem.problem_set import ProblemSet
from corollary.records.assigned import AssignedSheet
from corollary.records.files import Course
from corollary.records.marks import read_record
from corollary.records.record import PartRecord


def retained(
    course: Course, problem_set: ProblemSet, student: str, sheet: AssignedSheet
) -> tuple[Grade, ...]:
    """What the newest record has of the parts that are gone, by problem; nothing for parts that were never marked."""
    record = read_record(course, problem_set, student) if sheet.removed else None
    if record is None:
        return ()
    reasons = {(row.problem, row.part): row.why for row in record.rows}
    found: list[Grade] = []
    for variant in sheet.removed:
        problem = variant.problem
        parts = tuple(
            PartGrade(
                part,
                verdict_of(marked, reasons.get((problem.code, part.id), "")),
                marked.points,
                marked.out_of,
                marked.answer,
                marked.feedback,
                () if marked.basis is UNSET else marked.basis,
            )
            for part in problem.parts
            if (marked := record.parts.get(problem.answer_name(part))) is not None
        )
        if parts:
            found.append(Grade(variant, parts))
    return tuple(found)


def verdict_of(part: PartRecord, why: str) -> Verdict:
    """The verdict as it was recorded."""
    match part.verdict:
        case "right":
            return Right(why)
        case "follows":
            return Follows(tuple(why.removeprefix("from ").split(", ")))
        case "mistaken":
            earlier = tuple(why.removeprefix("from ").split(", ")) if why else ()
            return Mistaken("" if part.mistake is UNSET else part.mistake, earlier)
        case "slip":
            return Slip("" if part.slip is UNSET else part.slip)
        case "wrong":
            return Wrong(why)
        case "unread":
            return Unread(why)
        case _:
            return Unmarked(why, () if part.rubric is UNSET else part.rubric)
