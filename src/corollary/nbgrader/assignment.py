"""A submission that nbgrader's own commands met: whose it is, with which numbers, and what it is marked by."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from nbformat import NotebookNode

from corollary.course.generate import variants_of
from corollary.course.submission import GradingContext, Submission
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import Worksheet, worksheet
from corollary.problem.bank import Bank
from corollary.problem.problem_set import ProblemSet
from corollary.records.course import Course, open_course, read_dealt, students, submissions
from corollary.records.origin import read_origin
from corollary.records.records import fingerprint, lateness
from corollary.sandbox.file import bytes_of
from corollary.sandbox.notebook import Notebook, notebook_of
from corollary.sandbox.runner import Runner


class NotOnRoster(LookupError):
    """The student was never dealt any numbers; one sentence says what to do."""


@dataclass(frozen=True, slots=True)
class Paper:
    """One submission, with what is needed to mark it; the variants come from the course's record, never from the notebook."""

    course: Course
    handed: Submission
    order: GradingContext

    @property
    def worksheet(self) -> Worksheet:
        """The student's own sheet."""
        problem_set = self.order.problem_set
        return worksheet(problem_set, self.handed.student, variants_of(problem_set, dict(self.handed.row)))

    @property
    def node(self) -> NotebookNode | None:
        """The notebook as it was handed in; None when it cannot be opened."""
        content = self.handed.content
        read = notebook_of(content) if isinstance(content, bytes) else content
        return read.node if isinstance(read, Notebook) else None


def paper_of(about: Mapping[str, str]) -> Paper | None:
    """The paper that nbgrader's resources tell of, in the course around the working folder; None when the set is not of ours.

    Raises NotOnRoster, and what reading the course and the set raises.
    """
    here = Path.cwd()
    name, student = about.get("assignment", ""), about.get("student", "")
    if not name or not (here / ".corollary" / "key").is_file():
        return None
    course = open_course(here)
    dealt = read_dealt(course, name)
    if not dealt:
        return None
    who = next((each for each in students(course) if each.id == student), None)
    if who is None or student not in dealt:
        raise NotOnRoster(
            f"{student} handed in {name} but is not on the roster; add them and generate {name} again"
        )
    bank, problem_set = read_origin(course, name)
    path = submissions(course, name).get(student, course.notebook("submitted", student, name))
    solutions = _solved(bank, _state(bank, problem_set))
    stamp = fingerprint(course, problem_set, solutions, student, path, dealt[student])
    handed = Submission(who, bytes_of(path), dealt[student], lateness(course, problem_set, student), stamp)
    return Paper(course, handed, GradingContext(problem_set, solutions, course.key, Runner))


def _state(bank: Bank, problem_set: ProblemSet) -> str:
    """What the problems and solutions are now: a process that lives long must not mark by those it once read."""
    digest, sources = hashlib.sha256(), Solutions(bank)
    for problem in problem_set.problems:
        digest.update(problem.path.read_bytes() + b"\0" + sources.source(problem) + b"\0")
    return digest.hexdigest()


@lru_cache(maxsize=4)
def _solved(bank: Bank, state: str) -> Solutions:
    return Solutions(bank)
