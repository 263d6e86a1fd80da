"""Claims that of the cases of a derivation, and of the options of a choice, exactly one holds."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

from corollary.derive.solution import Solution
from corollary.formula.ast import Relation, opposite
from corollary.verify.obligations.obligation import Clause, Obligation
from corollary.verify.obligations.values import ONE, ZERO

MOST_CLAUSES = 64
TRUE, FALSE = Relation("=", ZERO, ZERO), Relation("=", ONE, ZERO)


def one_case(solution: Solution) -> Iterator[Obligation]:
    """Of the cases, and of the options of each choice."""
    if solution.regimes:
        line = min(each.line for each in solution.regimes)
        yield _exactly_one([each.conditions for each in solution.regimes], "exactly one case holds", line)
    for part, choice in solution.choices.items():
        held = [
            each if isinstance(each, Relation) else TRUE if each else FALSE
            for each in choice.options.values()
        ]
        claim = f"exactly one option of part {part} holds"
        yield _exactly_one([(each,) for each in held], claim, choice.statement.line)


def _exactly_one(cases: list[Clause], claim: str, line: int) -> Obligation:
    """One at least: whichever condition is taken of each case, one of those holds. No two: a condition of the two fails."""
    every = list(product(*cases))
    pairs = [tuple(map(opposite, (*one, *other))) for one, other in combinations(cases, 2)]
    if len(every) + len(pairs) > MOST_CLAUSES:
        return Obligation("one case", claim, line, open="there are too many conditions")
    return Obligation("one case", claim, line, (*every, *pairs))
