"""The verdict on formulas: decided at random points of the problem's own domain, never by their looks."""

from __future__ import annotations

from collections.abc import Mapping

from corollary.answers.answer import Formulas, Numbers
from corollary.answers.equality import Different, Equal, Undecided, compare, hint
from corollary.answers.registry import answer_type
from corollary.answers.verdict import Follows, Mistaken, Right, Slip, Unmarked, Verdict, Wrong
from corollary.derive.solution import ClosedForms, Rule
from corollary.formula.ast import Expr, Name, Number, names, substitute, walk
from corollary.formula.ball import RationalPi, Undefined, certified
from corollary.formula.degrees import in_degrees
from corollary.grading.closeness import within
from corollary.grading.key import Key
from corollary.grading.numbers import judge_numbers
from corollary.grading.replay import Values, ancestors, number
from corollary.problem.part import Part
from corollary.problem.problem import Problem

EXACTLY = 1e-6


def judge_formulas(key: Key, part: Part, answer: Formulas, earlier: Mapping[str, Values]) -> Verdict:
    """Component by component against the closed form, by its value where numbers stand in it, then against the known mistakes."""
    truth = key.truths[part.id]
    closed = key.find(truth).closed
    if closed is None:
        return Unmarked("This answer has no closed form to compare a formula with; a person will look at it.")
    where = domain(key.variant.problem)
    found = [compare(tree, wanted, where) for tree, wanted in zip(answer.trees, closed, strict=True)]
    if all(isinstance(each, Equal) for each in found):
        return Right()
    if any(isinstance(each, Undecided) for each in found):
        return Unmarked(
            "The machine can neither show that this formula is right nor that it is wrong; a person will look at it."
        )
    if (
        not answer_type(part.kind).in_symbols
        and (verdict := _by_value(key, part, answer, closed, earlier)) is not None
    ):
        return verdict
    for wrong, said in wrong_forms(key, truth.place):
        if all(
            isinstance(compare(tree, other, where), Equal)
            for tree, other in zip(answer.trees, wrong, strict=True)
        ):
            return Mistaken(said)
    first = next(each for each in found if isinstance(each, Different))
    if said := hint(first):
        return Slip(f"{said[0].upper()}{said[1:]}.")
    point = ", ".join(f"{name} = {value:.4g}" for name, value in sorted(first.point.items()))
    return Wrong(f"For example at {point} (SI) it gives something else than the laws do.")


def _by_value(
    key: Key, part: Part, answer: Formulas, closed: tuple[Expr, ...], earlier: Mapping[str, Values]
) -> Verdict | None:
    """Right where only some letters were put in as numbers, or where it follows from earlier answers; else None."""
    if all(names(mine) <= names(wanted) | {"pi"} for mine, wanted in zip(answer.trees, closed, strict=True)):
        return _numbers_put_in(key, part, answer, closed)
    values = values_of(key, answer)
    verdict = judge_numbers(key, part, _said(values, answer), earlier) if values is not None else None
    return verdict if isinstance(verdict, Follows) else None


def _numbers_put_in(key: Key, part: Part, answer: Formulas, closed: tuple[Expr, ...]) -> Right | None:
    """`m v cos(30°)`, `L/9`: right when the letters left out were put in as numbers, exactly or as decimals."""
    if not any(
        names(wanted) - names(mine) - {"pi"} for mine, wanted in zip(answer.trees, closed, strict=True)
    ):
        return None
    decimals = any(isinstance(node, Number) and node.figures for tree in answer.trees for node in walk(tree))
    truth = key.truths[part.id]
    for trees in (answer.trees, tuple(map(in_degrees, answer.trees))):
        values = values_of(key, Formulas(trees, answer.shown))
        if values is None or not (decimals or within(values, truth.values, EXACTLY, truth.scale)):
            continue
        if isinstance(judge_numbers(key, part, _said(values, answer), {}), Right):
            return Right("" if trees == answer.trees else "Right. (Write 30° where degrees are meant.)")
    return None


def _said(values: Values, answer: Formulas) -> Numbers:
    return Numbers(values, (0,) * len(values), answer.shown)


def values_of(key: Key, answer: Formulas) -> Values | None:
    """What the student's formulas come to with the variant's numbers; None where they have no value."""
    try:
        return tuple(number(tree, key.variant.exact) for tree in answer.trees)
    except Undefined:
        return None


def wrong_forms(key: Key, place: int) -> list[tuple[tuple[Expr, ...], str]]:
    """ClosedForms forms of a find by each known mistake, at its own step and at the steps nobody was asked about."""
    solution = key.solution
    forms = []
    for at in sorted(ancestors(solution, place) | {place}, reverse=True):
        for wrong in solution.finds[at].mistakes:
            closed = _closed(key, place, at, wrong.rule)
            if closed is not None:
                forms.append((closed, wrong.text))
    return forms


def _closed(key: Key, place: int, at: int, rule: Rule) -> tuple[Expr, ...] | None:
    """The find at `place` in givens alone, when the rule at `at` is exchanged."""
    meaning: dict[str, Expr] = {}
    for index, find in enumerate(key.solution.finds[: place + 1]):
        local = rule if index == at else find.local
        if not isinstance(local, ClosedForms):
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
        ends = (
            RationalPi(value * given.unit.factor, given.unit.pi)
            for value in (given.grid.first, given.grid.last)
        )
        low, high = sorted(certified(Name("x"), {"x": end}).value for end in ends)
        if low == high:
            low, high = sorted((0.9 * low, 1.1 * high))
        box[given.symbol] = low, high
    return box
