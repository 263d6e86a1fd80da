"""Isolation of the first fall through zero of a smooth function in a step, on its Chebyshev series; no pair is missed.

The function is sampled at 17 Chebyshev points, which is exact for what is of degree 16 in a step's own polynomial (the square of a
distance has degree 14 in DOP853's dense output). A series whose constant exceeds the sum of its other coefficients has no root, one
whose derivative does so is monotone; what is neither is halved. Source: J. P. Boyd, SIAM J. Numer. Anal. 40 (2002) 1666.
"""

# pyright: reportUnknownArgumentType=false, reportUnknownLambdaType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

Array = NDArray[np.float64]

DEGREE = 16
POINTS: Array = 0.5 * (1.0 - np.cos(np.pi * np.arange(DEGREE + 1) / DEGREE))
"""Where on a step (0 to 1) a function is sampled: closest at its ends, which are among them."""

# A series is resolved when its last coefficients are this share of the largest; a function that is no polynomial is halved until then.
RESOLVED = 1e-9
MOST_HALVINGS = 48
MOST_RESAMPLED = 6


def _transform() -> Array:
    """From values at POINTS to Chebyshev coefficients on (-1, 1)."""
    j = np.arange(DEGREE + 1)
    weights = np.where((j == 0) | (j == DEGREE), 0.5, 1.0)
    cosines = np.cos(np.pi * np.outer(j, DEGREE - j) / DEGREE)
    return weights[:, None] * cosines * weights[None, :] * 2.0 / DEGREE


def _halving(side: float) -> Array:
    """From the coefficients on (-1, 1) to those on its left (-1) or right (+1) half."""
    x = 2.0 * POINTS - 1.0
    values = np.polynomial.chebyshev.chebvander(0.5 * (x + side), DEGREE)
    return TRANSFORM @ values


def _derivative() -> Array:
    """From the coefficients of a series to those of its derivative."""
    derived = np.polynomial.chebyshev.chebder(np.eye(DEGREE + 1))
    return np.vstack([derived, np.zeros(DEGREE + 1)]).astype(np.float64)


TRANSFORM = _transform()
LEFT, RIGHT = _halving(-1.0), _halving(1.0)
DERIVATIVE = _derivative()


def coefficients(values: Array) -> Array:
    """Chebyshev coefficients of functions from their values at POINTS: the last axis of `values`."""
    return values @ TRANSFORM.T


def certainly_positive(series: Array) -> NDArray[np.bool_]:
    """For each row of coefficients whether the series is above zero everywhere."""
    return series[..., 0] > np.abs(series[..., 1:]).sum(axis=-1)


def first_fall(values_at: Callable[[Array], Array], values: Array) -> tuple[float, float] | None:
    """The first part of a step (0 to 1) on which a function falls from above zero to zero or below, monotonously; none if it never does.

    `values` are those at POINTS, `values_at` gives them anywhere. One that begins at or below zero and falls, falls at once: (0, 0). One that begins there and rises
    is waited for until it is above.
    """
    return _in_piece(values_at, coefficients(values), 0.0, 1.0, 0, False)


def bracketed(value: Callable[[float], float], left: float, right: float) -> tuple[float, float]:
    """A fall's bracket with its ends moved to where the function is above zero, and to where it no longer is.

    Where it is not smooth, its series may be off by more than it is there. An end for which there is no such place stays as it is.
    """
    before, after, back, ahead = left, right, 2.0**-MOST_RESAMPLED, 2.0**-MOST_RESAMPLED
    while before > 0.0 and value(before) <= 0.0:
        before, back = max(before - back, 0.0), 2.0 * back
    while after < 1.0 and value(after) > 0.0:
        after, ahead = min(after + ahead, 1.0), 2.0 * ahead
    return (
        before if before == left or value(before) > 0.0 else left,
        after if after == right or value(after) <= 0.0 else right,
    )


def root_of(value: Callable[[float], float], left: float, right: float) -> float:
    """Where a function that has opposite signs at two places is zero, to the last digit (Brent's method)."""
    return float(brentq(value, left, right, xtol=1e-16, rtol=1e-15, disp=False))  # pyright: ignore[reportArgumentType]


def _in_piece(
    values_at: Callable[[Array], Array], series: Array, left: float, right: float, resampled: int, above: bool
) -> tuple[float, float] | None:
    """`above` says whether the piece before this one ends above zero: where not all is resolved, the two may not agree on where they meet."""
    largest = np.abs(series).max()
    if largest == 0.0:
        return None
    if abs(series[-1]) + abs(series[-2]) > RESOLVED * largest and resampled < MOST_RESAMPLED:
        middle = 0.5 * (left + right)
        for low, high in ((left, middle), (middle, right)):
            values = values_at(low + (high - low) * POINTS)
            found = _in_piece(values_at, coefficients(values), low, high, resampled + 1, above)
            if found:
                return found
            above = float(values[-1]) > 0.0
        return None
    return _isolated(series, left, right, 0, above)


def _isolated(
    series: Array, left: float, right: float, halvings: int, above: bool
) -> tuple[float, float] | None:
    rest = np.abs(series[1:]).sum()
    if series[0] > rest:
        return None
    begin, end = float(series[::2].sum() - series[1::2].sum()), float(series.sum())
    slope = DERIVATIVE @ series
    steepness = np.abs(slope[1:]).sum()
    if abs(slope[0]) > steepness or halvings == MOST_HALVINGS:
        if slope[0] >= 0.0 or end > 0.0:
            return None
        if begin <= 0.0:
            return (left, left) if left == 0.0 else (left, right)
        return left, right
    if series[0] < -rest and left > 0.0:
        return (left, left) if above else None
    middle = 0.5 * (left + right)
    first = LEFT @ series
    found = _isolated(first, left, middle, halvings + 1, above)
    return found or _isolated(RIGHT @ series, middle, right, halvings + 1, float(first.sum()) > 0.0)


def minima(values: Array) -> list[tuple[float, float]]:
    """Where (0 to 1) a function sampled at POINTS is least within a step, or at its very ends, and how large it is there."""
    series = coefficients(values)
    slope = np.polynomial.chebyshev.chebder(series)
    bend = np.polynomial.chebyshev.chebder(slope)
    roots = np.polynomial.chebyshev.chebroots(slope)
    found = [float(x.real) for x in roots if abs(x.imag) < 1e-6 and abs(x.real) < 1.0 + 1e-6]
    return [
        (0.5 * (x + 1.0), float(np.polynomial.chebyshev.chebval(x, series)))
        for x in found
        if np.polynomial.chebyshev.chebval(x, bend) > 0.0
    ]
