"""Solvers of scipy, and of packages that add methods to it, on a problem: as they come, or started anew at every event."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from .problem import NO_EVENTS, Found, Problem, TooDear

MOST_EVENTS, MOST_EVALUATIONS = 60, 3_000
ADDED = {"Pr9": "extensisq"}
"""Methods beyond scipy's and the package that brings them: an optimised pair of orders 9 and 8, as Verner's are."""


def method_named(name: str) -> Any:
    """scipy's name, or the class of the package that adds it. Raises ImportError where that is missing."""
    if name not in ADDED:
        return name
    if importlib.util.find_spec(ADDED[name]) is None:
        raise ImportError(f"{name} needs {ADDED[name]}, which is not installed")
    return getattr(importlib.import_module(ADDED[name]), name)


class Counted:
    """A right side that counts how often it is asked, in one mode. Raises TooDear beyond the most."""

    def __init__(self, right_side: Callable[..., np.ndarray], p: np.ndarray) -> None:
        self.right_side, self.p, self.count, self.mode = right_side, p, 0, 0

    def __call__(self, t: float, y: np.ndarray) -> np.ndarray:
        self.count += 1
        if self.count > MOST_EVALUATIONS:
            raise TooDear(f"more than {MOST_EVALUATIONS} evaluations")
        return self.right_side(t, y, self.p, self.mode)


def straight(problem: Problem, right_side: Callable[..., np.ndarray], method: Any, tolerance: float) -> Found:
    """Without a look at events: the right side decides which law holds."""
    slope = Counted(right_side, problem.p)
    slope.mode = NO_EVENTS if problem.family == "friction" else problem.mode
    _, states = _stretch(problem, slope, method, tolerance, 0.0, problem.start, [])
    return _found(problem, dict(states), slope.count)


def through_events(
    problem: Problem, right_side: Callable[..., np.ndarray], method: Any, tolerance: float
) -> Found:
    """Stopped at each event and started anew beyond it."""
    slope, time, y, mode = Counted(right_side, problem.p), 0.0, problem.start, problem.mode
    seen: dict[float, np.ndarray] = {}
    for _ in range(MOST_EVENTS):
        slope.mode = mode
        watched = [_watched(event.value, event.direction) for event in problem.events(mode)]
        stopped, states = _stretch(problem, slope, method, tolerance, time, y, watched)
        seen |= dict(states)
        if stopped is None:
            return _found(problem, seen, slope.count)
        fired, time, y = stopped
        y, mode = problem.events(mode)[fired].after(y, mode)
    raise TooDear(f"more than {MOST_EVENTS} events")


def _stretch(
    problem: Problem,
    slope: Counted,
    method: Any,
    tolerance: float,
    time: float,
    y: np.ndarray,
    watched: list[Any],
):
    n = len(y) // 2
    sizes = np.array([tolerance * problem.long] * n + [tolerance * problem.fast] * n)
    ahead = [t for t in problem.times if t > time]
    found = solve_ivp(
        slope,
        (time, problem.until),
        y,
        method,
        t_eval=ahead,
        rtol=max(tolerance, 3e-14),
        atol=sizes,
        events=watched or None,
    )
    if found.status < 0:
        raise ArithmeticError(found.message)
    states = list(zip(found.t.tolist(), found.y.T, strict=True)) if len(found.t) else []
    if found.status != 1:
        return None, states
    fired = next(i for i, times in enumerate(found.t_events) if len(times))
    return (fired, float(found.t_events[fired][0]), found.y_events[fired][0]), states


def _watched(value: Callable[[Any], Any], direction: int) -> Any:
    def event(_: float, y: Any) -> float:
        return value(y)

    event.terminal, event.direction = True, direction  # pyright: ignore[reportFunctionMemberAccess]
    return event


def _found(problem: Problem, seen: dict[float, np.ndarray], count: int) -> Found:
    states = [seen[t] for t in problem.times]
    return Found(problem.velocity(states[-1]), np.array([problem.place(y) for y in states]), count)
