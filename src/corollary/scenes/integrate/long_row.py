"""Newton's second law and the step of a method for long rows, in arrays: their cost hardly grows with the number of bodies."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.runge_kutta import Coefficients, Slope
from corollary.scenes.integrate.time_variable import TIME, TimeVariable
from corollary.scenes.row import RowOfBodies

Array = NDArray[np.float64]


def law_of_motion(line: RowOfBodies, touching: Sequence[bool], variable: TimeVariable = TIME) -> Slope:
    """The same as `written_out.law_of_motion`."""
    count, contact, power = len(line.contacts), variable.contact, variable.power
    on = np.array(touching)
    stiffness, exponents = np.array([c.k for c in line.contacts]) * on, np.array([c.q for c in line.contacts])
    drags = np.array([c.eta for c in line.contacts]) * on
    inverse = np.array([1.0 / m for m in line.masses])
    falls = np.array([0.0 if math.isinf(m) else line.weight for m in line.masses])
    exponent = float(exponents[0]) if (exponents == exponents[0]).all() else exponents
    damped, pushes = bool(drags.any()), contact is not None and touching[contact]

    def slope(w: float, y: Sequence[float]) -> Sequence[float]:
        state = np.asarray(y)
        speeds = state[count:]
        slopes = np.empty(2 * count + 1)
        rates = np.subtract(speeds[:-1], speeds[1:], out=slopes[:count])
        deep = np.maximum(state[:count], 0.0)
        if contact is not None:
            deep[contact] = w**power if pushes else 0.0
        force = stiffness * _power(deep, exponent)
        if damped:
            here = state[:count] >= 0.0
            if contact is not None:
                here[contact] = True
            force += np.where(here, drags * rates, 0.0)
        gained = np.negative(falls, out=slopes[count:])
        gained[:-1] -= force * inverse[:-1]
        gained[1:] += force * inverse[1:]
        if contact is not None:
            stretch = power * w ** (power - 1) / float(rates[contact])
            slopes *= stretch
            slopes[contact] = stretch
        return slopes  # pyright: ignore[reportReturnType]

    return slope


def _power(base: Array, exponent: float | Array) -> Array:
    if isinstance(exponent, float):
        if exponent == 1.5:
            return base * np.sqrt(base)
        if exponent in (1.0, 2.0, 3.0):
            return np.multiply.reduce([base] * int(exponent))
    return base**exponent


def _dense(row: Coefficients) -> Array:
    weights = np.zeros(max(row.stages, default=-1) + 1)
    weights[list(row.stages)] = row.weights
    return weights


ROWS = [_dense(row) for row in DOP853.rows]
RESULT, FIFTH, THIRD = (_dense(row) for row in (DOP853.result, *DOP853.estimates))


def step(
    slope: Slope, x: float, h: float, y: Sequence[float], first: Sequence[float]
) -> tuple[Sequence[float], float, float]:
    """The same as a step written out; the state comes back as a list."""
    start = np.asarray(y)
    slopes = np.empty((len(ROWS), len(start)))
    slopes[0] = first
    for stage in range(1, len(ROWS)):
        row = ROWS[stage]
        slopes[stage] = slope(x + DOP853.nodes[stage] * h, start + h * (row @ slopes[: len(row)]))  # pyright: ignore[reportArgumentType]
    fifth, third = FIFTH @ slopes[: len(FIFTH)], THIRD @ slopes[: len(THIRD)]
    return (start + h * (RESULT @ slopes[: len(RESULT)])).tolist(), float(fifth @ fifth), float(third @ third)
