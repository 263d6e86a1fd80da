"""The set and its marks in an nbgrader course: what nbgrader's own commands and formgrader then work on, unchanged."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import redirect_stderr
from datetime import UTC
from io import StringIO
from typing import Any

from nbformat import NotebookNode

from corollary.atomic import write_whole
from corollary.grading.grade import Marked
from corollary.nbgrader.config import NotOurs, write_config
from corollary.nbgrader.gradebook import (
    GradebookLocked,
    NoNbgrader,
    NotRegistered,
    directory,
    gradebook,
    need_nbgrader,
    programs_on_path,
)
from corollary.nbgrader.marked_notebook import marked_notebook, notebook_text
from corollary.nbgrader.record import record_one
from corollary.notebook.notebook import file_text
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course, students

__all__ = ["GradebookLocked", "NoNbgrader", "NotOurs", "NotRegistered", "manual_scores", "record", "register"]


def register(course: Course, problem_set: ProblemSet, source_notebook: NotebookNode) -> None:
    """Makes the set an assignment of the course, or brings it up to date: config, source, release, gradebook, students, date.

    Raises NoNbgrader, NotOurs, GradebookLocked, and NotRegistered when nbgrader refuses (parts added or removed after
    somebody's work was recorded).
    """
    need_nbgrader()
    from nbgrader.api import Student

    write_config(course)
    name = problem_set.name
    write_whole(course.notebook("source", ".", name), file_text(source_notebook))
    with gradebook(course) as book:
        due = None if problem_set.due is None else problem_set.due.astimezone(UTC).replace(tzinfo=None)
        about_set: dict[str, Any] = {"duedate": due, "course_id": book.course_id}
        book.update_or_create_assignment(name, **about_set)
        for each in students(course):
            about = {
                "first_name": each.first_name or None,
                "last_name": each.last_name or None,
                "email": each.email or None,
            }
            book.db.merge(Student(id=each.id, **about))
        book.db.commit()
    _generate(course, name)


def _generate(course: Course, name: str) -> None:
    """nbgrader's own generate_assignment, in this process and without its chatter."""
    from nbgrader.apps import NbGraderAPI

    place = directory(course)
    with programs_on_path(), redirect_stderr(StringIO()):
        told = NbGraderAPI(place, config=place.config).generate_assignment(name)
    if told["success"]:
        return
    log = str(told.get("log", "")) + str(told.get("error", ""))
    if "locked" in log:
        raise GradebookLocked(
            f"{course.gradebook} is locked by another program; close it, and generate again"
        )
    if "Cannot add or remove cells" in log:
        raise NotRegistered(
            f"parts of {name} were added or removed, but work on it is in the gradebook already; give the changed set a new name"
        )
    last = next((line for line in reversed(log.splitlines()) if line.strip()), "it gave no reason")
    raise NotRegistered(f"nbgrader could not make the assignment {name}: {last.strip()}")


def record(
    course: Course,
    problem_set: ProblemSet,
    marked: Iterable[Marked],
    notebooks: Mapping[str, NotebookNode | None],
) -> None:
    """Puts marks into the gradebook and marked notebooks into `autograded/`, one student after the other.

    `notebooks` holds what each student handed in (None, or missing, when it could not be opened). Scores and comments given
    by a person are kept. Raises NoNbgrader, NotRegistered, GradebookLocked; whoever was recorded before stays recorded.
    """
    with gradebook(course) as book:
        for one in marked:
            text = notebook_text(marked_notebook(one, problem_set, notebooks.get(one.student.id)))
            record_one(course, book, problem_set, one, text)


def manual_scores(course: Course, set_name: str) -> dict[str, dict[str, float]]:
    """What people gave: student -> key of the part -> points. Raises NoNbgrader, NotRegistered, GradebookLocked."""
    given: dict[str, dict[str, float]] = {}
    with gradebook(course) as book:
        for submission in book.assignment_submissions(set_name):
            scores = {
                grade.name: grade.manual_score
                for notebook in submission.notebooks
                for grade in notebook.grades
                if grade.manual_score is not None
            }
            if scores:
                given[submission.student.id] = scores
    return given
