"""Proofs by subdivision: boxes of grid points, evaluated in numbers with a bound, are halved until each is settled."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from corollary.formula.arithmetics import NotAvailable, ready
from corollary.formula.ast import Negative, Relation, Sum, names
from corollary.formula.ball import Undefined, holds
from corollary.problem.interval_filter import INTERVALS, Interval, holding
from corollary.verify.obligations.box import Box
from corollary.verify.obligations.obligation import Clause, opposite

MOST_BOXES = 150_000  # for one relation: a second or so
Places = dict[str, np.ndarray]


@dataclass(frozen=True, slots=True)
class Divided:
    """What subdivision found: all of the box is settled, and whether single points had to be tried; or a point that fails."""

    proven: bool
    points: bool
    failing: dict[str, int] | None = None


def subdivide(box: Box, need: Clause, most: int = MOST_BOXES) -> Divided | None:
    """Whether the relation holds for all of the grid that keeps the conditions; None where that takes more than `most` boxes."""
    letters, conditions = box.tied(need)
    if not letters:
        return Divided(True, True) if any(map(_true, need)) else Divided(False, True, {})
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
            admissible = box.keeping(conditions, places)
            holds_there = any_holds(need, box, places)
            if (failing := admissible & none_holds(need, box, places)).any():
                first = int(np.argmax(failing))
                return Divided(False, True, {name: int(places[name][first]) for name in letters})
            if (admissible & ~holds_there).any():
                return None
            low, high = ({name: each[name][~single] for name in letters} for each in (low, high))
        low, high = _halved(box, low, high, letters)
    return Divided(True, points)


def any_holds(need: Clause, box: Box, places: Places) -> np.ndarray:
    """At which points one of the relations holds; a relation among numbers alone holds at all points or at none."""
    points, count = box.points(places), len(next(iter(places.values())))
    found = np.zeros(count, dtype=bool)
    for each in need:
        found |= holding(each, points) if names(each) & points.keys() else _true(each)
    return found


def none_holds(need: Clause, box: Box, places: Places) -> np.ndarray:
    """At which points all of the relations are known to fail: that one is not known to hold does not say so."""
    found = np.ones(len(next(iter(places.values()))), dtype=bool)
    for each in need:
        found &= any_holds((opposite(each),), box, places)
    return found


def surely_fails(need: Clause, box: Box, places: Places) -> np.ndarray:
    """The same as far as doubles with a bound tell, which takes no time."""
    count = len(next(iter(places.values())))
    found = np.ones(count, dtype=bool)
    with np.errstate(all="ignore"):
        at = box.intervals(places, places)
        for each in need:
            found &= _certain(opposite(each), at, count)
    return found


def _true(relation: Relation) -> bool:
    try:
        return bool(holds(relation, {}))
    except Undefined:
        return False


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
    return ready(Sum((need.left, Negative(need.right))), INTERVALS)


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
