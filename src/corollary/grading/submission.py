"""One submission marked from its bytes alone, in whatever process: what it is marked by, and what comes out."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime
from functools import partial
from typing import TYPE_CHECKING

from corollary.grading.integrity import elsewhere, notes
from corollary.grading.judged_by import without_points, without_rubrics
from corollary.grading.marking import mark, not_marked
from corollary.grading.part_grades import Grade, Marked
from corollary.grading.solutions import Solutions
from corollary.guard import Failure, collecting, guarded
from corollary.messages import catalogue, spoken
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.late_penalty import Delay
from corollary.problem.packed_pictures import packed_file
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.translation import translation
from corollary.problem.variant import Variant
from corollary.sandbox.file import Unreadable
from corollary.sandbox.isolation import WeakIsolation
from corollary.sandbox.notebook_file import Notebook, notebook_of
from corollary.sandbox.runner import Runner
from corollary.sandbox.zygote import CannotStart
from corollary.version import __version__

if TYPE_CHECKING:
    from nbformat import NotebookNode

_ = catalogue(__name__)

LONGEST = 60.0
"""Seconds of the processor for marking one submission, beside what its notebook takes in a process of its own."""

LATE_SHARE = "what late work keeps"
JUDGED_BY = "what verdicts follow from in "
CREDIT, WEIGHTS = "what the set gives for a verdict", "the weights of the problems"


@dataclass(frozen=True, slots=True)
class Submission:
    """What a student handed in: its bytes (or why there are none), the variants that the student was given, how late it is,
    the fingerprint of all that its marks and its page depend on, whether its feedback may give right values by
    now, the student's own deadline, earlier marks of parts that are not asked any more, and a digest of each thing that the
    marks depend on, by name."""

    student: Student
    content: bytes | Unreadable
    variants: tuple[Variant, ...]
    late: Delay
    fingerprint: str
    reveal: bool = False
    due: datetime | None = None
    retained: tuple[Grade, ...] = ()
    depends: Mapping[str, str] = field(default_factory=dict[str, str])
    rubric: bool = False  # whether the student may read by now what answers in words are marked by

    @property
    def notebook(self) -> Notebook | Unreadable:
        return notebook_of(self.content) if isinstance(self.content, bytes) else self.content


@dataclass(frozen=True, slots=True)
class GradingContext:
    """What all submissions of one grading share. `secret` is the course's key, `runner` makes what runs their notebooks."""

    problem_set: ProblemSet
    solutions: Solutions
    secret: bytes
    runner: Callable[[], Runner]
    language: str = field(default_factory=spoken)  # a process of a cluster has not heard it

    def worksheet(self, submission: Submission) -> Worksheet:
        """The student's own sheet, as it was handed out."""
        return worksheet(self.problem_set, submission.student, submission.variants)


@dataclass(frozen=True, slots=True)
class MarkedSubmission:
    """Marks, the notebook as it was handed in (None when it could not be opened), the worked solutions by code of the
    problem where they are revealed, and what this program stumbled over."""

    marked: Marked
    notebook: NotebookNode | None
    worked_solutions: Mapping[str, str]
    failures: tuple[Failure, ...] = ()


def mark_submission(context: GradingContext, runner: Runner, submission: Submission) -> MarkedSubmission:
    """Marks one submission. A failing of ours goes to a person, costs no marks, and is among the `failures`; only what concerns
    every submission (CannotStart, WeakIsolation) is raised."""
    with collecting() as failures:
        work = partial(_marked, context, runner, submission)
        found = guarded(work, LONGEST, (CannotStart, WeakIsolation))
        if isinstance(found, Failure):
            found = left_to_a_person(context, submission)
    return replace(found, failures=tuple(failures))


def _marked(context: GradingContext, runner: Runner, submission: Submission) -> MarkedSubmission:
    sheet = context.worksheet(submission)
    received = submission.notebook
    node = received.node if isinstance(received, Notebook) else None
    if node is not None and (why := elsewhere(sheet, node)):
        return MarkedSubmission(not_marked(sheet, why, submission.late).joined(submission.retained), node, {})
    keys = {each.problem.code: context.solutions.key(each.variant) for each in sheet.exercises}
    marked = mark(sheet, keys, received, runner, context.secret, submission.late, submission.reveal)
    marked = marked.joined(submission.retained)
    marked = replace(marked, notes=(*(notes(sheet, node) if node is not None else ()), *marked.notes))
    # Who handed in what cannot be opened may hand in again: the answers stay hidden.
    revealed = keys if submission.reveal and node is not None else {}
    worked = {code: context.solutions.worked_solution_of(key) for code, key in revealed.items()}
    return MarkedSubmission(marked, node, worked)


def left_to_a_person(context: GradingContext, submission: Submission, why: str = "") -> MarkedSubmission:
    """A submission that could not be marked through no fault of its student: every part waits for a person. Nothing of what
    was handed in is shown again: it may be what could not be handled."""
    sentence = (
        _("The program failed to mark this, so your teacher will mark it ({why}).", why=why)
        if why
        else _("The program failed to mark this, so your teacher will mark it.")
    )
    marked = not_marked(context.worksheet(submission), sentence, submission.late)
    return MarkedSubmission(marked.joined(submission.retained), None, {})


def state_of(problem_set: ProblemSet, solutions: Solutions) -> str:
    """A digest of all but the submission and its dates that marks depend on: problems, solutions, what the set says, and this
    program.

    Marks from two states must not meet in one gradebook unnoticed, and a process that lives long must not mark by solutions
    that have changed. Raises NotDerivable.
    """
    steps = () if problem_set.late_steps is None else (problem_set.late_steps,)
    about = (problem_set.scheme, problem_set.weights, __version__, *_adapted(problem_set), *steps)
    digest = hashlib.sha256(repr(about).encode())
    for problem in problem_set.problems:
        for content in (_words(problem), solutions.source(problem)):
            digest.update(len(content).to_bytes(8, "big") + content)
    return digest.hexdigest()


def state_by_name(problem_set: ProblemSet, solutions: Solutions) -> dict[str, bytes]:
    """What `state_of` is a digest of, thing by thing, under the names that people read. Raises NotDerivable."""
    found = {
        CREDIT: repr(replace(problem_set.scheme, late=1.0)).encode(),
        LATE_SHARE: repr(problem_set.late_steps or problem_set.scheme.late).encode(),
        WEIGHTS: repr((problem_set.weights, *_adapted(problem_set))).encode()
        if _adapted(problem_set)
        else repr(problem_set.weights).encode(),
        "the version of the program": __version__.encode(),
    }
    for problem in problem_set.problems:
        found[f"the problem {problem.code}"] = _words(problem)
        found[f"the solution of {problem.code}"] = solutions.source(problem)
        found[judged_by(problem.code)] = (
            without_points(_words(problem)) + b"\0" + without_rubrics(solutions.source(problem))
        )
    return found


def judged_by(code: str) -> str:
    """The name of what the verdicts on a problem follow from: its file without the points, its solution without the rubrics."""
    return f"{JUDGED_BY}{code}"


def _adapted(problem_set: ProblemSet) -> list[tuple[str, float]]:
    """The parts that the set asks for, and their points, where these are not those of the problem's file."""
    return [
        (problem.answer_name(part), part.points)
        for problem in problem_set.problems
        if problem.written is not None
        for part in problem.parts
    ]


def _words(problem: Problem) -> bytes:
    """The problem's file, and what it is read in where it is translated."""
    beside = translation(problem)
    return packed_file(problem.path) + (b"" if beside is None else packed_file(beside.path))
