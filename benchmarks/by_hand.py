"""What somebody writes by hand and compiles with numba: RK4 on a row of balls, its right side for scipy."""

# pyright: reportUnknownMemberType=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numba import njit
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]
MOST_EVENTS = 100


@njit(cache=True)
def row_slope(y: Array, out: Array, k: float, q: float, m: float) -> None:
    """Displacements and velocities of balls in a row."""
    n = len(y) // 2
    for i in range(n):
        out[i], out[n + i] = y[n + i], 0.0
    for i in range(n - 1):
        overlap = y[i] - y[i + 1]
        if overlap > 0.0:
            push = k * (overlap * math.sqrt(overlap) if q == 1.5 else overlap**q) / m
            out[n + i] -= push
            out[n + i + 1] += push


@njit(cache=True)
def row_by_rk4(y: Array, until: float, steps: int, k: float, q: float, m: float) -> Array:
    """Equal steps of the classical method."""
    h, y = until / steps, y.copy()
    a, b, c, d = np.empty_like(y), np.empty_like(y), np.empty_like(y), np.empty_like(y)
    for _ in range(steps):
        row_slope(y, a, k, q, m)
        row_slope(y + 0.5 * h * a, b, k, q, m)
        row_slope(y + 0.5 * h * b, c, k, q, m)
        row_slope(y + h * c, d, k, q, m)
        for i in range(len(y)):
            y[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i])
    return y


def row_by_dop853(y: Array, until: float, tolerance: float, k: float, q: float, m: float) -> Array:
    """scipy's method with the compiled right side, stopped and started anew wherever a contact begins or ends."""
    n, out = len(y) // 2, np.empty_like(y)

    def law(_: float, y: Array) -> Array:
        row_slope(y, out, k, q, m)
        return out.copy()

    def event(i: int, on: bool) -> Callable[[float, Array], float]:
        def watched(_: float, y: Array) -> float:
            return y[i] - y[i + 1]

        watched.terminal, watched.direction = True, -1.0 if on else 1.0  # pyright: ignore[reportFunctionMemberAccess]
        return watched

    time, on = 0.0, [i == 0 for i in range(n - 1)]
    sizes = np.array([tolerance * until] * n + [tolerance] * n) * float(np.abs(y[n:]).max())
    for _ in range(MOST_EVENTS):
        found: Any = solve_ivp(
            law,
            (time, until),
            y,
            "DOP853",
            rtol=max(tolerance, 3e-14),
            atol=sizes,
            events=[event(i, each) for i, each in enumerate(on)],
        )
        time, y = float(found.t[-1]), found.y[:, -1]
        if found.status != 1:
            break
        fired = next(i for i, times in enumerate(found.t_events) if len(times))
        on[fired] = not on[fired]
    return y
