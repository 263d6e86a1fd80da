"""The variants of a problem as its author looks at them, with what stands in the way of showing them."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from markupsafe import Markup

from corollary.derive.load import NotDerivable
from corollary.figure.svg import NotADrawing
from corollary.grading.replay import forget_scenes
from corollary.grading.solutions import Solutions
from corollary.notebook.worksheet import exercise
from corollary.problem.bank import Bank
from corollary.problem.diagnostic import Malformed
from corollary.problem.reader import read_problem
from corollary.problem.variant import chapter
from corollary.render.page import drawing
from corollary.render.preview_page import Sheet, variants_piece
from corollary.verify.drawn import Draw, drawn, keyed_parts

DRAWS = 20


def rendered_variants(place: Bank, path: Path) -> str:
    """A piece of HTML: twenty variants of the problem as the files are now, or what it asks where it is not solved.

    Empty where not even that can be read. `verify` names what is wrong.
    """
    forget_scenes()
    try:
        problem = read_problem(path)
    except Malformed:
        return ""
    draws, redrawn, advice = [Draw(chapter(problem), None, "")], 0, ""
    solutions = Solutions(place)
    with suppress(NotDerivable):  # then at least what the problem asks is shown
        found = drawn(solutions.of(problem), DRAWS)
        draws, redrawn, advice = found.draws, found.redrawn, found.advice
    heading = f"{problem.code} {problem.title}"
    return variants_piece(heading, [_sheet(solutions, each) for each in draws], redrawn, advice)


def _sheet(solutions: Solutions, draw: Draw) -> Sheet:
    asked, figure = exercise(draw.variant), Markup()
    with suppress(NotADrawing):
        figure = drawing(asked)
    if draw.key is None:
        return Sheet(draw, asked, figure, (), "")
    return Sheet(draw, asked, figure, tuple(keyed_parts(draw.key)), solutions.worked_solution_of(draw.key))
