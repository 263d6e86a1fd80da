"""The law of motion of a row of bodies, in time or in a contact's variable, and one step of it; a kernel.

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
falls_through_zero = stages.falls_through_zero
STAGES, NODES, EVALUATIONS = stages.STAGES, stages.NODES, stages.EVALUATIONS

TIME = -1
TOO_DEEP = 1e15
# Into so many parts a step is divided in which a force may rise between two falls, or fall between two rises.
PARTS = 4


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


@kernel
def largest_overlap(j, variable, power, x, h, start, ends, first, last, touching, row, room):
    """The largest overlap of contact j within a step in which its closing speed falls through zero; and the evaluations spent.

    A cubic through the closing speeds at both ends says where; there the overlap still missing is speed^2/(2 deceleration).
    """
    slopes, here, state, i = room, room[STAGES + 3], room[STAGES + 4], 2 * j
    slope(variable, power, x + h, ends, here, first, last, touching, row)
    before, after = start[i] - start[i + 2], ends[i] - ends[i + 2]
    rise, fall = slopes[0][i] - slopes[0][i + 2], here[i] - here[i + 2]
    part = falls_through_zero(before, after, h * rise, h * fall)
    least, overlap, spent = 3e-5 * max(before, -after), 0.0, 1
    for _ in range(4):
        step(variable, power, x, part * h, start, slopes, state, first, last, touching, row)
        slope(variable, power, x + part * h, state, here, first, last, touching, row)
        speed, growth = state[i] - state[i + 2], here[i] - here[i + 2]
        stretch = 1.0 if variable == TIME else here[2 * variable + 1]
        overlap = whole(x + part * h, power) if j == variable else state[i + 1]
        if growth * stretch < 0.0:
            overlap -= 0.5 * speed * speed * stretch / growth
        spent += EVALUATIONS + 1
        if abs(speed) <= least or growth * h >= 0.0:
            break
        part = min(max(part - speed / (growth * h), 0.0), 1.0)
    return overlap, spent


@kernel
def damped_force(y, j, row):
    """The force of a damped contact that touches."""
    _, _, k, q, eta, _ = row
    overlap = y[2 * j + 1]
    return (push(k[j], q[j], overlap) if overlap > 0.0 else 0.0) + eta[j] * (y[2 * j] - y[2 * j + 2])


@kernel
def force_growth(y, base, j, row):
    """How fast the force of a damped contact grows; `base` is the slope in time."""
    _, _, k, q, eta, _ = row
    overlap = y[2 * j + 1]
    stiffness = q[j] * push(k[j], q[j], overlap) / overlap if overlap > 0.0 else 0.0
    return stiffness * (y[2 * j] - y[2 * j + 2]) + eta[j] * (base[2 * j] - base[2 * j + 2])


@kernel
def growth_within(j, place, variable, power, x, h, start, first, last, touching, row, room):
    """How fast the force of damped contact j grows after a part of a step; the state there goes into room[STAGES + 4]."""
    here, state, w = room[STAGES + 3], room[STAGES + 4], x + place * h
    step(variable, power, x, place * h, start, room, state, first, last, touching, row)
    if variable != TIME:
        state[2 * variable + 1] = whole(w, power)
    slope(TIME, 1, 0.0, state, here, first, last, touching, row)
    return force_growth(state, here, j, row)


@kernel
def largest_force(j, variable, power, x, h, start, y, after, base, first, last, touching, row, room):
    """The largest force of damped contact j within a step from y to `after` (zero if it is at an end); and the evaluations spent.

    A maximum is flat, so half the digits of its place give all those of its height. Illinois: an end that stays twice counts half.
    """
    here, state = room[STAGES + 3], room[STAGES + 4]
    slope(TIME, 1, 0.0, after, here, first, last, touching, row)
    begins, ends, spent = force_growth(y, base, j, row), force_growth(after, here, j, row), 1
    parts, hardest = 1, 0.0
    closing, opening = y[2 * j] - y[2 * j + 2] > 0.0, after[2 * j] - after[2 * j + 2] < 0.0
    if closing and (max(begins, ends) <= 0.0 or (opening and min(begins, ends) > 0.0)):
        # The dashpot fades first and the spring takes over: within one long step the force may fall, rise, and fall again; or it rises
        # to its maximum and falls until the dashpot pulls.
        parts = PARTS
    for i in range(1, parts + 1):
        rising, falling = begins, ends
        if i < parts:
            falling = growth_within(
                j, i / parts, variable, power, x, h, start, first, last, touching, row, room
            )
            spent += EVALUATIONS
        begins = falling
        if not rising > 0.0 >= falling:
            continue
        left, right, held, place = (i - 1) / parts, i / parts, 0, i / parts
        for _ in range(12):
            before, place = place, left + (right - left) * rising / (rising - falling)
            growth = growth_within(j, place, variable, power, x, h, start, first, last, touching, row, room)
            spent += EVALUATIONS
            if growth == 0.0 or abs(place - before) < 1e-9:
                break
            if growth > 0.0:
                left, rising, falling, held = place, growth, falling * (0.5 if held > 0 else 1.0), 1
            else:
                right, falling, rising, held = place, growth, rising * (0.5 if held < 0 else 1.0), -1
        hardest = max(hardest, damped_force(state, j, row))
    return hardest, spent
