"""Plain text for a terminal: formulas in a line, the figure in words."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.messages import catalogue
from corollary.notebook.worksheet import Exercise, Worksheet
from corollary.problem.roster import Student
from corollary.render.exports import Target
from corollary.render.terminal_text import terminal_text
from corollary.render.wording import facts, wanted

_ = catalogue(__name__)
WIDTH = 80


def write_exercise(exercise: Exercise, student: Student, solution: str) -> str:
    problem = exercise.problem
    pieces = [f"{problem.code}  {problem.title}", terminal_text(exercise.statement, width=WIDTH)]
    if exercise.figure:
        pieces.append(terminal_text(_("[Figure: {alt}]", alt=exercise.figure_alt), width=WIDTH))
    for prompt in exercise.prompts:
        heading = f"({prompt.part.heading_letter}) {terminal_text(prompt.part.title)}  [{wanted(prompt)}]"
        options = "\n".join(
            terminal_text(f"- ({option.mark}) {option.text}", width=WIDTH) for option in prompt.options
        )
        pieces.append("\n".join(filter(None, (heading, terminal_text(prompt.text, width=WIDTH), options))))
    if solution:
        pieces += [_("Worked solution"), terminal_text(solution, width=WIDTH)]
    return "\n\n".join(filter(None, pieces)) + "\n"


def write_worksheet(sheet: Worksheet, solutions: Mapping[str, str]) -> str:
    about = sheet.problem_set
    pieces = [
        about.title,
        " · ".join(facts(sheet)),
        terminal_text(about.introduction, width=WIDTH),
        *(
            write_exercise(exercise, sheet.student, solutions.get(exercise.problem.code, "")).rstrip("\n")
            for exercise in sheet.exercises
        ),
    ]
    return "\n\n\n".join(filter(None, pieces)) + "\n"


TARGET = Target(ending="txt", exercise=write_exercise, worksheet=write_worksheet)
