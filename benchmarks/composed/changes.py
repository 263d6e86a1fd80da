"""Where the mode of discs changes: what must stay above zero while it lasts, and where in a step that falls through it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import IntEnum
from typing import Any

from scipy.optimize import brentq

from .discs import System, apart
from .modes import STICKS, Mode, NoReference, closing, motion, pressed, slipping


class Kind(IntEnum):
    """Of what is watched: an overlap (or the lack of one), a gap, what friction has left, a force that holds, a slip."""

    OVERLAP = 0
    GAP = 1
    FRICTION = 2
    FORCE = 3
    SLIP = 4


Watched = tuple[Kind, int]
"""And which of that kind: of the pairs, the constraints or the rubbing surfaces."""


def watched(system: System, mode: Mode, t: float, state: Any) -> dict[Watched, float]:
    """All that must stay above zero."""
    response, found = motion(system, t, state, mode), dict[Watched, float]()
    for i, each in enumerate(system.holds):
        if each.opens and i in mode.held:
            found[Kind.FORCE, i] = response.presses[i]
        elif each.opens:
            found[Kind.GAP, i] = each.gap(t, state)
    for k, sense in mode.rubbing.items():
        if sense == STICKS:
            most = system.rubs[k][2] * pressed(system, k, state, response.presses)
            found[Kind.FRICTION, k] = most - abs(response.takes[k])
        else:
            found[Kind.SLIP, k] = sense * slipping(system, k, state)
    for k, pair in enumerate(system.pairs):
        found[Kind.OVERLAP, k] = pair.depth(state) if k in mode.touching else -pair.depth(state)
    return found


def growth(system: System, mode: Mode, what: Watched, t: float, state: Any) -> float:
    """How fast a gap or an overlap grows; of all else it is enough that it is below zero."""
    kind, which = what
    if kind == Kind.GAP:
        return closing(system, which, t, state)
    if kind == Kind.OVERLAP:
        pair = system.pairs[which]
        parting = apart(state, pair.a, pair.b).growth
        return -parting if which in mode.touching else parting
    return -1.0


def falls(
    system: System,
    mode: Mode,
    what: Watched,
    low: float,
    high: float,
    before: float,
    after: float,
    at: Callable[[float], tuple[float, Any]],
) -> Iterator[float]:
    """Where in a part of a step a watched value falls through zero, also where it dips below and comes back.

    `before` and `after` are its values at the ends of the part, `at` gives the time and the state within it.
    """

    def value(x: float) -> float:
        return watched(system, mode, *at(x))[what]

    def rate(x: float) -> float:
        return growth(system, mode, what, *at(x))

    kind, _ = what
    smooth = kind in (Kind.GAP, Kind.OVERLAP)
    if after < 0 and rate(high) < 0:
        if before > 0 and (kind != Kind.SLIP or before > 1e-10 or after < -1e-10):
            yield root(value, low, high)
        elif after < (-1e-14 if smooth else -1e-10):
            yield low
    elif smooth and after > 0 and before > 0 and rate(low) < 0 < rate(high):
        lowest = root(rate, low, high)
        if value(lowest) < 0:
            yield root(value, low, lowest)


def root(value: Callable[[float], float], low: float, high: float) -> float:
    """By Brent's method."""
    try:
        return float(brentq(value, low, high, xtol=1e-16, rtol=1e-15, maxiter=200))
    except (ValueError, RuntimeError) as unclear:
        raise NoReference("a change that rounding hides") from unclear
