"""Feedback whose right values may be seen by now, made of what is recorded: no notebook is run for it a second time."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from dataclasses import replace

import msgspec
import nbformat

from corollary.answers.verdict import Right, Unmarked
from corollary.grading.feedback import revealed
from corollary.grading.grade import Grade, Marked, PartGrade
from corollary.grading.key import Key
from corollary.grading.solutions import Solutions
from corollary.grading.submission import Submission
from corollary.nbgrader.graded import GradedSubmission
from corollary.nbgrader.marked_notebook import notebook_text, with_verdicts
from corollary.nbgrader.marks import stored_facts
from corollary.problem.problem_set import ProblemSet
from corollary.problem.variant import Variant
from corollary.records.files import Course
from corollary.records.marks import read_record
from corollary.records.record import Record, record_of
from corollary.records.retained import verdict_of
from corollary.render.feedback_facts import ExerciseFacts, PageFacts, PartFacts, packed
from corollary.render.feedback_page import feedback_page
from corollary.render.markdown import html


def with_right_values(
    course: Course, problem_set: ProblemSet, solutions: Solutions, submission: Submission
) -> GradedSubmission | None:
    """The submission as it was marked, with the right values and worked solutions in its feedback; None where more than that has
    changed, or something of it is not as it was recorded: then it is marked again."""
    student = submission.student.id
    record, facts = (
        read_record(course, problem_set, student),
        stored_facts(course, problem_set.name, student),
    )
    if record is None or facts is None or record.trouble or not submission.reveal or submission.retained:
        return None
    if record.depends != submission.depends or any(each.solution for each in facts.exercises):
        return None
    marked = _marked(record, submission)
    if marked is None or _as_recorded(record, marked) != record:
        return None
    try:
        place = course.notebook("autograded", student, problem_set.name)
        node = nbformat.read(place, as_version=4)
    except (OSError, ValueError, AttributeError, KeyError):
        return None
    try:
        keys = {variant.problem.code: solutions.key(variant) for variant in submission.variants}
        worked = {code: html(solutions.worked_solution_of(key)) for code, key in keys.items()}
    except Exception:  # a key of its numbers cannot be made any more: marking it again says so
        return None
    marked = replace(marked, grades=tuple(_revealed(keys[g.variant.problem.code], g) for g in marked.grades))
    facts = _with(facts, worked, marked, submission.rubric)
    return GradedSubmission(
        submission=replace(submission, content=b""),
        marked=marked,
        notebook=notebook_text(with_verdicts(node, marked)),
        facts=packed(facts),
        page=feedback_page(facts, record_of(marked, "")),
        answers=record.answers,
    )


def _marked(record: Record, submission: Submission) -> Marked | None:
    """The marks as they were given; None where the record has other parts."""
    reasons = {(row.problem, row.part): row.why for row in record.rows}
    grades: list[Grade] = []
    for variant in submission.variants:
        parts = [_part(record, variant, part.id, reasons) for part in variant.problem.parts]
        grades.append(Grade(variant, tuple(part for part in parts if part is not None)))
        if None in parts:
            return None
    one = record.handed_in
    return Marked(
        submission.student,
        tuple(grades),
        (),
        (),
        record.isolation,
        "",
        record.late,
        record.late_share,
        one.notes,
    )


def _part(
    record: Record, variant: Variant, part_id: str, reasons: dict[tuple[str, str], str]
) -> PartGrade | None:
    problem = variant.problem
    part = problem.part(part_id)
    found = record.parts.get(problem.answer_name(part))
    if found is None:
        return None
    verdict = verdict_of(found, reasons.get((problem.code, part_id), ""))
    return PartGrade(part, verdict, found.points, found.out_of, found.answer, found.feedback)


def _as_recorded(record: Record, marked: Marked) -> Record:
    again = record_of(marked, record.fingerprint, record.answers, record.depends)
    return msgspec.structs.replace(again, version=record.version)


def _revealed(key: Key, grade: Grade) -> Grade:
    parts = [
        replace(part, feedback=f"{part.feedback} {solution}")
        if not isinstance(part.verdict, Right) and (solution := revealed(key, part.part, part.answer))
        else part
        for part in grade.parts
    ]
    return replace(grade, parts=tuple(parts))


def _with(facts: PageFacts, worked: dict[str, str], marked: Marked, rubric: bool) -> PageFacts:
    """The facts with worked solutions, and with rubrics where students may read them by now."""
    rubrics = {
        grade.variant.problem.answer_name(part.part): part.verdict.rubric
        for grade in marked.grades
        for part in grade.parts
        if rubric and isinstance(part.verdict, Unmarked)
    }

    def part_facts(part: PartFacts) -> PartFacts:
        return msgspec.structs.replace(part, rubric=rubrics.get(part.key, part.rubric))

    def exercise(each: ExerciseFacts) -> ExerciseFacts:
        parts = tuple(map(part_facts, each.parts))
        return msgspec.structs.replace(each, solution=worked.get(each.code, ""), parts=parts)

    return msgspec.structs.replace(facts, exercises=tuple(map(exercise, facts.exercises)))
