"""The forces on a body as a worked solution tells them: each by its name, with its direction and its magnitude."""

from __future__ import annotations

from collections.abc import Iterator

from corollary.answers.spellings import main_spelling
from corollary.answers.ways import in_words
from corollary.derive.solution import SolvedForces
from corollary.formula.ast import Expr
from corollary.formula.latex import latex
from corollary.messages import catalogue
from corollary.problem.part import Part

_ = catalogue(__name__)


def listed_forces(stated: SolvedForces, part: Part) -> Iterator[str]:
    """A line of a Markdown list for each force that acts, magnitudes and angles in givens."""
    names = {option.letter: main_spelling(option.text) for option in part.options}
    for each in stated.forces:
        assert isinstance(each.way, Expr)  # once solved
        way = (
            in_words(each.word)
            if each.word
            else _("at {angle}, counter-clockwise from the right", angle=f"${latex(each.way)}$")
        )
        yield f"- {names[each.letter]}, {way}: ${latex(each.magnitude)}$"
