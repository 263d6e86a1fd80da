"""One submission marked from its bytes alone: what whoever marks is given, and what they return; nothing is written here."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from corollary.course.generate import variants_of
from corollary.grading.grade import Marked
from corollary.grading.key import Key
from corollary.grading.marking import mark, not_marked
from corollary.grading.solutions import Solutions
from corollary.nbgrader.integrity import notes
from corollary.nbgrader.marked_notebook import marked_notebook, notebook_text
from corollary.notebook.worksheet import worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.render.feedback_page import feedback_page
from corollary.sandbox.file import Unreadable
from corollary.sandbox.isolation import WeakIsolation
from corollary.sandbox.notebook import Notebook, notebook_of
from corollary.sandbox.runner import Runner
from corollary.sandbox.zygote import CannotStart


@dataclass(frozen=True, slots=True)
class GradingContext:
    """What all submissions of one grading share. `secret` is the course's key, `runner` makes what runs their notebooks, and
    `notebooks` says whether the marked notebooks are wanted, which only nbgrader has a use for."""

    problem_set: ProblemSet
    solutions: Solutions
    secret: bytes
    runner: Callable[[], Runner]
    notebooks: bool = True


@dataclass(frozen=True, slots=True)
class Submission:
    """One submission: its bytes (or why there are none), the variants its student was dealt, and how late it is in seconds."""

    student: Student
    content: bytes | Unreadable
    row: Mapping[str, int]
    late: float
    fingerprint: str


@dataclass(frozen=True, slots=True)
class GradedSubmission:
    """A submission as marked, without what is in the two texts and weighs most (its bytes, runs and pictures): the marked
    notebook as it is to be written (empty when none is wanted), and the feedback page."""

    handed: Submission
    marked: Marked
    notebook: str
    page: str


def mark_one(order: GradingContext, runner: Runner, handed: Submission) -> GradedSubmission:
    """Marks one submission. A failing of ours goes to a person and costs no marks; only what concerns every submission
    (CannotStart, WeakIsolation) is raised."""
    paper = worksheet(order.problem_set, handed.student, variants_of(order.problem_set, dict(handed.row)))
    read = notebook_of(handed.content) if isinstance(handed.content, bytes) else handed.content
    opened = read if isinstance(read, Notebook) else None
    try:
        keys = {exercise.problem.code: order.solutions.key(exercise.variant) for exercise in paper.exercises}
        marked = mark(paper, keys, read, runner, order.secret, handed.late)
        marked = replace(marked, notes=notes(paper, opened.node) if opened is not None else ())
        return _returned(order, handed, marked, opened, page_of(order, marked, keys))
    except (CannotStart, WeakIsolation):
        raise
    except Exception as error:
        return set_aside(order, handed, f"{type(error).__name__}: {error}", opened)


def set_aside(
    order: GradingContext, handed: Submission, why: str, opened: Notebook | None = None
) -> GradedSubmission:
    """A submission that could not be marked through no fault of its student: every part waits for a person."""
    paper = worksheet(order.problem_set, handed.student, variants_of(order.problem_set, dict(handed.row)))
    marked = not_marked(paper, f"It could not be marked by the program ({why}).", handed.late)
    return _returned(order, handed, marked, opened, feedback_page(marked, order.problem_set))


def _returned(
    order: GradingContext, handed: Submission, marked: Marked, opened: Notebook | None, page: str
) -> GradedSubmission:
    """All that can be done side by side is done before the one who writes gets it."""
    text = ""
    if order.notebooks:
        text = notebook_text(
            marked_notebook(marked, order.problem_set, opened.node if opened is not None else None)
        )
    return GradedSubmission(replace(handed, content=b""), replace(marked, runs=(), figures=()), text, page)


def page_of(order: GradingContext, marked: Marked, keys: Mapping[str, Key]) -> str:
    """The feedback page; with the worked solutions where the set reveals them."""
    stories = (
        {code: order.solutions.told(key) for code, key in keys.items()} if order.problem_set.reveal else None
    )
    return feedback_page(marked, order.problem_set, solutions=stories)
