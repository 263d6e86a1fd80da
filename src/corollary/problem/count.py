"""How many distinct variants a problem has, conditions taken into account."""

from __future__ import annotations

from itertools import product
from math import prod

from corollary.problem.draw import digest
from corollary.problem.given import Given
from corollary.problem.problem import Condition, Problem
from corollary.problem.variant import at, first_broken, size
from corollary.quantity.ball import Exactly, Undefined, holds
from corollary.quantity.tree import names

SMALL = 4_000


def variants(problem: Problem) -> tuple[int, bool]:
    """The number of grid points that keep every condition, and whether it is exact.

    Givens that share no condition only multiply; those that do are counted point by point when they are few,
    else the whole is estimated from a fixed sample of 2000 points.
    """
    total = 1
    for group in _groups(problem):
        together = prod(given.grid.count for given in group)
        if together > SMALL:
            return _estimated(problem)
        symbols = [given.symbol for given in group]
        conditions = [each for each in problem.conditions if names(each.relation) & set(symbols)]
        choices = (
            [Exactly(given.grid[i] * given.unit.factor, given.unit.pi) for i in range(given.grid.count)] for given in group
        )
        total *= (
            sum(_keeps(conditions, dict(zip(symbols, values, strict=True))) for values in product(*choices))
            if conditions
            else together
        )
    return total, True


def _groups(problem: Problem) -> list[list[Given]]:
    """The givens, those together that some condition ties to each other."""
    groups = [[given] for given in problem.givens]
    for condition in problem.conditions:
        tied = names(condition.relation)
        joined = [given for group in groups if tied & {given.symbol for given in group} for given in group]
        groups = [group for group in groups if not tied & {given.symbol for given in group}] + ([joined] if joined else [])
    return groups


def _estimated(problem: Problem) -> tuple[int, bool]:
    total, tries = size(problem), 2000
    kept = sum(first_broken(at(problem, digest(b"count", problem.code, str(n)) % total)) is None for n in range(tries))
    return total * kept // tries, kept == tries


def _keeps(conditions: list[Condition], exact: dict[str, Exactly]) -> bool:
    try:
        return all(holds(condition.relation, exact) for condition in conditions)
    except Undefined:
        return False
