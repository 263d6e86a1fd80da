"""Claims that laws hold identically for what was found: put back by algebra, and never without a value."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from corollary.derive.solution import Solution
from corollary.formula.ast import Expr, substitute
from corollary.formula.operators import has_operators
from corollary.verify.obligations.obligation import Obligation
from corollary.verify.obligations.values import needed


def laws_of(names: Sequence[str]) -> str:
    """The claim about the step that finds these."""
    return f"the laws of {', '.join(names)} hold for what is found"


def laws_hold(solution: Solution) -> Iterator[Obligation]:
    """One claim for each step. That its laws vanish is found by whoever puts them back; here, that they have a value."""
    found: dict[str, Expr] = {}
    for find in solution.unknowns:
        if find.in_givens is not None:
            found |= zip(find.names, find.in_givens, strict=True)
        found |= find.aside
        if not find.laws:
            continue
        claim, line = laws_of(find.names), find.statement.line
        here = [relation for law in find.laws for relation in law.here]
        if find.in_givens is None:
            yield Obligation("laws hold", claim, line, open="it rests on a simulation")
        elif any(map(has_operators, here)):
            yield Obligation("laws hold", claim, line, open="a differential equation, tried at points")
        else:
            sides = [substitute(side, found) for each in here for side in (each.left, each.right)]
            needs = dict.fromkeys(need for side in sides for need in needed(side))
            yield Obligation("laws hold", claim, line, tuple((need,) for need in needs))
