"""Number of distinct variants of a problem, conditions taken into account."""

# pyright: reportUnknownArgumentType=false

from __future__ import annotations

import hashlib
from collections.abc import Iterable
from math import prod

import numpy as np

from corollary.formula.ast import names
from corollary.formula.rational_pi import RationalPi
from corollary.problem.axes import axes
from corollary.problem.given import Given
from corollary.problem.interval_filter import GivenAtPoints, holding
from corollary.problem.problem import Condition, Problem

MOST = 300_000  # numbers worked out for one condition
MOST_TOGETHER = 6_000_000  # points of a grid held in memory, a byte each
SAMPLED = 4_000


def variants(problem: Problem) -> tuple[int, bool]:
    """The number of grid points that keep every condition, and whether it is exact.

    Givens that share no condition only multiply. Those that do are counted point by point, or, when they are too many,
    estimated from a fixed sample of 4000 points (then to three figures, for it tells no more).
    """
    total, exact = 1, True
    for group in _groups(problem):
        symbols = {given.symbol for given in group}
        conditions = [each for each in problem.conditions if names(each.relation) & symbols]
        if not conditions:
            total *= _points(group)
        elif _few(group, conditions):
            total *= _counted(group, conditions)
        else:
            total, exact = total * _estimated(problem.code, group, conditions), False
    return (total, True) if exact else (_three_figures(total), False)


def written(number: int, exact: bool) -> str:
    """A count for a table: `1,150,968`, or `≈ 5.43e+18` where it is estimated."""
    return f"{number:,}" if exact else f"≈ {number:,}" if number < 10**9 else f"≈ {number:.3g}"


def _groups(problem: Problem) -> list[list[Given]]:
    """The givens, those together that some condition ties to each other, or a table whose rows are drawn whole."""
    groups = [list(axis) for axis in axes(problem.givens)]
    for condition in problem.conditions:
        tied = names(condition.relation)
        joined = [given for group in groups if tied & {given.symbol for given in group} for given in group]
        groups = [group for group in groups if not tied & {given.symbol for given in group}] + (
            [joined] if joined else []
        )
    return groups


def _few(group: list[Given], conditions: list[Condition]) -> bool:
    return _points(group) <= MOST_TOGETHER and all(
        _points([given for given in group if given.symbol in names(each.relation)]) <= MOST
        for each in conditions
    )


def _points(group: Iterable[Given]) -> int:
    return prod(axis[0].grid.count for axis in axes(group))


def _counted(group: list[Given], conditions: list[Condition]) -> int:
    """Each given, or table, has an axis of its own, so that a condition is worked out only for the givens it names."""
    letters, every = {}, axes(group)
    for place, axis in enumerate(every):
        count = axis[0].grid.count
        shape = [-1 if other == place else 1 for other in range(len(every))]
        for given in axis:
            letters[given.symbol] = GivenAtPoints(
                _numbers(given, range(count)), np.arange(count).reshape(shape)
            )
    return int(_holding_all(conditions, letters, [axis[0].grid.count for axis in every]).sum())


def _estimated(code: str, group: list[Given], conditions: list[Condition]) -> int:
    letters = {}
    for given in group:
        places = _spread(f"{code} {given.table or given.symbol}", given.grid.count)
        few = given.grid.count <= SAMPLED
        numbers = _numbers(given, range(given.grid.count) if few else places)
        letters[given.symbol] = GivenAtPoints(numbers, np.array(places) if few else np.arange(SAMPLED))
    holding_of_sample = int(_holding_all(conditions, letters, [SAMPLED]).sum())
    return _points(group) * holding_of_sample // SAMPLED


def _holding_all(
    conditions: list[Condition], letters: dict[str, GivenAtPoints], shape: list[int]
) -> np.ndarray:
    result = np.ones(shape, dtype=bool)
    for condition in conditions:
        result &= holding(condition.relation, letters)
    return result


def _spread(name: str, count: int) -> list[int]:
    """Places in a grid, the same every time."""
    stream = hashlib.shake_256(name.encode()).digest(8 * SAMPLED)
    return [int.from_bytes(stream[at : at + 8], "big") * count >> 64 for at in range(0, len(stream), 8)]


def _numbers(given: Given, places: Iterable[int]) -> list[RationalPi]:
    return [RationalPi(*given.unit.to_si(given.grid[place])) for place in places]


def _three_figures(number: int) -> int:
    return round(number, 3 - len(str(number)))
