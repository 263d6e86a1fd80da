"""Equal steps of order 8 for many motions at once, a column each."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.runge_kutta import Coefficients

Array = NDArray[np.floating]
ArraySlope = Callable[[float, Array], Sequence[Array]]


def _dense(row: Coefficients) -> Array:
    weights = np.zeros(len(DOP853.rows))
    weights[list(row.stages)] = row.weights
    return weights


ROWS = [_dense(row)[:i] for i, row in enumerate(DOP853.rows)]
RESULT = _dense(DOP853.result)


def stepped(slope: ArraySlope, start: Array, length: float, steps: int) -> Array:
    """The states, (numbers in a state, motions), after equal steps from 0 to `length`; `slope` gives a row for each number.

    All slopes of a step lie in one array, so that each weighted sum of them is one product of a row with a matrix.
    """
    state, h = start, length / steps
    slopes = np.empty((len(DOP853.rows), *start.shape))
    flat = slopes.reshape(len(slopes), -1)
    for i in range(steps):
        slopes[0] = slope(i * h, state)
        for j in range(1, len(slopes)):
            slopes[j] = slope(
                (i + DOP853.nodes[j]) * h, state + h * (ROWS[j] @ flat[:j]).reshape(start.shape)
            )
        state = state + h * (RESULT @ flat).reshape(start.shape)
    return state


def power(values: Array, exponent: int) -> Array:
    """A small whole power by products, many times faster than by logarithms."""
    product = np.ones_like(values)
    while exponent:
        if exponent & 1:
            product = product * values
        values, exponent = values * values, exponent >> 1
    return product
