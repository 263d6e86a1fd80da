"""A page of HTML that needs nothing beside it."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.messages import spoken
from corollary.notebook.worksheet import Exercise, Worksheet
from corollary.problem.roster import Student
from corollary.render.exports import Target
from corollary.render.page import drawing, page
from corollary.render.wording import facts, wanted


def write_exercise(exercise: Exercise, student: Student, solution: str) -> str:
    problem = exercise.problem
    return page(
        "exercise.html",
        lang=spoken(),
        title=f"{problem.code} {problem.title}",
        exercise=exercise,
        drawing=drawing(exercise),
        wanted=wanted,
        solution=solution,
    )


def write_worksheet(sheet: Worksheet, solutions: Mapping[str, str]) -> str:
    return page(
        "worksheet.html",
        lang=spoken(),
        title=sheet.problem_set.title,
        problem_set=sheet.problem_set,
        exercises=sheet.exercises,
        facts=facts(sheet),
        drawing=drawing,
        wanted=wanted,
        solutions=solutions,
    )


TARGET = Target(ending="html", exercise=write_exercise, worksheet=write_worksheet)
