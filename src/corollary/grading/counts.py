"""Counts: parts whose answer is a whole number, which nobody rounds."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.derive.solution import ClosedForms, Solution, Unknown, once
from corollary.formula.ast import Expr, Name, Negative, Number, Product, Sum, children, names
from corollary.formula.ball import RationalPi
from corollary.formula.exact import exactly
from corollary.problem.given import Given
from corollary.problem.part import Part
from corollary.problem.sampling import sample

TRIED = 40  # draws for which a formula of counts must give a whole number: halves show in one of two


def is_counted(solution: Solution, place: int, part: Part, known: Mapping[str, RationalPi]) -> bool:
    """True if the part at a place asks for a `.count`, or its steps make whole numbers of whole numbers, for all draws and these.

    `known` are the values of all letters. A ratio that comes out whole is none where its steps have other numbers in them; of several
    components each has to be one.
    """
    if part.answer_type == "count":
        return True
    if part.unit.text != "1" or not _whole_by_its_steps(solution, place):
        return False
    used = frozenset[str]().union(*map(names, solution.unknowns[place].in_givens or ()))
    return all(_is_whole(known[name]) for name in used if name in known)


@once
def _whole_by_its_steps(solution: Solution, place: int) -> bool:
    problem, find = solution.problem, solution.unknowns[place]
    trees = find.in_givens or ()
    used = frozenset[str]().union(*map(names, trees))
    if not all(names(tree) or _is_stated(name, find) for name, tree in zip(find.names, trees, strict=True)):
        return False
    counts = {given.symbol for given in problem.givens if _counts(given)}
    for each in solution.unknowns[: place + 1]:
        local = each.local.trees if isinstance(each.local, ClosedForms) else ()
        if local and all(names(tree) <= counts for tree in local):
            counts |= set(each.names)
    if not trees or not used <= counts or not counts.issuperset(find.names):
        return False
    found = (exactly(tree, draw.exact) for draw in sample(problem, TRIED, salt="counts") for tree in trees)
    return all(value is not None and _is_whole(value) for value in found)


def _is_stated(name: str, find: Unknown) -> bool:
    """True if a law says of a letter, whatever the numbers, how many there are: `N = 2*2`, and not what a ratio comes to."""
    stated = (relation for law in find.laws for relation in law.here if relation.left == Name(name))
    return any(_is_counting(relation.right) for relation in stated)


def _is_counting(tree: Expr) -> bool:
    match tree:
        case Number(value):
            return value.denominator == 1
        case Sum() | Product() | Negative():
            return all(map(_is_counting, children(tree)))
        case _:
            return False


def _counts(given: Given) -> bool:
    """True if a given is a plain whole number whatever is drawn."""
    ends = (given.value, given.grid.first, given.grid.step, *given.grid.values)
    return given.unit.text == "1" and not given.words and all(each.denominator == 1 for each in ends)


def _is_whole(value: RationalPi) -> bool:
    return not value.pi and value.ratio.denominator == 1
