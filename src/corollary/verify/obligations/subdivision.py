"""Proofs by subdivision: boxes of grid points, evaluated in numbers with a bound, are halved until each is settled."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from corollary.formula.arithmetics import NotAvailable, exactly, ready
from corollary.formula.ast import Expr, Relation, difference, names, opposite
from corollary.formula.ball import Undefined, evaluate, holds
from corollary.formula.rational_pi import RationalPi
from corollary.problem.interval_filter import INTERVALS, Interval, holding
from corollary.verify.obligations.box import Box, always_true
from corollary.verify.obligations.obligation import Clause

MOST_BOXES = 150_000  # for one relation: a second or so
BITS = 512  # to see that a formula has a value, which is rarely near to having none
Places = dict[str, np.ndarray]


@dataclass(frozen=True, slots=True)
class Divided:
    """What subdivision found: all of the box is settled, and whether single points had to be tried; or a point that fails."""

    proven: bool
    points: bool
    failing: dict[str, int] | None = None


def subdivide(box: Box, need: Clause, most: int = MOST_BOXES, partial: bool = False) -> Divided | None:
    """Whether the clause holds for all of the grid, and of the domains, that keeps the conditions (`partial`: wherever it has a value); None where that takes
    more than `most` boxes, or where a point cannot be decided."""
    letters, conditions = box.tied(need)
    if not letters:
        found = verdict(need, {}, partial)
        return None if found is None else Divided(found, True, None if found else {})
    low = {name: np.zeros(1, dtype=np.int64) for name in letters}
    high = {name: np.array([box.axes[name].count - 1]) for name in letters}
    done, points = 0, False
    while count := len(low[letters[0]]):
        done += count
        if done > most:
            return None
        with np.errstate(all="ignore"):
            at = box.intervals(low, high)
            settled = np.zeros(count, dtype=bool)
            for each in (*need, *map(opposite, conditions)):
                settled |= _certain(each, at, count)
        low, high = ({name: each[name][~settled] for name in letters} for each in (low, high))
        single = np.all([low[name] == high[name] for name in letters], axis=0)
        if single.any():
            points = True
            places = {name: low[name][single] for name in letters}
            left = box.keeping(conditions, places) & ~any_holds(need, box, places)
            for each in np.flatnonzero(left):
                point = {name: int(at[each]) for name, at in places.items()}
                found = verdict(need, box.exact(point), partial)
                if not found:
                    return None if found is None else Divided(False, True, point)
            if box.domains.intersection(letters):
                return None  # its middle is a number for which it holds, and no proof for all the others
            low, high = ({name: each[name][~single] for name in letters} for each in (low, high))
        low, high = _halved(box, low, high, letters)
    return Divided(True, points)


def verdict(need: Clause, values: Mapping[str, RationalPi], partial: bool = False) -> bool | None:
    """Whether one of the relations holds for these numbers; None where no precision decides. What has no value does not hold (`partial`:
    where one of the relations has none, the clause says nothing, and holds)."""
    outcome: bool | None = False
    for each in need:
        try:
            found = holds(each, values)
        except Undefined:
            if partial:
                return True
            continue
        if found:
            return True
        if found is None:
            outcome = None
    return outcome


def has_value(tree: Expr, values: Mapping[str, RationalPi]) -> bool | None:
    """Whether a formula has a value for these numbers; None where that is not decided."""
    try:
        if evaluate(tree, values, BITS).is_finite():
            return True
    except Undefined:
        return False
    return True if exactly(tree, values) is not None else None


def any_holds(need: Clause, box: Box, places: Places) -> np.ndarray:
    """At which points one of the relations holds; a relation among numbers alone holds at all points or at none."""
    points, count = box.points(places), len(next(iter(places.values())))
    found = np.zeros(count, dtype=bool)
    for each in need:
        found |= holding(each, points) if names(each) & points.keys() else always_true(each)
    return found


def surely_fails(need: Clause, box: Box, places: Places) -> np.ndarray:
    """At which points all of the relations are known to fail, as far as doubles with a bound tell, which takes no time."""
    count = len(next(iter(places.values())))
    found = np.ones(count, dtype=bool)
    with np.errstate(all="ignore"):
        at = box.intervals(places, places)
        for each in need:
            found &= _certain(opposite(each), at, count)
    return found


def _certain(need: Relation, at: dict[str, Interval], count: int) -> np.ndarray:
    """Where the relation surely holds; nowhere where this arithmetic cannot say."""
    try:
        gap = _gap(need)(at)
    except (NotAvailable, OverflowError):
        return np.zeros(count, dtype=bool)
    value, radius = np.broadcast_to(gap.value, count), np.broadcast_to(gap.radius, count)
    match need.sign:
        case ">" | ">=":
            return value - radius > 0
        case "<" | "<=":
            return value + radius < 0
        case "!=":
            return abs(value) > radius
        case _:
            return np.zeros(count, dtype=bool)


@cache
def _gap(need: Relation) -> Callable[[Mapping[str, Any]], Any]:
    return ready(difference(need), INTERVALS)


def _halved(box: Box, low: Places, high: Places, letters: list[str]) -> tuple[Places, Places]:
    """Each box in two, across the given that varies most in it, relative to its whole range."""
    if not len(low[letters[0]]):
        return low, high
    widths = np.stack([(high[name] - low[name]) / max(1, box.axes[name].count - 1) for name in letters])
    widest = np.argmax(widths, axis=0)
    below, above = dict(low), dict(high)
    for place, name in enumerate(letters):
        middle = (low[name] + high[name]) // 2
        here = widest == place
        above[name] = np.where(here, middle, high[name])
        below[name] = np.where(here, middle + 1, low[name])
    return (
        {name: np.concatenate([low[name], below[name]]) for name in letters},
        {name: np.concatenate([above[name], high[name]]) for name in letters},
    )
