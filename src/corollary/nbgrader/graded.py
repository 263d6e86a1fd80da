"""A submission marked, with all that is to be written of it: the marked notebook and the feedback page as text.

Both are made by whoever marks, side by side with others; only one process writes.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from corollary.grading.grade import Marked
from corollary.grading.submission import (
    GradingContext,
    MarkedSubmission,
    Submission,
    left_to_a_person,
    mark_submission,
)
from corollary.nbgrader.marked_notebook import marked_notebook, notebook_text
from corollary.render.feedback_page import feedback_page
from corollary.sandbox.runner import Runner


@dataclass(frozen=True, slots=True)
class GradedSubmission:
    """Without what is in the two texts and weighs most (bytes, runs and pictures): it travels between processes.

    `notebook` is empty when none is wanted."""

    submission: Submission
    marked: Marked
    notebook: str
    page: str


def grade_submission(context: GradingContext, runner: Runner, submission: Submission) -> GradedSubmission:
    """Marks one submission. A failing of ours goes to a person; only what concerns every submission (CannotStart,
    WeakIsolation) is raised."""
    found = mark_submission(context, runner, submission)
    try:
        return _graded(context, submission, found)
    except Exception as error:  # a page that cannot be made costs no marks either
        why = f"{type(error).__name__}: {error}"
        return _graded(context, submission, left_to_a_person(context, submission, why, found.notebook))


def not_graded(context: GradingContext, submission: Submission, why: str) -> GradedSubmission:
    """A submission whose marking was cut short from outside: every part waits for a person."""
    return _graded(context, submission, left_to_a_person(context, submission, why))


def _graded(context: GradingContext, submission: Submission, found: MarkedSubmission) -> GradedSubmission:
    problem_set, marked, text = context.problem_set, found.marked, ""
    page = feedback_page(marked, problem_set, solutions=found.worked_solutions)
    if context.marked_notebooks:
        text = notebook_text(marked_notebook(marked, problem_set, found.notebook))
    return GradedSubmission(
        replace(submission, content=b""), replace(marked, runs=(), figures=()), text, page
    )
