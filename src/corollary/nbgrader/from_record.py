"""Marks given again from the record, where nothing changed that running a notebook could tell: dates, credit, points, rubrics."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import msgspec
import nbformat
from nbformat import NotebookNode

from corollary.answers.verdict import Right, Unmarked
from corollary.grading.expectations import rubric_of
from corollary.grading.feedback import revealed
from corollary.grading.key import Key
from corollary.grading.part_grades import Grade, Marked, PartGrade
from corollary.grading.points import with_points
from corollary.grading.solutions import Solutions
from corollary.grading.submission import LATE_SHARE, Submission
from corollary.nbgrader.graded import GradedSubmission, lateness_in_words
from corollary.nbgrader.marked_notebook import (
    FOLDED_AWAY,
    NOBODY,
    notebook_text,
    with_rubrics,
    with_verdicts,
)
from corollary.nbgrader.written_marks import stored_facts
from corollary.notebook.notebook import notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.dates import written
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.variant import Variant
from corollary.records.files import Course
from corollary.records.marks import Record, Row, read_record, record_of
from corollary.records.regrading import TIME, changed, needs_no_run
from corollary.records.submissions import verdict_of
from corollary.render.feedback_page import ExerciseFacts, PageFacts, PartFacts, feedback_page, packed
from corollary.render.markdown import html


def from_record(
    course: Course,
    problem_set: ProblemSet,
    solutions: Solutions,
    submission: Submission,
    *,
    only_changed: bool = False,
) -> GradedSubmission | None:
    """The submission with the verdicts that it was given, with the points, the rubrics and the lateness of now, and with or without
    right values, as its student may see them now; None where something else has changed, or is not as it was recorded, or with
    `only_changed` nothing has: then its notebook is run again."""
    student = submission.student.id
    record, facts = (
        read_record(course, problem_set, student),
        stored_facts(course, problem_set.name, student),
    )
    if record is None or facts is None or record.trouble or submission.retained:
        return None
    causes = changed(record, submission.depends)
    if not needs_no_run(causes) or (only_changed and not causes):
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
    seen = any(each.solution for each in facts.exercises)
    if seen != submission.reveal:
        grades = [_seen(keys[each.variant.problem.code], each, submission.reveal) for each in marked.grades]
        if None in grades:
            return None
        marked = replace(marked, grades=tuple(each for each in grades if each is not None))
    marked = replace(marked, late=submission.late.seconds, late_share=submission.late.share)
    if not set(causes) <= {TIME, LATE_SHARE}:
        marked = _with_points(marked, problem_set, keys)
        _as_handed_out_now(node, problem_set, submission)
        with_rubrics(node, marked)
    facts = _with(facts, worked if submission.reveal else {}, marked, submission)
    facts = msgspec.structs.replace(facts, late=lateness_in_words(problem_set, submission))
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
    rows = {(row.problem, row.part): row for row in record.rows}
    grades: list[Grade] = []
    for variant in submission.variants:
        parts = [_part(record, variant, part.id, rows) for part in variant.problem.parts]
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
        record.stopped,
    )


def _part(
    record: Record, variant: Variant, part_id: str, rows: dict[tuple[str, str], Row]
) -> PartGrade | None:
    problem = variant.problem
    part = problem.part(part_id)
    found = record.parts.get(problem.answer_name(part))
    if found is None:
        return None
    row = rows.get((problem.code, part_id))
    verdict = verdict_of(found, row.why if row else "")
    basis = () if found.basis is msgspec.UNSET else found.basis
    near = row.near if row else None
    return PartGrade(part, verdict, found.points, found.out_of, found.answer, found.feedback, basis, near)


def _as_recorded(record: Record, marked: Marked) -> Record:
    again = record_of(marked, record.fingerprint, record.answers, record.depends)
    return msgspec.structs.replace(again, version=record.version)


def _seen(key: Key, grade: Grade, reveal: bool) -> Grade | None:
    """With the right values said in the feedback of what is not right, or without; None where they were said otherwise."""
    parts: list[PartGrade] = []
    for part in grade.parts:
        sentence = f" {solution}" if (solution := revealed(key, part.part, part.answer)) else ""
        if isinstance(part.verdict, Right) or not sentence:
            parts.append(part)
        elif reveal:
            parts.append(replace(part, feedback=part.feedback + sentence))
        elif part.feedback.endswith(sentence):
            parts.append(replace(part, feedback=part.feedback.removesuffix(sentence)))
        else:
            return None
    return replace(grade, parts=tuple(parts))


def _with_points(marked: Marked, problem_set: ProblemSet, keys: Mapping[str, Key]) -> Marked:
    """The verdicts as they are, with what they earn and what a person marks by now."""

    def part(each: PartGrade, problem: Problem) -> PartGrade:
        waits = each.verdict
        if (
            isinstance(waits, Unmarked)
            and waits.rubric
            and (rubric := rubric_of(keys[problem.code], each.part.id))
        ):
            each = replace(each, verdict=replace(waits, rubric=rubric))
        return with_points(each, problem_set.scheme, problem_set.weight(problem))

    def graded(grade: Grade) -> Grade:
        return replace(grade, parts=tuple(part(each, grade.variant.problem) for each in grade.parts))

    return replace(marked, grades=tuple(map(graded, marked.grades)))


def _as_handed_out_now(node: NotebookNode, problem_set: ProblemSet, submission: Submission) -> None:
    """What the marked notebook has of the sheet (date, points) as a new one would have it; what the student wrote stays."""
    ours = {cell.id: cell for cell in notebook(worksheet(problem_set, NOBODY, submission.variants)).cells}

    def cell_now(cell: NotebookNode) -> NotebookNode:
        new = ours.get(cell.get("id", ""))
        if new is None:
            return cell
        if new.metadata["nbgrader"]["solution"]:
            cell.metadata["nbgrader"] = new.metadata["nbgrader"]
            return cell
        return cell if cell.source == FOLDED_AWAY else new

    node.cells = [cell_now(cell) for cell in node.cells]


def _with(facts: PageFacts, worked: dict[str, str], marked: Marked, submission: Submission) -> PageFacts:
    """The facts with these worked solutions, the deadline of now, and rubrics where students may read them by now."""
    rubrics = {
        grade.variant.problem.answer_name(part.part): part.verdict.rubric
        for grade in marked.grades
        for part in grade.parts
        if submission.rubric and isinstance(part.verdict, Unmarked)
    }

    def part_facts(part: PartFacts) -> PartFacts:
        return msgspec.structs.replace(part, rubric=rubrics.get(part.key, ()))

    def exercise(each: ExerciseFacts) -> ExerciseFacts:
        parts = tuple(map(part_facts, each.parts))
        return msgspec.structs.replace(each, solution=worked.get(each.code, ""), parts=parts)

    due = "" if submission.due is None else written(submission.due)
    return msgspec.structs.replace(facts, exercises=tuple(map(exercise, facts.exercises)), due=due)
