"""A problem set made for a roster: variants assigned, one notebook for each student, and the set registered with nbgrader."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from corollary.atomic import write_whole
from corollary.grading.solutions import Solutions
from corollary.nbgrader.gradebook import NoNbgrader, need_nbgrader
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import chapter, size
from corollary.records.assigned import read_assigned, write_assigned, write_origin
from corollary.records.files import Course, create_course
from corollary.records.settings import write_settings

if TYPE_CHECKING:
    from nbformat import NotebookNode

NOBODY = Student("everybody", "Chapter's own", "numbers")


@dataclass(frozen=True, slots=True)
class Generated:
    """What was made: where each student's notebook lies, the indices of their variants by code of the problem, how many
    draws were rejected for each problem, and whether nbgrader knows of the set."""

    course: Course
    notebooks: dict[str, Path]
    assigned: dict[str, dict[str, int]]
    redrawn: dict[str, int]
    registered: bool


def generate(
    folder: Path,
    problem_set: ProblemSet,
    roster: Iterable[Student],
    solutions: Solutions,
    progress: Callable[[str], None] = lambda step: None,
    file: Path | None = None,
) -> Generated:
    """Makes or completes the course; who has numbers keeps them. `file`: the set's, when it lies outside the bank.

    Raises NoVariant, NotRegistered, GradebookLocked, NotOurs.
    """
    roster = tuple(roster)
    course = create_course(folder, roster)
    write_settings(course.folder)
    assigned = read_assigned(course, problem_set.name)
    redrawn: dict[str, int] = {}
    for problem in problem_set.problems:
        progress(f"dealing {problem.code}")
        used = {row[problem.code] for row in assigned.values() if problem.code in row}
        for student in roster:
            row = assigned.setdefault(student.id, {})
            if problem.code not in row and size(problem) > 1:
                found = solutions.assign_variant(problem, course.key, student.id, used)
                assert found.variant.index is not None
                row[problem.code] = found.variant.index
                redrawn[problem.code] = redrawn.get(problem.code, 0) + found.redrawn
                used.add(found.variant.index)
    write_origin(course, problem_set.name, solutions.bank, file)
    write_assigned(course, problem_set.name, assigned)
    registered = _register(course, problem_set, source_notebook(problem_set), progress)
    notebooks: dict[str, Path] = {}
    for student in roster:
        progress(f"notebook of {student.id}")
        variants = problem_set.variants(assigned[student.id])
        path = course.notebook("release", student.id, problem_set.name)
        write_whole(path, file_text(notebook(worksheet(problem_set, student, variants))))
        notebooks[student.id] = path
    of_roster = {student.id: assigned[student.id] for student in roster}
    return Generated(course, notebooks, of_roster, redrawn, registered)


def source_notebook(problem_set: ProblemSet) -> NotebookNode:
    """The notebook that nbgrader knows the set by: with the chapter's own numbers."""
    return notebook(worksheet(problem_set, NOBODY, map(chapter, problem_set.problems)))


def _register(
    course: Course, problem_set: ProblemSet, source: NotebookNode, progress: Callable[[str], None]
) -> bool:
    """Makes the set known to nbgrader, where it is installed; source and release are written in any case."""
    try:
        need_nbgrader()
    except NoNbgrader:
        for step in ("source", "release"):
            write_whole(course.notebook(step, ".", problem_set.name), file_text(source))
        return False
    from corollary.nbgrader.register import register

    progress("registering with nbgrader")
    register(course, problem_set, source)
    return True
