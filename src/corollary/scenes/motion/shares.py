"""How surfaces in a plane share what they hold, so that they hold it as long as any share of theirs can."""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

# How near (of the largest square) the minimum is met before Newton's method takes over, for those that near to the largest; and how often it is tried.
ROUGH, NEAR, TURNS = 1e-9, 1e-4, 8


def evenly(forces: Array, free: Array, holders: Sequence[tuple[Sequence[int], float]]) -> Array:
    """Of the multipliers forces + free c those that exhaust the most exhausted holder least.

    `free` has a column for each way to share otherwise; a holder is the numbers of its multipliers and the most (N) their vector may be.
    The largest |z_i|/most_i is minimised, a convex problem: if any share is within all circles of friction, this is.
    """
    from scipy.optimize import minimize  # here, since few scenes come so far

    strong = max(most for _, most in holders)
    parts = [(forces[list(own)] / most, free[list(own)] * (strong / most)) for own, most in holders]
    parts = [(z, ways) for z, ways in parts if np.abs(ways).max() > 1e-12]
    ways = free.shape[1]

    def squares(c: Array) -> Array:
        return np.array([(z + way @ c) @ (z + way @ c) for z, way in parts])

    def slopes(c: Array) -> Array:
        return np.array([2.0 * way.T @ (z + way @ c) for z, way in parts])

    top = float(squares(np.zeros(ways)).max())
    if not top > 1e-24:  # nothing pulls
        return forces
    found = minimize(
        lambda x: x[-1],
        np.array([*np.zeros(ways), 1.0]),
        jac=lambda x: np.array([*np.zeros(ways), 1.0]),
        constraints={
            "type": "ineq",
            "fun": lambda x: x[-1] - squares(x[:-1] * top**0.5) / top,
            "jac": lambda x: np.column_stack([-slopes(x[:-1] * top**0.5) / top**0.5, np.ones(len(parts))]),
        },
        method="SLSQP",
        options={"ftol": ROUGH, "maxiter": 200},
    )
    c = np.asarray(found.x[:-1]) * top**0.5
    if not np.isfinite(c).all() or squares(c).max() > top:
        return forces
    polished = _polished(parts, c)
    return forces + free @ ((polished if squares(polished).max() <= squares(c).max() else c) * strong)


def _polished(parts: Sequence[tuple[Array, Array]], c: Array) -> Array:
    """The same minimum to rounding: Newton's method for those parts that are the largest together, each with its weight."""
    values = np.array([(z + way @ c) @ (z + way @ c) for z, way in parts])
    active = [part for part, value in zip(parts, values, strict=True) if value > values.max() * (1.0 - NEAR)]
    top, weights, ways = float(values.max()), np.full(len(active), 1.0 / len(active)), len(c)
    for _ in range(TURNS):
        forces = [z + way @ c for z, way in active]
        slopes = np.array([2.0 * way.T @ z for z, (_, way) in zip(forces, active, strict=True)])
        bend = sum(2.0 * w * way.T @ way for w, (_, way) in zip(weights, active, strict=True))
        # The weighted slopes cancel, the weights are one together, and all these are as large.
        many = len(active)
        jacobian = np.block(
            [
                [bend, np.zeros((ways, 1)), slopes.T],
                [np.zeros((1, ways + 1)), np.ones((1, many))],
                [slopes, -np.ones((many, 1)), np.zeros((many, many))],
            ]
        )
        off = np.array([*(slopes.T @ weights), weights.sum() - 1.0, *(z @ z - top for z in forces)])
        step = np.linalg.lstsq(jacobian, off, rcond=1e-13)[0]
        c, top, weights = c - step[:ways], top - step[ways], weights - step[ways + 1 :]
        if weights.min() < 0.0:  # one that is not among the largest after all
            active = [part for part, weight in zip(active, weights, strict=True) if weight >= 0.0]
            weights = weights[weights >= 0.0]
        elif float(np.abs(step[:ways]).max()) <= 1e-15 * max(float(np.abs(c).max()), 1e-3):
            break
    return c
