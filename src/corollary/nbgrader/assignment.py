"""A submission that nbgrader's own commands met: whose it is, with which numbers, and what it is marked by."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from datetime import UTC, datetime
from functools import lru_cache
from pathlib import Path

from nbformat import NotebookNode

from corollary.grading.solutions import Solutions
from corollary.grading.submission import GradingContext, Submission, state_by_name, state_of
from corollary.messages import speak
from corollary.notebook.worksheet import Worksheet
from corollary.problem.bank import Bank
from corollary.records.assignments import is_assigned, read_assigned
from corollary.records.deadlines import read_deadlines
from corollary.records.files import Course, open_course, students
from corollary.records.origin import set_of
from corollary.records.regrading import dependencies
from corollary.records.settings import read_settings
from corollary.records.submissions import fingerprint, read_submission, submissions
from corollary.sandbox.notebook import Notebook
from corollary.sandbox.runner import Runner


class NotOnRoster(LookupError):
    """The student was never given any numbers; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Assignment:
    """One submission, with what is needed to mark it; the variants come from the course's record, never from the notebook."""

    course: Course
    submission: Submission
    context: GradingContext

    @property
    def worksheet(self) -> Worksheet:
        """The student's own sheet."""
        return self.context.worksheet(self.submission)

    @property
    def node(self) -> NotebookNode | None:
        """The notebook as it was handed in; None when it cannot be opened."""
        received = self.submission.notebook
        return received.node if isinstance(received, Notebook) else None


def assignment_of(about: Mapping[str, str]) -> Assignment | None:
    """What nbgrader's resources tell of, in the course around the working folder; None when the set is not of ours.

    Raises NotOnRoster, and what reading the course and the set raises.
    """
    here = Path.cwd()
    name, student = about.get("assignment", ""), about.get("student", "")
    if not name or not (here / ".corollary" / "key").is_file():
        return None
    course = open_course(here)
    if not is_assigned(course, name):
        return None
    if code := read_settings(here).language:
        speak(code)
    bank, problem_set = set_of(course, name)
    assigned = read_assigned(course, problem_set)
    who = next((each for each in students(course) if each.id == student), None)
    if who is None or student not in assigned:
        raise NotOnRoster(
            f"{student} handed in {name} but is not on the roster; add them and generate {name} again"
        )
    path = submissions(course, name).get(student, course.notebook("submitted", student, name))
    state = state_of(problem_set, Solutions(bank))
    terms = read_deadlines(course, problem_set).terms(student, datetime.now(UTC))
    digest = fingerprint(course, name, student, path, assigned[student], state, terms)
    submission = read_submission(course, problem_set, who, path, assigned[student], digest, terms)
    by_name = state_by_name(problem_set, Solutions(bank))
    depends = dependencies(course, name, student, path, assigned[student], terms, by_name)
    submission = replace(submission, depends=depends)
    context = GradingContext(problem_set, _solutions(bank, state), course.key, Runner)
    return Assignment(course, submission, context)


@lru_cache(maxsize=4)
def _solutions(bank: Bank, state: str) -> Solutions:
    """One for each state: a process that lives long must not mark by solutions that have changed."""
    return Solutions(bank)
