"""The figure of a problem, with numbers in its holes: a drawing that can stand in every page."""

from __future__ import annotations

from corollary.figure.svg import NotADrawing, safe_svg
from corollary.problem.problem import Problem
from corollary.problem.statement import filled
from corollary.problem.variant import chapter
from corollary.verify.checked import Tally


def check_figure(problem: Problem, tally: Tally) -> None:
    """Whether the chapter's own figure can be shown."""
    if not problem.figure:
        return
    try:
        safe_svg(filled(problem.figure, chapter(problem)))
    except NotADrawing as error:
        tally.complain(f"{problem.path.name}:{problem.figure_line}: the figure cannot be shown: {error}")
    tally.count("figures")
