"""The set in an nbgrader gradebook: its notebooks, parts and maxima."""

# pyright: reportReturnType=false, reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import redirect_stderr
from datetime import UTC
from io import StringIO
from typing import TYPE_CHECKING, Any

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
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.records.files import Course, students
from corollary.records.marks import Record, read_records

if TYPE_CHECKING:
    from nbformat import NotebookNode
    from nbgrader.api import Gradebook

NOBODY = Student("everybody", "Chapter's own", "numbers")


def source_notebook(problem_set: ProblemSet) -> NotebookNode:
    """The sheet that is nobody's, with a cell for every part."""
    return notebook(worksheet(problem_set, NOBODY, map(chapter, problem_set.problems)))


# nbgrader declares its tables in the old style, which a type checker takes for columns instead of values.


def is_registered(book: Gradebook, problem_set: ProblemSet) -> bool:
    """Whether the gradebook has the set, with every part of it."""
    return _maxima_now(problem_set).keys() <= _maxima(book, problem_set).keys()


def may_follow_points(
    book: Gradebook, problem_set: ProblemSet, records: Callable[[], Iterable[Record]]
) -> bool:
    """Whether it has parts out of other points than they are out of now, in which all marks recorded are."""
    now = _maxima_now(problem_set)
    return not now.items() <= _maxima(book, problem_set).items() and all(
        part.out_of == now.get(key, part.out_of) for record in records() for key, part in record.parts.items()
    )


def _maxima_now(problem_set: ProblemSet) -> dict[str, float]:
    return {
        problem.answer_name(part): part.points * problem_set.weight(problem)
        for problem in problem_set.problems
        for part in problem.parts
    }


def _maxima(book: Gradebook, problem_set: ProblemSet) -> dict[str, float]:
    """By the part's name in the notebook; empty where the set is not known."""
    from nbgrader.api import MissingEntry

    try:
        notebooks = book.find_assignment(problem_set.name).notebooks
    except MissingEntry:
        return {}
    return {cell.name: cell.max_score for notebook in notebooks for cell in notebook.grade_cells}


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
