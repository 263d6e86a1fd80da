"""The set in an nbgrader course: what nbgrader's own commands and formgrader then work on, unchanged."""

# pyright: reportUnknownMemberType=false

from __future__ import annotations

from contextlib import redirect_stderr
from datetime import UTC
from io import StringIO
from typing import Any

from nbformat import NotebookNode

from corollary.atomic import write_whole
from corollary.nbgrader.config import write_config
from corollary.nbgrader.corrected import brought_together
from corollary.nbgrader.gradebook import (
    GradebookLocked,
    NotRegistered,
    directory,
    gradebook,
    has_nbgrader,
    need_nbgrader,
    programs_on_path,
)
from corollary.nbgrader.source import source_notebook
from corollary.notebook.notebook import file_text
from corollary.problem.problem_set import ProblemSet
from corollary.records.files import Course, students
from corollary.records.marks import read_records


def register(course: Course, problem_set: ProblemSet, source: NotebookNode, *, agreed: bool = False) -> None:
    """Makes the set an assignment of the course, or brings it up to date: config, source, release, gradebook, students, date.

    Once somebody's work is recorded, parts that are gone stay in it, and what a part is out of follows the set only when the
    marks that this moves are `agreed` to. Raises NoNbgrader, NotOurs, GradebookLocked, and
    NotRegistered when nbgrader refuses.
    """
    need_nbgrader()
    from nbgrader.api import Student

    write_config(course)
    name = problem_set.name
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
        source = brought_together(book, name, source, agreed=agreed)
    write_whole(course.notebook("source", ".", name), file_text(source))
    _generate(course, name)


def follow_points(course: Course, problem_set: ProblemSet) -> None:
    """Once all marks are out of the points of now, so are nbgrader's parts; nothing without nbgrader."""
    if not has_nbgrader():
        return
    from corollary.nbgrader.registered import may_follow_points

    everybody = [student.id for student in students(course)]
    with gradebook(course) as book:
        follows = may_follow_points(
            book, problem_set, lambda: read_records(course, problem_set, everybody).values()
        )
    if follows:
        register(course, problem_set, source_notebook(problem_set), agreed=True)


def _generate(course: Course, name: str) -> None:
    """nbgrader's own generate_assignment, in this process and without its log."""
    from nbgrader.apps import NbGraderAPI

    place = directory(course)
    with programs_on_path(), redirect_stderr(StringIO()):
        result = NbGraderAPI(place, config=place.config).generate_assignment(name)
    if result["success"]:
        return
    log = str(result.get("log", "")) + str(result.get("error", ""))
    if "locked" in log:
        raise GradebookLocked(
            f"{course.gradebook} is locked by another program; close it, and generate again"
        )
    last = next((line for line in reversed(log.splitlines()) if line.strip()), "it gave no reason")
    raise NotRegistered(f"nbgrader could not make the assignment {name}: {last.strip()}")
