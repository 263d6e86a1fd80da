"""Claims that no mistake looks like the truth, and that no two mistakes of a step give the same."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations

from corollary.derive.solution import ClosedForms, Rule, Solution
from corollary.formula.ast import Expr, Negative, Number, Power, Product, Relation, Sum, substitute
from corollary.grading.assign import APART, visible_mistakes
from corollary.grading.replay import ancestors
from corollary.grading.rounding import MOST
from corollary.verify.obligations.obligation import Clause, Obligation
from corollary.verify.obligations.values import TWO, ZERO


def apart(solution: Solution) -> Iterator[Obligation]:
    """Every mistake is told from the truth, in the parts where it shows first; numbers for which it is not are redrawn."""
    for each in visible_mistakes(solution):
        claim = f"part {each.part}: {each.mistake.text!r} is told from the truth"
        line, find = each.mistake.line, solution.unknowns[each.at]
        largest = max(MOST, solution.problem.part(each.part).tolerance)
        share = Number(Fraction(str(largest)) + Fraction(str(APART)))  # relative: beyond, it is told apart
        wrong = mistaken(solution, each.place, each.mistake.rule, each.at)
        if find.in_givens is None or wrong is None:
            why = "it rests on a simulation"
            yield Obligation("mistake apart", claim, line, redrawn=True, open=why)
        elif solution.problem.part(each.part).rows:
            pairs = zip(wrong, find.in_givens, strict=True)
            need = tuple(
                far for mine, tree in pairs for far in _far((mine,), (tree,), (tree,), share) if mine != tree
            )
            yield Obligation("mistake apart", claim, line, (need,), redrawn=True)
        else:
            sizes = [find.in_givens, *([] if find.scale is None else [(find.scale,)])]
            needs = [_far(wrong, find.in_givens, size, share) for size in sizes]
            yield Obligation("mistake apart", claim, line, tuple(needs), redrawn=True)


def differing(solution: Solution) -> Iterator[Obligation]:
    """Some numbers tell any two mistakes of a step apart: checked by `settle` at single points, which is all it takes."""
    for place, find in enumerate(solution.unknowns):
        rules = [(each, mistaken(solution, place, each.rule, place)) for each in find.mistakes]
        for (one, left), (other, right) in combinations(rules, 2):
            if left is not None and right is not None:
                claim = f"{one.text!r} and {other.text!r} are two mistakes"
                need: Clause = tuple(Relation("!=", a, b) for a, b in zip(left, right, strict=True))
                yield Obligation("mistakes differ", claim, other.line, (need,))


def mistaken(solution: Solution, place: int, rule: Rule, at: int) -> tuple[Expr, ...] | None:
    """What is found at a place in givens, where an earlier step (or its own) follows another rule; None where a scene is run."""
    meaning: dict[str, Expr] = {}
    trees: tuple[Expr, ...] | None = None
    for here, find in enumerate(solution.unknowns[: at + 1]):
        if here == place or (here > place and place in ancestors(solution, here)):
            by = rule if here == place else find.local
            trees = (
                tuple(substitute(tree, meaning) for tree in by.trees) if isinstance(by, ClosedForms) else None
            )
        else:
            trees = find.in_givens
        if trees is None:
            if here in (place, at) or here in ancestors(solution, at):
                return None
            continue
        meaning |= zip(find.names, trees, strict=True)
    return trees


def _far(wrong: tuple[Expr, ...], truth: tuple[Expr, ...], size: tuple[Expr, ...], share: Number) -> Clause:
    """The distance is larger than the share of the size: for numbers without squares, whose factors are seen at once."""
    gaps = [Sum((mine, Negative(theirs))) for mine, theirs in zip(wrong, truth, strict=True)]
    if len(gaps) == len(size) == 1:
        allowed = Product((share, size[0]))
        beyond = Product((Sum((gaps[0], Negative(allowed))), Sum((gaps[0], allowed))))
        return (Relation(">", beyond, ZERO),)
    far = Sum(tuple(Power(each, TWO) for each in gaps)) if len(gaps) > 1 else Power(gaps[0], TWO)
    own = [Power(Product((share, each)), TWO) for each in size]
    return (Relation(">", far, Sum(tuple(own)) if len(own) > 1 else own[0]),)
