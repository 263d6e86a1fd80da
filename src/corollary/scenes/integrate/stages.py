"""DOP853 in the part of Python that numba compiles: the state at each stage, the step with its error, the next step's length."""

from __future__ import annotations

import math

from corollary.scenes.integrate.both_ways import ways
from corollary.scenes.integrate.runge_kutta import DOP853

kernel, _ = ways(__name__)

NODES = DOP853.nodes
STAGES = len(NODES)
EVALUATIONS = STAGES - 1
"""What a step costs when the slope at its start is known."""
_, A1, A2, A3, A4, A5, A6, A7, A8, A9, A10, A11 = (row.weights for row in DOP853.rows)
RESULT, FIFTH, THIRD = (row.weights for row in (DOP853.result, *DOP853.estimates))

ORDER = 8
"""The power of the step with which DOP853's error estimate grows (Hairer, Norsett and Wanner, II.10)."""

SAFETY = 0.9
"""The usual share of the longest step that would do: aiming at it exactly, every second step would be rejected."""

SHORTEST, LONGEST = 0.2, 5.0
"""Bounds of the factor: beyond a power of 5 an error is no longer in the range where the eighth power holds, so it says nothing."""


@kernel
def factor(size: float) -> float:
    """What to multiply a step with whose error was `size` times the tolerance; a step out of all range (inf, nan) is cut most.

    The step that would just keep the tolerance is the last one times size^(-1/8). Source: Hairer, Norsett and Wanner, Solving
    Ordinary Differential Equations I (2nd edition, 1993), (II.4.13); K. Gustafsson, ACM Trans. Math. Softw. 17 (1991) 533, on why
    the factor is bounded. A controller that looks at two steps gains nothing: contacts begin and end within some twenty steps.
    """
    if size == 0.0:
        return LONGEST
    if not size < math.inf:
        return SHORTEST
    return min(LONGEST, max(SHORTEST, SAFETY * size ** (-1.0 / ORDER)))


@kernel
def whole(base, power):
    """A whole power, by products."""
    result = 1.0
    for _ in range(power):
        result *= base
    return result


@kernel
def stage(i, h, y, slopes, out, low, high):
    """The state of components low … high - 1 at which slope i is taken, i = 1 … 11, into `out`."""
    k0 = slopes[0]
    if i == 1:
        (a0,) = A1
        for s in range(low, high):
            out[s] = y[s] + h * (a0 * k0[s])
        return
    if i == 2:
        (a0, a1), k1 = A2, slopes[1]
        for s in range(low, high):
            out[s] = y[s] + h * (a0 * k0[s] + a1 * k1[s])
        return
    if i == 3:
        (a0, a2), k2 = A3, slopes[2]
        for s in range(low, high):
            out[s] = y[s] + h * (a0 * k0[s] + a2 * k2[s])
        return
    k3 = slopes[3]
    if i == 4:
        (a0, a2, a3), k2 = A4, slopes[2]
        for s in range(low, high):
            out[s] = y[s] + h * (a0 * k0[s] + a2 * k2[s] + a3 * k3[s])
        return
    k4 = slopes[4]
    if i == 5:
        a0, a3, a4 = A5
        for s in range(low, high):
            out[s] = y[s] + h * (a0 * k0[s] + a3 * k3[s] + a4 * k4[s])
        return
    k5 = slopes[5]
    if i == 6:
        a0, a3, a4, a5 = A6
        for s in range(low, high):
            out[s] = y[s] + h * (a0 * k0[s] + a3 * k3[s] + a4 * k4[s] + a5 * k5[s])
        return
    k6 = slopes[6]
    if i == 7:
        a0, a3, a4, a5, a6 = A7
        for s in range(low, high):
            out[s] = y[s] + h * (a0 * k0[s] + a3 * k3[s] + a4 * k4[s] + a5 * k5[s] + a6 * k6[s])
        return
    k7 = slopes[7]
    if i == 8:
        a0, a3, a4, a5, a6, a7 = A8
        for s in range(low, high):
            out[s] = y[s] + h * (a0 * k0[s] + a3 * k3[s] + a4 * k4[s] + a5 * k5[s] + a6 * k6[s] + a7 * k7[s])
        return
    k8 = slopes[8]
    if i == 9:
        a0, a3, a4, a5, a6, a7, a8 = A9
        for s in range(low, high):
            out[s] = y[s] + h * (
                a0 * k0[s] + a3 * k3[s] + a4 * k4[s] + a5 * k5[s] + a6 * k6[s] + a7 * k7[s] + a8 * k8[s]
            )
        return
    k9 = slopes[9]
    if i == 10:
        a0, a3, a4, a5, a6, a7, a8, a9 = A10
        for s in range(low, high):
            known = a0 * k0[s] + a3 * k3[s] + a4 * k4[s] + a5 * k5[s] + a6 * k6[s]
            out[s] = y[s] + h * (known + a7 * k7[s] + a8 * k8[s] + a9 * k9[s])
        return
    k10 = slopes[10]
    a0, a3, a4, a5, a6, a7, a8, a9, a10 = A11
    for s in range(low, high):
        known = a0 * k0[s] + a3 * k3[s] + a4 * k4[s] + a5 * k5[s] + a6 * k6[s]
        out[s] = y[s] + h * (known + a7 * k7[s] + a8 * k8[s] + a9 * k9[s] + a10 * k10[s])


@kernel
def finish(h, y, slopes, out, low, high):
    """The state after the step, into `out`; gives the sums of squares of both error estimates."""
    k0, k5, k6, k7 = slopes[0], slopes[5], slopes[6], slopes[7]
    k8, k9, k10, k11 = slopes[8], slopes[9], slopes[10], slopes[11]
    b0, b5, b6, b7, b8, b9, b10, b11 = RESULT
    e0, e5, e6, e7, e8, e9, e10, e11 = FIFTH
    # The third-order estimate is the result without three of its terms' parts: only there the weights differ.
    d0, d8, d11 = RESULT[0] - THIRD[0], RESULT[4] - THIRD[4], RESULT[7] - THIRD[7]
    fifth = third = 0.0
    for s in range(low, high):
        s0, s5, s6, s7, s8, s9, s10, s11 = k0[s], k5[s], k6[s], k7[s], k8[s], k9[s], k10[s], k11[s]
        total = b0 * s0 + b5 * s5 + b6 * s6 + b7 * s7 + b8 * s8 + b9 * s9 + b10 * s10 + b11 * s11
        large = e0 * s0 + e5 * s5 + e6 * s6 + e7 * s7 + e8 * s8 + e9 * s9 + e10 * s10 + e11 * s11
        small = total - (d0 * s0 + d8 * s8 + d11 * s11)
        out[s] = y[s] + h * total
        fifth += large * large
        third += small * small
    return fifth, third


@kernel
def error_size(fifth, third, h, count):
    """The error of a step from the sums of squares of its two estimates over so many components (Hairer, Norsett, Wanner, II.10)."""
    if fifth == 0.0:
        return 0.0
    return abs(h) * fifth / math.sqrt((fifth + 0.01 * third) * count)


@kernel
def falls_through_zero(before, after, rise, fall):
    """Where in 0..1 the cubic with these ends and slopes falls through zero; by halving, for it may be crooked."""
    low, high = 0.0, 1.0
    for _ in range(16):
        s = 0.5 * (low + high)
        rest = 1.0 - s
        value = rest * rest * ((1.0 + 2.0 * s) * before + s * rise)
        value += s * s * ((3.0 - 2.0 * s) * after - rest * fall)
        if value > 0.0:
            low = s
        else:
            high = s
    return 0.5 * (low + high)
