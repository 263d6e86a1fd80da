"""The verdict on formulas: decided at random points of the problem's own domain, never by their looks."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.derive.solution import Formulas as Closed
from corollary.derive.solution import Rule
from corollary.kind.answer import Formulas
from corollary.kind.equality import Different, Equal, Undecided, compare, hint
from corollary.mark.key import Key
from corollary.mark.replay import Numbers, ancestors, number
from corollary.mark.verdict import Mistaken, Right, Slip, Unmarked, Verdict, Wrong
from corollary.problem.part import Part
from corollary.problem.problem import Problem
from corollary.quantity.ball import Exactly, Undefined, certified
from corollary.quantity.tree import Name, Tree, substitute


def judge_formulas(key: Key, part: Part, answer: Formulas) -> Verdict:
    """Component by component against the closed form, then against what each known mistake makes of it."""
    truth = key.truths[part.id]
    closed = key.find(truth).closed
    if closed is None:
        return Unmarked("This answer has no closed form to compare a formula with; a person will look at it.")
    where = domain(key.variant.problem)
    found = [compare(tree, wanted, where) for tree, wanted in zip(answer.trees, closed, strict=True)]
    if all(isinstance(each, Equal) for each in found):
        return Right()
    if any(isinstance(each, Undecided) for each in found):
        return Unmarked("The machine can neither show that this formula is right nor that it is wrong; a person will look at it.")
    for wrong, said in wrong_forms(key, truth.place):
        if all(isinstance(compare(tree, other, where), Equal) for tree, other in zip(answer.trees, wrong, strict=True)):
            return Mistaken(said)
    first = next(each for each in found if isinstance(each, Different))
    if said := hint(first):
        return Slip(f"{said[0].upper()}{said[1:]}.")
    point = ", ".join(f"{name} = {value:.4g}" for name, value in sorted(first.point.items()))
    return Wrong(f"For example at {point} (SI) it gives something else than the laws do.")


def values_of(key: Key, answer: Formulas) -> Numbers | None:
    """What the student's formulas come to with the variant's numbers; None where they have no value."""
    try:
        return tuple(number(tree, key.variant.exact) for tree in answer.trees)
    except Undefined:
        return None


def wrong_forms(key: Key, place: int) -> list[tuple[tuple[Tree, ...], str]]:
    """Closed forms of a find by each known mistake, at its own step and at the steps nobody was asked about."""
    solution = key.solution
    forms = []
    for at in sorted(ancestors(solution, place) | {place}, reverse=True):
        for wrong in solution.finds[at].mistakes:
            closed = _closed(key, place, at, wrong.rule)
            if closed is not None:
                forms.append((closed, wrong.text))
    return forms


def _closed(key: Key, place: int, at: int, rule: Rule) -> tuple[Tree, ...] | None:
    """The find at `place` in givens alone, when the rule at `at` is exchanged."""
    meaning: dict[str, Tree] = {}
    for index, find in enumerate(key.solution.finds[: place + 1]):
        local = rule if index == at else find.local
        if not isinstance(local, Closed):
            return None
        trees = tuple(substitute(tree, meaning) for tree in local.trees)
        if index == place:
            return trees
        meaning |= dict(zip(find.names, trees, strict=True))
    return None


def domain(problem: Problem) -> Mapping[str, tuple[float, float]]:
    """Where the problem's letters live: the grid of each given, in SI; one that is fixed is widened by a tenth."""
    box = {}
    for given in problem.givens:
        ends = (Exactly(value * given.unit.factor, given.unit.pi) for value in (given.grid.first, given.grid.last))
        low, high = sorted(certified(Name("x"), {"x": end}).value for end in ends)
        if low == high:
            low, high = sorted((0.9 * low, 1.1 * high))
        box[given.symbol] = low, high
    return box
