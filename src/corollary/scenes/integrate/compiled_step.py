"""The law of motion of a row and one step of its method, compiled, for `compiled_loop`; both as in `written_out`.

`y` holds (overlaps, velocities) on a variable, `inverse` the inverse masses, a row of `terms` stiffness, exponent and smoothing power.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit  # pyright: ignore[reportMissingImports]
from numpy.typing import NDArray

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.row_problem import AT_WORK
from corollary.scenes.integrate.runge_kutta import Coefficients

TIME = -1


def _dense(row: Coefficients) -> NDArray[np.float64]:
    weights = np.zeros(STAGES)
    weights[list(row.stages)] = row.weights
    return weights


# Constants to the compiler.
STAGES = len(DOP853.nodes)
NODES = np.array(DOP853.nodes)
ROWS = np.array([_dense(row) for row in DOP853.rows])
RESULT, FIFTH, THIRD = (_dense(row) for row in (DOP853.result, *DOP853.estimates))


@njit(cache=True, inline="always")
def _push(k, q, overlap):
    if q == 1.5:
        return k * overlap * math.sqrt(overlap)
    if q == 1.0:
        return k * overlap
    if q == 3.0:
        return k * overlap * overlap * overlap
    return k * overlap**q


@njit(cache=True, inline="always")
def _whole(base, power):
    """A whole power, by products."""
    result = 1.0
    for _ in range(int(power)):
        result *= base
    return result


@njit(cache=True, error_model="numpy")
def slope(variable, w, y, out, touching, inverse, terms):
    """The rate of change of (overlaps, velocities), the time in the place of the overlap that is the variable."""
    count = len(touching)
    left = 0.0
    for j in range(count):
        out[j] = y[count + j] - y[count + j + 1]
        force = 0.0
        if touching[j]:
            overlap = _whole(w, terms[j, 2]) if j == variable else y[j]
            if overlap > 0.0:
                force = _push(terms[j, 0], terms[j, 1], overlap)
        out[count + j] = (left - force) * inverse[j]
        left = force
    out[2 * count] = left * inverse[count]
    if variable != TIME:
        power = terms[variable, 2] if touching[variable] else 1.0
        stretch = power * _whole(w, power - 1.0) / out[variable]
        for i in range(2 * count + 1):
            out[i] *= stretch
        out[variable] = stretch


@njit(cache=True, error_model="numpy")
def step(variable, x, h, y, slopes, after, touching, inverse, terms):
    """A step of DOP853 from (x, y) over h into `after`, and the size of its error; the first of `slopes` is known."""
    size = len(y)
    for stage in range(1, STAGES):
        after[:] = 0.0
        for i in range(stage):
            if ROWS[stage, i] != 0.0:
                for s in range(size):
                    after[s] += ROWS[stage, i] * slopes[i, s]
        for s in range(size):
            after[s] = y[s] + h * after[s]
        slope(variable, x + NODES[stage] * h, after, slopes[stage], touching, inverse, terms)
    fifth = third = 0.0
    for s in range(size):
        total = v = w = 0.0
        for i in range(STAGES):
            total += RESULT[i] * slopes[i, s]
            v += FIFTH[i] * slopes[i, s]
            w += THIRD[i] * slopes[i, s]
        after[s] = y[s] + h * total
        fifth, third = fifth + v * v, third + w * w
    return 0.0 if fifth == 0.0 else abs(h) * fifth / math.sqrt((fifth + 0.01 * third) * min(size, AT_WORK))
