"""What the letters of a worked solution stand for: the givens that occur in it, by their meanings."""

from __future__ import annotations

from itertools import chain

from corollary.derive.solution import Solution
from corollary.formula.ast import names
from corollary.formula.latex import letter
from corollary.messages import catalogue
from corollary.problem.problem import Problem

_ = catalogue(__name__)


def introduced(solution: Solution, problem: Problem) -> list[str]:
    """A line that names them, and an empty one; constants of nature have a line of their own. `problem` is in the language spoken."""
    found = solution.unknowns
    laws = chain.from_iterable(each.laws for each in found)
    used = frozenset[str]().union(*(names(relation) for law in laws for relation in law.here))
    used |= frozenset[str]().union(*(names(tree) for each in found for tree in each.in_givens or ()))
    letters = [
        f"${letter(given.symbol)}$ ({given.meaning})"
        for given in problem.givens
        if given.symbol in used and given.meaning and not given.source
    ]
    return [_("*Letters:* {letters}.", letters=", ".join(letters)), ""] if letters else []
