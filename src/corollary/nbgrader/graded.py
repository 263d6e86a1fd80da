"""A submission marked, with all that is to be written of it: the marked notebook and the feedback page as text.

Both are made by whoever marks, side by side with others; only one process writes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import partial

from corollary.grading.part_grades import Marked
from corollary.grading.submission import (
    LONGEST,
    GradingContext,
    MarkedSubmission,
    Submission,
    left_to_a_person,
    mark_submission,
)
from corollary.guard import Failure, guarded
from corollary.messages import language
from corollary.nbgrader.marked_notebook import answer_digest, marked_notebook, notebook_text, part_grades
from corollary.problem.late_penalty import delay_in_words
from corollary.problem.problem_set import ProblemSet
from corollary.records.manual_marks import OfStudent
from corollary.records.marks import Record, record_of, with_manual
from corollary.render.feedback_page import feedback_page, packed, page_facts, unpacked
from corollary.sandbox.runner import Runner


@dataclass(frozen=True, slots=True)
class GradedSubmission:
    """Without what is in the texts and weighs most (bytes, runs and pictures): it travels between processes.

    `page` is the feedback with the program's own marks, `facts` what it is made again from, `answers` a digest of what was
    written for each part, `failures` what this program stumbled over."""

    submission: Submission
    marked: Marked
    notebook: str
    facts: bytes
    page: str
    answers: Mapping[str, str]
    failures: tuple[Failure, ...] = ()

    @property
    def record(self) -> Record:
        """What is recorded of it: the program's own marks."""
        return record_of(self.marked, self.submission.fingerprint, self.answers, self.submission.depends)

    def page_with(self, manual: OfStudent) -> str:
        """The feedback page with what a person gave."""
        if not manual:
            return self.page
        return feedback_page(unpacked(self.facts), with_manual(self.record, manual))


def grade_submission(context: GradingContext, runner: Runner, submission: Submission) -> GradedSubmission:
    """Marks one submission. A failing of ours goes to a person; only what concerns every submission (CannotStart,
    WeakIsolation) is raised."""
    with language(context.language):
        found = mark_submission(context, runner, submission)
        made = guarded(partial(graded, context.problem_set, submission, found), LONGEST)
        if isinstance(made, Failure):  # a page that cannot be made costs no marks either
            left = left_to_a_person(context, submission)
            made = graded(context.problem_set, submission, replace(left, failures=(*found.failures, made)))
        return made


def not_graded(context: GradingContext, submission: Submission, why: str = "") -> GradedSubmission:
    """A submission whose marking was cut short from outside: every part waits for a person."""
    return graded(context.problem_set, submission, left_to_a_person(context, submission, why))


def lateness_in_words(problem_set: ProblemSet, submission: Submission) -> str:
    """What the student reads of the own delay where the set takes points off by steps; else empty."""
    steps, due = problem_set.late_steps, submission.due
    return "" if steps is None or due is None else delay_in_words(steps, due, submission.late)


def graded(problem_set: ProblemSet, submission: Submission, found: MarkedSubmission) -> GradedSubmission:
    """All that is to be written of marked work."""
    marked = found.marked
    facts = page_facts(
        marked,
        problem_set,
        solutions=found.worked_solutions,
        due=submission.due,
        rubric=submission.rubric,
        late=lateness_in_words(problem_set, submission),
    )
    node = marked_notebook(marked, problem_set, found.notebook)
    return GradedSubmission(
        replace(submission, content=b""),
        replace(marked, runs=(), figures=()),
        notebook_text(node),
        packed(facts),
        feedback_page(facts, record_of(marked, "")),
        {key: answer_digest(node, key) for key, _ in part_grades(marked)},
        found.failures,
    )
