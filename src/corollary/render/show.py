"""One exercise as a student sees it: on a terminal, as Markdown, as a page."""

from __future__ import annotations

from corollary.answers.registry import answer_type
from corollary.notebook.worksheet import Exercise
from corollary.problem.part import Part
from corollary.render.drawing import drawing, drawing_address
from corollary.render.page import page, points
from corollary.render.plain_text import plain
from corollary.units.unit import show


def show_text(exercise: Exercise, solution: str | None = None, *, width: int = 80) -> str:
    """The exercise in plain text; formulas in a line, the figure in words."""
    problem = exercise.problem
    pieces = [f"{problem.code}  {problem.title}", plain(exercise.statement, width=width)]
    if exercise.figure:
        pieces.append(plain(f"[Figure: {exercise.figure_alt}]", width=width))
    for prompt in exercise.prompts:
        heading = f"({prompt.part.id}) {plain(prompt.part.title)}  [{_earns(prompt.part, prompt.out_of)}]"
        options = "\n".join(
            plain(f"- ({option.letter}) {option.text}", width=width) for option in prompt.options
        )
        pieces.append("\n".join(filter(None, (heading, plain(prompt.text, width=width), options))))
    if solution:
        pieces += ["Worked solution", plain(solution, width=width)]
    return "\n\n".join(filter(None, pieces)) + "\n"


def show_markdown(exercise: Exercise, solution: str | None = None) -> str:
    """The exercise as Markdown with formulas in dollars; the figure comes along as a reference at the end."""
    problem = exercise.problem
    pieces = [f"# {problem.code} {problem.title}", exercise.statement]
    if exercise.figure:
        alt = exercise.figure_alt.replace("[", r"\[").replace("]", r"\]")
        pieces.append(f"![{alt}][figure]")
    for prompt in exercise.prompts:
        pieces += [f"## ({prompt.part.id}) {prompt.part.title}", prompt.text]
        pieces.append("\n".join(f"- ({option.letter}) {option.text}" for option in prompt.options))
        pieces.append(f"*{_earns(prompt.part, prompt.out_of)}*")
    if solution:
        pieces += ["## Worked solution", solution]
    if exercise.figure:
        pieces.append(f"[figure]: {drawing_address(exercise)}")
    return "\n\n".join(filter(None, pieces)) + "\n"


def show_html(exercise: Exercise, solution: str | None = None) -> str:
    """The exercise as a page of HTML that needs nothing beside it."""
    return page(
        "exercise.html",
        title=f"{exercise.problem.code} {exercise.problem.title}",
        exercise=exercise,
        drawing=drawing(exercise),
        earns={prompt.part.id: _earns(prompt.part, prompt.out_of) for prompt in exercise.prompts},
        solution=solution,
    )


def _earns(part: Part, out_of: float) -> str:
    """Points, and what is to be given: the unit, the components, the function."""
    said = [f"{points(out_of)} point{'s' * (out_of != 1)}"]
    if unit := show(part.unit):
        said.append(f"in {unit}")
    if part.components and answer_type(part.kind).lists_components:
        said.append(f"as {', '.join(part.components)}")
    if part.signature:
        said.append(f"a function {part.signature}")
    return ", ".join(said)
