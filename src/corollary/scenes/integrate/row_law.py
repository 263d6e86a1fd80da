"""The law of motion of a row of bodies, in time or in the variable of a contact, and one step of it; a kernel.

The state of n bodies is v0 d0 v1 d1 … v(n-1): velocities with the overlaps of neighbours between them, so that a part of the row is a
slice. Gaps and not positions are the unknowns: nothing cancels however hard the bodies are. A contact force k overlap^(3/2) has no second
derivative where it begins; in w, overlap = w^2, it is a polynomial. On the variable of a contact (`variable`, `power`: overlap =
w^power) the time stands in the place of that contact's overlap. A power of one serves a gap that closes as well.
Source: M. Henon, Physica D 5 (1982) 412, for a variable that ends a step exactly where it is wanted.

A `row` is (inverse masses, weights, k, q, eta, smoothing powers), the last four of each contact, in natural units.
"""

from __future__ import annotations

import math

from corollary.scenes.integrate.both_ways import ways

kernel, module = ways(__name__)
stages = module("stages")
stage, finish, whole = stages.stage, stages.finish, stages.whole
STAGES, NODES = stages.STAGES, stages.NODES

TIME = -1
TOO_DEEP = 1e15


@kernel
def push(k, q, overlap):
    """The force of an undamped contact; `overlap` is positive."""
    if q == 1.5:
        return k * overlap * math.sqrt(overlap)
    if q == 1.0:
        return k * overlap
    if q == 2.0:
        return k * overlap * overlap
    if q == 3.0:
        return k * overlap * overlap * overlap
    return k * overlap**q if overlap < TOO_DEEP else math.inf


@kernel
def stored(k, q, overlap):
    """The energy of a contact squeezed by `overlap`; none when the bodies are apart."""
    return push(k, q, overlap) * overlap / (q + 1.0) if overlap > 0.0 else 0.0


@kernel
def slope(variable, power, w, y, out, first, last, touching, row):
    """The rate of change of the state of contacts first … last - 1 and the bodies between, into `out`."""
    inverse, falls, k, q, eta, _ = row
    left = 0.0
    for j in range(first, last):
        i = 2 * j
        rate, force = y[i] - y[i + 2], 0.0
        if touching[j]:
            overlap = whole(w, power) if j == variable else y[i + 1]
            if overlap > 0.0:
                force = push(k[j], q[j], overlap)
            if overlap >= 0.0 or j == variable:
                force += eta[j] * rate
        out[i] = (left - force) * inverse[j] - falls[j]
        out[i + 1] = rate
        left = force
    out[2 * last] = left * inverse[last] - falls[last]
    if variable != TIME:
        own = 2 * variable + 1
        rate = out[own]
        stretch = power * whole(w, power - 1) / rate if rate != 0.0 else math.inf
        for s in range(2 * first, 2 * last + 1):
            out[s] *= stretch
        out[own] = stretch


@kernel
def step(variable, power, x, h, y, slopes, out, first, last, touching, row):
    """A step from (x, y) over h into `out`; the first of `slopes` is known. Gives the sums of squares of both error estimates."""
    low, high = 2 * first, 2 * last + 1
    for i in range(1, STAGES):
        stage(i, h, y, slopes, out, low, high)
        slope(variable, power, x + NODES[i] * h, out, slopes[i], first, last, touching, row)
    return finish(h, y, slopes, out, low, high)


@kernel
def value_in(variable, power, time, y):
    """The value of a variable in a state."""
    if variable == TIME:
        return time
    overlap = y[2 * variable + 1]
    return overlap if power == 1 else max(overlap, 0.0) ** (1.0 / power)


@kernel
def stride_for(variable, power, y, base, lasting):
    """The step on a variable that lasts about so long; `base` is the slope in time."""
    if variable == TIME:
        return lasting
    ahead = y[2 * variable + 1] + base[2 * variable + 1] * lasting
    return max(ahead, 0.0) ** (1.0 / power) - value_in(variable, power, 0.0, y)


@kernel
def conserved(y, row):
    """Energy, momentum, and momentum whatever its direction, as `row.conserved` has them."""
    inverse, falls, k, q, _, _ = row
    energy = momentum = size = height = 0.0
    for i in range(len(inverse)):
        if i > 0:
            energy += stored(k[i - 1], q[i - 1], y[2 * i - 1])
            height -= y[2 * i - 1]
        if inverse[i] > 0.0:
            carried = y[2 * i] / inverse[i]
            energy += 0.5 * carried * y[2 * i] + falls[i] * height / inverse[i]
            momentum += carried
            size += abs(carried)
    return energy, momentum, size
