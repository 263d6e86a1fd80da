"""The law of motion of a row and one step of its method, compiled, for `compiled_loop`; both as in `line_motion` and `written_out`.

`y` holds (overlaps, velocities) on a clock, `inverse` the inverse masses, a row of `terms` stiffness, exponent and smoothing power.
"""

from __future__ import annotations

import math

from numba import njit  # pyright: ignore[reportMissingImports]

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.step import AT_WORK

TIME = -1

# Constants to the compiler.
C = DOP853.nodes
A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11 = (row.weights for row in DOP853.rows[1:])
R, F, T = (row.weights for row in (DOP853.result, *DOP853.doubts))
STAGES = len(C)


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
def slope(clock, w, y, out, touching, inverse, terms):
    """The rate of change of (overlaps, velocities), the time in the place of the overlap that is the clock."""
    count = len(touching)
    left = 0.0
    for j in range(count):
        out[j] = y[count + j] - y[count + j + 1]
        force = 0.0
        if touching[j]:
            overlap = _whole(w, terms[j, 2]) if j == clock else y[j]
            if overlap > 0.0:
                force = _push(terms[j, 0], terms[j, 1], overlap)
        out[count + j] = (left - force) * inverse[j]
        left = force
    out[2 * count] = left * inverse[count]
    if clock != TIME:
        power = terms[clock, 2] if touching[clock] else 1.0
        stretch = power * _whole(w, power - 1.0) / out[clock]
        for i in range(2 * count + 1):
            out[i] *= stretch
        out[clock] = stretch


@njit(cache=True, error_model="numpy")
def step(clock, x, h, y, k, after, touching, inverse, terms):
    """Fills in the slopes k[1:] and `after`; gives the size of the error. k[0] is the slope at (x, y)."""
    size = len(y)
    a, b, c, d, e, f, g, p, q, r, t, u = (
        k[0],
        k[1],
        k[2],
        k[3],
        k[4],
        k[5],
        k[6],
        k[7],
        k[8],
        k[9],
        k[10],
        k[11],
    )
    for s in range(size):
        after[s] = y[s] + h * (A1[0] * a[s])
    slope(clock, x + C[1] * h, after, b, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (A2[0] * a[s] + A2[1] * b[s])
    slope(clock, x + C[2] * h, after, c, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (A3[0] * a[s] + A3[1] * c[s])
    slope(clock, x + C[3] * h, after, d, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (A4[0] * a[s] + A4[1] * c[s] + A4[2] * d[s])
    slope(clock, x + C[4] * h, after, e, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (A5[0] * a[s] + A5[1] * d[s] + A5[2] * e[s])
    slope(clock, x + C[5] * h, after, f, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (A6[0] * a[s] + A6[1] * d[s] + A6[2] * e[s] + A6[3] * f[s])
    slope(clock, x + C[6] * h, after, g, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (A7[0] * a[s] + A7[1] * d[s] + A7[2] * e[s] + A7[3] * f[s] + A7[4] * g[s])
    slope(clock, x + C[7] * h, after, p, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (
            A8[0] * a[s] + A8[1] * d[s] + A8[2] * e[s] + A8[3] * f[s] + A8[4] * g[s] + A8[5] * p[s]
        )
    slope(clock, x + C[8] * h, after, q, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (
            A9[0] * a[s]
            + A9[1] * d[s]
            + A9[2] * e[s]
            + A9[3] * f[s]
            + A9[4] * g[s]
            + A9[5] * p[s]
            + A9[6] * q[s]
        )
    slope(clock, x + C[9] * h, after, r, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (
            A10[0] * a[s]
            + A10[1] * d[s]
            + A10[2] * e[s]
            + A10[3] * f[s]
            + A10[4] * g[s]
            + A10[5] * p[s]
            + A10[6] * q[s]
            + A10[7] * r[s]
        )
    slope(clock, x + C[10] * h, after, t, touching, inverse, terms)
    for s in range(size):
        after[s] = y[s] + h * (
            A11[0] * a[s]
            + A11[1] * d[s]
            + A11[2] * e[s]
            + A11[3] * f[s]
            + A11[4] * g[s]
            + A11[5] * p[s]
            + A11[6] * q[s]
            + A11[7] * r[s]
            + A11[8] * t[s]
        )
    slope(clock, x + C[11] * h, after, u, touching, inverse, terms)
    fifth = third = 0.0
    for s in range(size):
        after[s] = y[s] + h * (
            R[0] * a[s]
            + R[1] * f[s]
            + R[2] * g[s]
            + R[3] * p[s]
            + R[4] * q[s]
            + R[5] * r[s]
            + R[6] * t[s]
            + R[7] * u[s]
        )
        v = (
            F[0] * a[s]
            + F[1] * f[s]
            + F[2] * g[s]
            + F[3] * p[s]
            + F[4] * q[s]
            + F[5] * r[s]
            + F[6] * t[s]
            + F[7] * u[s]
        )
        w = (
            T[0] * a[s]
            + T[1] * f[s]
            + T[2] * g[s]
            + T[3] * p[s]
            + T[4] * q[s]
            + T[5] * r[s]
            + T[6] * t[s]
            + T[7] * u[s]
        )
        fifth, third = fifth + v * v, third + w * w
    return 0.0 if fifth == 0.0 else abs(h) * fifth / math.sqrt((fifth + 0.01 * third) * min(size, AT_WORK))
