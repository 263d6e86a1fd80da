"""The largest overlap and the largest force of a contact of a row, found within a step; a kernel."""

from __future__ import annotations

from corollary.scenes.integrate.both_ways import ways

kernel, module = ways(__name__)
law, stages = module("row_law"), module("stages")
push, slope, step, TIME = law.push, law.slope, law.step, law.TIME
whole, falls_through_zero = stages.whole, stages.falls_through_zero
EVALUATIONS, STAGES = stages.EVALUATIONS, stages.STAGES

# Into so many parts a step is divided in which a force may rise between two falls, or fall between two rises.
PARTS = 4


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
