"""Sheets on paper, with marking schemes; or one problem with its worked solution."""

from __future__ import annotations

from corollary.messages import catalogue
from corollary.notebook.worksheet import Exercise
from corollary.problem.roster import Student
from corollary.render.exports import Target
from corollary.render.paper.print_run import PrintRun
from corollary.render.paper.sheet import numbered_pages, typst_exercise
from corollary.render.paper.typst import pdf, typst_text, words_of

_ = catalogue(__name__)


def write_exercise(exercise: Exercise, student: Student, solution: str) -> bytes:
    """With room to answer; or, where its worked solution is shown, without. Raises CannotTypeset."""
    problem = exercise.problem
    title = f"{problem.code} {problem.title}"
    pieces = [
        f"#heading(level: 1)[{words_of(title)}]",
        f"#text(0.9em)[{words_of(problem.source)}]" if problem.source else "",
        typst_exercise(exercise, room=not solution, level=2),
    ]
    if solution:
        heading = words_of(_("Worked solution"))
        pieces += [f"#heading(level: 2)[{heading}]", typst_text(solution, level=3)]
    return pdf([numbered_pages("exercise", title, "\n\n".join(filter(None, pieces)))], title)


TARGET = Target(ending="pdf", exercise=write_exercise, paper=PrintRun)
