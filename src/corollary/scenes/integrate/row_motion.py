"""A collision of bodies in a row, from its start to the last opening, each touch followed on its own variable; a kernel.

So a method of high order keeps its order where contacts begin and end, and the last step ends exactly where the bodies part.
"""

from __future__ import annotations

import math

from corollary.scenes.integrate.both_ways import ways

kernel, module = ways(__name__)
events, law, stages = module("row_events"), module("row_law"), module("stages")
active_part, settle, inactive = events.active_part, events.settle, events.inactive
first_touch, fly, suited, due = events.first_touch, events.fly, events.suited, events.due
nears_zero, crossing = events.nears_zero, events.crossing
stays, at_rest = events.stays, events.at_rest
push, slope, step, value_in, stride_for = law.push, law.slope, law.step, law.value_in, law.stride_for
conserved = law.conserved
damped_force, largest_force, largest_overlap = law.damped_force, law.largest_force, law.largest_overlap
factor, whole, error_size = stages.factor, stages.whole, stages.error_size
STAGES, EVALUATIONS, TIME = stages.STAGES, stages.EVALUATIONS, law.TIME

RELEASED, MISSED, STICKS, TOO_LONG, NO_STEP = 0, 1, 2, 3, 4
# Rows of the room to work in: the slopes of the stages, then these.
BASE, START, ENDS = STAGES, STAGES + 1, STAGES + 2
AFTER = STAGES + 5
ROOM = STAGES + 6
# From so many bodies on only those are followed that do not fly freely.
LONG = 14
# Beside the contacts at work so many more are followed, twice as many where the motion has reached the last of them.
MARGIN, REACHED = 3, 1e-18
# Errors are averaged over the variables, but in a long row only about so many are at work at a time.
AT_WORK = 12
MOST_TRIALS = 80
# The first stride goes with the eighth root of the tolerance, the order of the method: two runs that began alike would share the errors
# of their first steps, and their difference would not show them.
FIRST_STRIDE, LEAST_STRIDE = 1.6, 1e-12


@kernel
def try_step(variable, power, stride, time, y, touching, row, first, last, room):
    """A step of about `stride` from the state y; one toward zero ends there at most.

    Gives from where and how far it goes, whether it lands on zero, the time after it, and its size (to be divided by the tolerance).
    """
    base, start, ends, after, slopes = room[BASE], room[START], room[ENDS], room[AFTER], room
    x = value_in(variable, power, time, y)
    lands = variable != TIME and x * stride < 0.0 and abs(stride) >= abs(x)
    h = -x if lands else stride
    low, high, own = 2 * first, 2 * last + 1, 2 * variable + 1
    stretch, k0 = 1.0, slopes[0]
    if variable != TIME:
        if base[own] == 0.0:
            return x, h, lands, time, math.inf
        stretch = power * whole(x, power - 1) / base[own]
    for s in range(low, high):
        start[s] = y[s]
        k0[s] = stretch * base[s]
    if variable != TIME:
        start[own], k0[own] = time, stretch
    fifth, third = step(variable, power, x, h, start, slopes, ends, first, last, touching, row)
    for s in range(low, high):
        after[s] = ends[s]
    then = x + h
    if variable != TIME:
        then, after[own] = ends[own], whole(0.0 if lands else x + h, power)
    return x, h, lands, then, error_size(fifth, third, h, min(2 * len(touching) + 1, AT_WORK))


@kernel
def note_touches(time, y, touching, landed, first, last):
    """Say which contacts have opened or closed in the step just taken; gives how many opened, and how fast the slowest of them parts."""
    openings, parting = 0, math.inf
    for j in range(first, last):
        overlap = y[2 * j + 1]
        if touching[j] and (overlap < 0.0 or j == landed):
            touching[j] = False
            openings, parting = openings + 1, min(parting, y[2 * j + 2] - y[2 * j])
        elif not touching[j] and (overlap > 0.0 or j == landed):
            touching[j] = True
    return openings, parting


@kernel
def release_faint(time, y, touching, noise):
    """Contacts with too little left in them to matter end on their own, as if nothing pushed; gives how many, and when the last did."""
    openings, ended = 0, 0.0
    for j in range(len(touching)):
        overlap, opening = y[2 * j + 1], y[2 * j + 2] - y[2 * j]
        if touching[j] and overlap > 0.0:
            openings += 1
            ended = max(ended, time + (overlap / opening if opening > noise else 0.0))
            touching[j], y[2 * j + 1] = False, 0.0
    return openings, ended


@kernel
def note_peaks(variable, power, x, h, y, touching, row, first, last, deepest, hardest, room):
    """Look for the largest overlaps and forces within a step; gives the evaluations spent."""
    _, _, k, q, eta, _ = row
    base, start, ends, after, spent = room[BASE], room[START], room[ENDS], room[AFTER], 0
    for j in range(first, last):
        i = 2 * j
        if not (touching[j] and y[i + 1] >= 0.0 and after[i + 1] >= 0.0):
            continue
        if base[i + 1] > 0.0 >= after[i] - after[i + 2]:
            overlap, cost = largest_overlap(
                j, variable, power, x, h, start, ends, first, last, touching, row, room
            )
            spent += cost
            if overlap > deepest[j]:
                deepest[j] = overlap
                if eta[j] == 0.0:
                    hardest[j] = push(k[j], q[j], overlap)
        if eta[j] > 0.0:
            force, cost = largest_force(
                j, variable, power, x, h, start, y, after, base, first, last, touching, row, room
            )
            hardest[j], spent = max(hardest[j], force), spent + cost
    return spent


@kernel
def follow(y, touching, row, deepest, hardest, tolerance, most, room):
    """Moves the state y (at time zero) to the end of the collision, in at most so many steps.

    `deepest` and `hardest` become the largest overlap and force of each contact. `room` is ROOM rows as long as y. Gives how it ended
    and when it began to touch, when it last opened, the openings, the evaluations, and the strain (`RowResult`).
    """
    _, falls, k, q, eta, powers = row
    count, noise = len(k), max(1e-14, 3.0 * tolerance)
    base, after = room[BASE], room[AFTER]
    damped, heavy = False, False
    for j in range(count):
        damped, heavy = damped or eta[j] > 0.0, heavy or falls[j + 1] > 0.0
        touching[j] = y[2 * j + 1] >= 0.0
        deepest[j] = max(y[2 * j + 1], 0.0)
        hardest[j] = push(k[j], q[j], deepest[j]) if deepest[j] > 0.0 else 0.0
    partly = count + 1 >= LONG and not damped and not heavy
    time, began, ended, openings, spent = 0.0, math.inf, 0.0, 0, 0
    strain, opens = 0.0, 0.0
    begins = FIRST_STRIDE * tolerance**0.125
    variable, power, stride, lasted, landing = TIME, 1, 0.0, begins, False
    first, last, margin = 0, count, MARGIN
    for _ in range(most):
        settle(y, touching, first, last)
        # Before the inactive: a contact that its damping holds for ever soon has too little in it to be seen.
        if damped and stays(y, touching, row, tolerance):
            at_rest(y, touching, row, deepest, hardest)
            return STICKS, began, math.inf, openings, spent, strain
        if inactive(y, touching, row, first, last, noise):
            faint, at = release_faint(time, y, touching, noise)
            openings, ended = openings + faint, max(ended, at)
            meeting, wait = first_touch(y, falls, noise, began < math.inf)
            if meeting == TIME:
                outcome = RELEASED if began < math.inf else MISSED
                return outcome, began, ended, openings, spent, max(strain, opens)
            fly(y, touching, falls, meeting, wait)
            if began < math.inf:
                strain = max(strain, (1.0 + wait) / max(y[2 * meeting] - y[2 * meeting + 2], noise))
            time += wait
            variable, landing, lasted = TIME, False, begins
            first, last = 0, count
        began = min(began, time)
        if partly:
            first, last = active_part(y, touching, row, variable if landing else TIME, lasted, margin, noise)
        slope(TIME, 1, 0.0, y, base, first, last, touching, row)
        if damped:
            # A damped contact pushes at once when it closes: that may already be its largest force.
            for j in range(count):
                if eta[j] > 0.0 and touching[j] and y[2 * j + 1] >= 0.0:
                    hardest[j] = max(hardest[j], damped_force(y, j, row))
        landed_before = landing
        landing = landing and variable != TIME and nears_zero(y, base, variable, noise)
        variable_before, power_before, stride_before = variable, power, stride
        if not landing:
            variable = suited(y, base, touching, powers, first, last, lasted, noise)
            if variable == TIME:
                variable = due(y, base, touching, first, last, lasted, noise)
                landing = variable != TIME
            power = powers[variable] if variable != TIME and touching[variable] else 1
        stride = stride_for(variable, power, y, base, lasted)
        if variable == variable_before and power == power_before and 0.0 < abs(stride_before) < abs(stride):
            stride = stride_before
        if stride == 0.0:  # too short for this variable to tick
            variable, power, landing, stride = TIME, 1, False, lasted
        x, h, size, lands, then = 0.0, 0.0, math.inf, False, 0.0
        for trial in range(MOST_TRIALS + 1):
            if trial == MOST_TRIALS:
                return NO_STEP, began, ended, openings, spent, strain
            x, h, lands, then, size = try_step(
                variable, power, stride, time, y, touching, row, first, last, room
            )
            size /= tolerance
            spent += EVALUATIONS
            if not size <= 1.0:
                stride = h * factor(size)
                if landing and trial > 20:  # the speed turns before the bodies part: there is nowhere to land
                    variable, power, landing, stride = TIME, 1, False, 0.1 * lasted
                continue
            if (
                variable != TIME
                and (after[2 * variable] - after[2 * variable + 2]) * base[2 * variable + 1] < 0.0
            ):
                # The overlap turned on the way and no longer grows with time: beyond, time would run back.
                stride = 0.2 * h
                continue
            crossed, grazed = crossing(
                variable, y, base, after, then - time, touching, row, first, last, noise, tolerance
            )
            if trial < 60 and crossed == TIME and grazed:
                stride = 0.5 * h
                continue
            if crossed == TIME or trial > 60:
                break
            if base[2 * crossed + 1] != 0.0 and (base[2 * crossed + 1] < 0.0) == touching[crossed]:
                variable, landing = crossed, True
                power = powers[variable] if touching[variable] else 1
                stride = -value_in(variable, power, time, y)
            else:
                stride = 0.5 * h
        if partly:
            reached = first > 0 and abs(after[2 * first] - y[2 * first]) > REACHED
            if reached or (last < count and abs(after[2 * last] - y[2 * last]) > REACHED):
                margin, variable, power, stride = 2 * margin, variable_before, power_before, stride_before
                landing = landed_before
                continue
            margin = MARGIN
        spent += 1 + note_peaks(variable, power, x, h, y, touching, row, first, last, deepest, hardest, room)
        growth = factor(size)
        now = max((then - time) * growth, LEAST_STRIDE)
        lasted = max(now, lasted) if lands else now
        for s in range(2 * first, 2 * last + 1):
            y[s] = after[s]
        if partly:
            for j in range(count):
                if j < first or j >= last:
                    y[2 * j + 1] += (y[2 * j] - y[2 * j + 2]) * (then - time)
        time = then
        opened, parting = note_touches(time, y, touching, variable if lands else TIME - 1, first, last)
        if opened > 0:
            openings, ended, opens = openings + opened, time, 1.0 / max(parting, noise)
        landing, stride = landing and not lands, h * growth
        if lands:
            variable, power, stride = TIME, 1, 0.0
    return TOO_LONG, began, ended, openings, spent, strain


@kernel
def collide(y, touching, row, deepest, hardest, tolerance, most, room):
    """The same, and what it should have kept, before and after (`row_law.conserved`)."""
    before = conserved(y, row)
    seen = follow(y, touching, row, deepest, hardest, tolerance, most, room)
    return seen, before, conserved(y, row)
