"""Loops of equal steps, each written once: run as Python or compiled by numba, with a look after each step at what the chapter looks at."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from .problem import Found, Problem

COSTS = {"book": 1, "verlet": 1, "rk4": 4}
"""Evaluations of the right side for each step."""


def book(f, fix, p, mode, y, h, steps, marks, seen):
    """Euler-Cromer, as in the chapter: the velocity first, the places with the new one."""
    n, j = y.size // 2, 0
    for i in range(steps + 1):
        while j < marks.size and marks[j] == i:
            seen[j] = y
            j += 1
        before = y.copy()
        y[n:] += h * f(i * h, y, p, mode)[n:]
        y[:n] += h * y[n:]
        fix(y, before, p)


def verlet(f, fix, p, mode, y, h, steps, marks, seen):
    n, j = y.size // 2, 0
    a = f(0.0, y, p, mode)[n:]
    for i in range(steps + 1):
        while j < marks.size and marks[j] == i:
            seen[j] = y
            j += 1
        before = y.copy()
        half = y[n:] + 0.5 * h * a
        y[:n] += h * half
        y[n:] = half + 0.5 * h * a
        a = f((i + 1) * h, y, p, mode)[n:]
        y[n:] = half + 0.5 * h * a
        fix(y, before, p)


def rk4(f, fix, p, mode, y, h, steps, marks, seen):
    j = 0
    for i in range(steps + 1):
        while j < marks.size and marks[j] == i:
            seen[j] = y
            j += 1
        before = y.copy()
        a = f(i * h, y, p, mode)
        b = f((i + 0.5) * h, y + 0.5 * h * a, p, mode)
        c = f((i + 0.5) * h, y + 0.5 * h * b, p, mode)
        d = f((i + 1) * h, y + h * c, p, mode)
        y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d)
        fix(y, before, p)


LOOPS: dict[str, Callable[..., None]] = {"book": book, "verlet": verlet, "rk4": rk4}


@cache
def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
    """By numba; the same text as in Python. Raises ImportError without numba."""
    from numba import njit

    return njit(function)


def run(problem: Problem, name: str, steps: int, fast: bool) -> Found:
    """So many equal steps; places between two of them are read off a straight line, as a student would."""
    make = compiled if fast else (lambda function: function)
    h = problem.until / steps
    at = np.minimum(np.array(problem.times) / h, steps)
    low = np.minimum(at.astype(int), steps - 1)
    marks = np.stack([low, low + 1], axis=1).ravel()
    order = np.argsort(marks, kind="stable")
    seen = np.zeros((marks.size, problem.start.size))
    mode = 2 if problem.family == "friction" else problem.mode
    with np.errstate(all="ignore"):
        make(LOOPS[name])(
            make(problem.right_side),
            make(problem.fix),
            problem.p,
            mode,
            problem.start.copy(),
            h,
            steps,
            marks[order],
            seen,
        )
    states = np.empty_like(seen)
    states[order] = seen
    share = (at - low)[:, None]
    between = (1.0 - share) * states[0::2] + share * states[1::2]
    places = np.array([problem.place(y) for y in between])
    return Found(np.array(problem.velocity(states[-1])), places, COSTS[name] * steps)
