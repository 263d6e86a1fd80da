"""The notebook that a student answers in; it holds no worked solution."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.notebook.notebook import file_text, notebook
from corollary.notebook.worksheet import Exercise, Worksheet, worksheet
from corollary.problem.problem_set import ProblemSet, Scheme
from corollary.problem.roster import Student
from corollary.render.exports import Target


def write_exercise(exercise: Exercise, student: Student, solution: str) -> str:
    problem = exercise.problem
    alone = ProblemSet(problem.name, problem.title, "", (problem,), (1.0,), None, Scheme(), "no")
    return write_worksheet(worksheet(alone, student, [exercise.variant]), {})


def write_worksheet(sheet: Worksheet, solutions: Mapping[str, str]) -> str:
    return file_text(notebook(sheet))


TARGET = Target(ending="ipynb", exercise=write_exercise, worksheet=write_worksheet)
