"""Markdown with formulas in dollars; figures and pictures come along as references at the end of their exercise."""

from __future__ import annotations

import re
from collections.abc import Mapping

from corollary.messages import catalogue
from corollary.notebook.worksheet import Exercise, Worksheet
from corollary.problem.roster import Student
from corollary.render.exports import Target
from corollary.render.page import drawing_address
from corollary.render.pictures import NAME, lifted
from corollary.render.wording import facts, wanted

_ = catalogue(__name__)
IN_TEXT = re.compile(rf"\]\(({NAME}\w+)\)")


def write_exercise(exercise: Exercise, student: Student, solution: str) -> str:
    return _written(exercise, solution, "#", "figure")


def write_worksheet(sheet: Worksheet, solutions: Mapping[str, str]) -> str:
    about = sheet.problem_set
    pieces = [f"# {about.title}", " · ".join(facts(sheet)), about.introduction]
    for exercise in sheet.exercises:
        code = exercise.problem.code
        pieces.append(_written(exercise, solutions.get(code, ""), "##", f"figure {code}").rstrip("\n"))
    return "\n\n".join(filter(None, pieces)) + "\n"


def _written(exercise: Exercise, solution: str, level: str, label: str) -> str:
    """`label` names the figure: two references of one file must not share theirs."""
    problem = exercise.problem
    pieces = [f"{level} {problem.code} {problem.title}", exercise.statement]
    if exercise.figure:
        alt = exercise.figure_alt.replace("[", r"\[").replace("]", r"\]")
        pieces.append(f"![{alt}][{label}]")
    for prompt in exercise.prompts:
        pieces += [f"{level}# ({prompt.part.heading_letter}) {prompt.part.title}", prompt.text]
        pieces.append("\n".join(f"- ({option.mark}) {option.text}" for option in prompt.options))
        pieces.append(f"*{wanted(prompt)}*")
    if solution:
        pieces += [f"{level}# " + _("Worked solution"), solution]
    words = lifted("\n\n".join(filter(None, pieces)))
    text = IN_TEXT.sub(r"][\1]", words.text)
    text = "\n\n".join([text, *(f"[{name}]: {address}" for name, address in words.addresses.items())])
    if exercise.figure:
        text += f"\n\n[{label}]: {drawing_address(exercise)}"
    return text + "\n"


TARGET = Target(ending="md", exercise=write_exercise, worksheet=write_worksheet)
