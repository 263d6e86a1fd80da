"""A problem set made for a roster: variants dealt, one notebook for each student, and the set registered with nbgrader."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path

from corollary.grading.solutions import Solutions
from corollary.nbgrader.gradebook import NoNbgrader, need_nbgrader
from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import worksheet
from corollary.problem.problem import Problem
from corollary.problem.problem_set import ProblemSet
from corollary.problem.roster import Student
from corollary.problem.variant import Variant, at, chapter, size
from corollary.records.course import Course, create_course, read_dealt, write_atomically, write_dealt
from corollary.records.origin import write_origin

NOBODY = Student("everybody", "Chapter's own", "numbers")


@dataclass(frozen=True, slots=True)
class Generated:
    """What was made: where each student's notebook lies, their variants, how many draws were passed over, and if nbgrader knows of it."""

    course: Course
    sheets: dict[str, Path]
    dealt: dict[str, dict[str, int]]
    passed_over: dict[str, int]
    registered: bool


def generate(
    folder: Path, problem_set: ProblemSet, roster: Iterable[Student], solutions: Solutions,
    tell: Callable[[str], None] = lambda step: None, file: Path | None = None,
) -> Generated:  # fmt: skip
    """Makes or completes the course; who has been dealt numbers keeps them. `file`: the set's, when it lies outside the bank.

    Raises NoVariant, NotRegistered, GradebookLocked, NotOurs.
    """
    roster = tuple(roster)
    course = create_course(folder, roster)
    before = read_dealt(course, problem_set.name)
    dealt: dict[str, dict[str, int]] = {student: dict(row) for student, row in before.items()}
    passed: dict[str, int] = {}
    for problem in problem_set.problems:
        tell(f"dealing {problem.code}")
        taken = {row[problem.code] for row in dealt.values() if problem.code in row}
        for student in roster:
            row = dealt.setdefault(student.id, {})
            if problem.code not in row and size(problem) > 1:
                found = solutions.assign_variant(problem, course.key, student.id, taken)
                assert found.variant.index is not None
                row[problem.code] = found.variant.index
                passed[problem.code] = passed.get(problem.code, 0) + found.passed_over
                taken.add(found.variant.index)
    write_origin(course, problem_set.name, solutions.bank, file)
    write_dealt(course, problem_set.name, dealt)
    own = worksheet(problem_set, NOBODY, map(chapter, problem_set.problems))
    registered = _register(course, problem_set, notebook(own), tell)
    sheets = {}
    for student in roster:
        tell(f"notebook of {student.id}")
        path = course.notebook("release", student.id, problem_set.name)
        write_atomically(
            path,
            file_text(notebook(worksheet(problem_set, student, variants_of(problem_set, dealt[student.id])))),
        )
        sheets[student.id] = path
    return Generated(
        course, sheets, {student.id: dealt[student.id] for student in roster}, passed, registered
    )


def variants_of(problem_set: ProblemSet, row: dict[str, int]) -> list[Variant]:
    """A student's variants from the record of what was dealt."""
    return [variant_of(problem, row) for problem in problem_set.problems]


def variant_of(problem: Problem, row: dict[str, int]) -> Variant:
    return at(problem, row[problem.code]) if problem.code in row else chapter(problem)


def _register(course: Course, problem_set: ProblemSet, source, tell: Callable[[str], None]) -> bool:
    """Makes the set known to nbgrader, where it is installed; source and release are written in any case."""
    try:
        need_nbgrader()
    except NoNbgrader:
        for step in ("source", "release"):
            write_atomically(course.notebook(step, ".", problem_set.name), file_text(source))
        return False
    from corollary.nbgrader.register import register

    tell("registering with nbgrader")
    register(course, problem_set, source)
    return True
