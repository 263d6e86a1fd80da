"""The set in an nbgrader gradebook: its notebooks, parts and maxima."""

# pyright: reportArgumentType=false, reportAttributeAccessIssue=false, reportCallIssue=false, reportReturnType=false, reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import redirect_stderr
from copy import deepcopy
from datetime import UTC
from io import StringIO
from typing import TYPE_CHECKING, Any

from nbformat import NotebookNode

from corollary.atomic import write_whole
from corollary.nbgrader.config import write_config
from corollary.nbgrader.gradebook import (
    GradebookLocked,
    NotRegistered,
    directory,
    gradebook,
    has_nbgrader,
    need_nbgrader,
    programs_on_path,
)
from corollary.notebook.cells import answer_cell, graded_cell, written_cell
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import chapter
from corollary.records.files import Course, students
from corollary.records.marks import Record, read_records

if TYPE_CHECKING:
    from nbformat import NotebookNode
    from nbgrader.api import Gradebook, Notebook

# nbgrader declares its tables in the old style, which a type checker takes for columns instead of values.


GONE = "This part was removed; marks given for it stay."


def brought_together(
    book: Gradebook, set_name: str, source: NotebookNode, *, agreed: bool = False
) -> NotebookNode:
    """The source with the cells of parts that are gone, once the gradebook has the cells of those that are new; parts are out of
    what the gradebook has them out of, or of what they are out of now if that is `agreed` to.

    As it is when nothing has been handed in: then nbgrader makes its cells anew itself.
    """
    from nbgrader.api import MissingEntry

    try:
        notebook = book.find_notebook(set_name, set_name)
    except MissingEntry:
        return source
    if not notebook.submissions:
        return source
    _add_new(book, notebook, source)
    return _with_gone(notebook, source if agreed else _as_agreed(notebook, source))


def _add_new(book: Gradebook, notebook: Notebook, source: NotebookNode) -> None:
    """Cells of new parts, with a row for everybody whose work is recorded."""
    from nbgrader.api import Comment, Grade, GradeCell, SolutionCell, SourceCell

    grades, solutions, sources = (
        {cell.name: cell for cell in cells}
        for cells in (notebook.grade_cells, notebook.solution_cells, notebook.source_cells)
    )
    marks = {cell.id: (cell, cell.metadata["nbgrader"]) for cell in source.cells}
    for name, (cell, mark) in marks.items():
        if mark["grade"] and name not in grades:
            new = GradeCell(
                name=name, notebook=notebook, cell_type=cell.cell_type, max_score=float(mark["points"])
            )
            book.db.add_all([new, *(Grade(cell=new, notebook=each) for each in notebook.submissions)])
        if mark["solution"] and name not in solutions:
            new = SolutionCell(name=name, notebook=notebook)
            book.db.add_all([new, *(Comment(cell=new, notebook=each) for each in notebook.submissions)])
        if name not in sources:
            book.db.add(
                SourceCell(name=name, notebook=notebook, cell_type=cell.cell_type, locked=mark["locked"])
            )
    for name, cell in sources.items():
        if name not in marks and name not in grades and name not in solutions:
            book.db.delete(cell)  # words only: a figure that is gone, a question
    book.db.commit()


def _as_agreed(notebook: Notebook, source: NotebookNode) -> NotebookNode:
    maxima, found = {cell.name: cell.max_score for cell in notebook.grade_cells}, deepcopy(source)
    for cell in found.cells:
        mark = cell.metadata["nbgrader"]
        if mark["grade"]:
            mark["points"] = maxima.get(cell.id, mark["points"])
    return found


def _with_gone(notebook: Notebook, source: NotebookNode) -> NotebookNode:
    here = {cell.id for cell in source.cells}
    solutions = {cell.name for cell in notebook.solution_cells}
    graded = {cell.name: cell for cell in notebook.grade_cells}
    gone: list[NotebookNode] = [
        answer_cell(name, "") for name in sorted(solutions) if name not in here and name not in graded
    ]
    for name, cell in graded.items():
        if name not in here and name in solutions:
            gone.append(written_cell(name, GONE, cell.max_score))
        elif name not in here:
            gone.append(graded_cell(name, f"# {GONE}", cell.max_score))
    return NotebookNode(source | {"cells": [*source.cells, *gone]})


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
