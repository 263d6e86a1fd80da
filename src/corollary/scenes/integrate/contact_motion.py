"""One contact between two spheres, damping and turning included, in a time stretched where the contact is young; a kernel.

With overlap = w^s and dt = s w^(s-1) d(sigma) the equations are polynomials in w, and the release is a simple zero of w, reached
exactly with w itself as the variable of the last step. The state is (w, its rate, share of the spin left, time, angle turned).

Everything is in units of the depth and the speed of the contact, which leaves pure numbers, its `groups`: (q, s, spring, drag,
across, thickness) with rate' = -spring x^q - drag rate - across^2 thickness share^2 / (1 - thickness x)^3, where x is the overlap.
"""

from __future__ import annotations

import math

from corollary.scenes.integrate.both_ways import ways

kernel, module = ways(__name__)
stages, law, events = module("stages"), module("row_law"), module("row_events")
stage, finish, error_size, factor = stages.stage, stages.finish, stages.error_size, stages.factor
whole, push, never_faster = stages.whole, law.push, events.never_faster
STAGES, EVALUATIONS = stages.STAGES, stages.EVALUATIONS

W, P, SPIN, TIME, TURN = 0, 1, 2, 3, 4
SIZE = 5
ENDED, STICKS, TOO_SOFT, TOO_LONG = 0, 1, 2, 3
# Rows of the room to work in: the slopes of the stages, then these.
AFTER, STATE = STAGES, STAGES + 1
ROOM = STAGES + 2
# The first step goes with the eighth root of the tolerance, the order of the method: two runs that began alike would share the errors
# of their first steps, and their difference would not show them.
FIRST_STEP, LONGEST_FIRST = 5.6, 0.5
# No step is longer than LONGEST tolerance^FINER / (LEAST + q), beyond LATE in proportion to the way that is gone: where the force sets in
# steeply, estimates of a few long ones are small by luck, in both runs alike.
LONGEST, FINER, LEAST, LATE = 5.5, 0.09, 2.0, 4.0
# Into so many parts a step is divided in which a force may rise between two falls, or fall between two rises.
PARTS = 4
# Centres nearer than this share of the reach: no contact law means anything there, and the turning, which grows as the inverse
# square of the distance, would leave doubles less than the twelve digits that are promised.
NEAREST = 1e-3


@kernel
def slope(y, out, groups, by_root):
    """The rate of change of the state, in stretched time or (`by_root`) in w."""
    q, s, spring, drag, across, thickness = groups
    w, rate, share = y[W], y[P], y[SPIN]
    x, pace = whole(w, s), s * whole(w, s - 1)
    near = 1.0 - thickness * x
    if near == 0.0:
        near = math.nan
    pushed = drag * rate + across * across * thickness * share * share / (near * near * near)
    if x > 0.0:
        pushed += push(spring, q, x)
    scale = 1.0
    if by_root:
        scale = 1.0 / rate if rate != 0.0 else math.nan
    out[W] = rate * scale
    out[P] = -pace * pushed * scale
    out[SPIN] = -pace * drag * share * scale
    out[TIME] = pace * scale
    out[TURN] = pace * across * thickness * share / (near * near) * scale


@kernel
def step(h, y, slopes, out, groups, by_root):
    """A step from y over h into `out`; the first of `slopes` is known. Gives the size of its error."""
    for i in range(1, STAGES):
        stage(i, h, y, slopes, out, 0, SIZE)
        slope(out, slopes[i], groups, by_root)
    fifth, third = finish(h, y, slopes, out, 0, SIZE)
    return error_size(fifth, third, h, SIZE)


@kernel
def force(y, groups):
    """The size of the force, its drag across the line of centres included."""
    q, s, spring, drag, across, thickness = groups
    x = whole(max(y[W], 0.0), s)
    elastic = push(spring, q, x) if x > 0.0 else 0.0
    return math.hypot(elastic + drag * y[P], drag * across * y[SPIN] / (1.0 - thickness * x))


@kernel
def force_growth(y, groups):
    """Half the rate of change of the force squared."""
    q, s, spring, drag, across, thickness = groups
    x, rate = whole(max(y[W], 0.0), s), y[P]
    near, elastic = 1.0 - thickness * x, push(spring, q, x) if x > 0.0 else 0.0
    pushed = elastic + drag * rate
    gained = -pushed - across * across * thickness * y[SPIN] * y[SPIN] / (near * near * near)
    stiffness = q * elastic / x if x > 0.0 else 0.0
    side = drag * across * y[SPIN] / near
    return pushed * (stiffness * rate + drag * gained) + side * side * (thickness * rate / near - drag)


@kernel
def sticks(y, groups):
    """Whether the contact will never end: the argument for two bodies on a line, the turning counted as a spring.

    It fades faster than the overlap, the more as the centres part, so what holds now holds for ever.
    """
    q, s, spring, drag, across, thickness = groups
    x, rate = whole(max(y[W], 0.0), s), y[P]
    near = 1.0 - thickness * x
    if drag == 0.0 or x == 0.0 or rate > 0.0 or near <= 0.0:
        return False
    turning = across * across * thickness * y[SPIN] * y[SPIN] / (x * near * near * near)
    return never_faster(drag, push(spring, q, x) / x + turning, -rate / x)


@kernel
def top_of(left, before, after, growth, h, y, groups, by_root, room):
    """The state where the rate (or, with `growth`, the growth of the force) falls through zero, into room[STATE].

    It is looked for within a step of length h, beyond its part `left`.

    A maximum is flat, so half the digits of its place give all those of its height. Illinois: an end that stays twice counts half.
    Gives the evaluations spent.
    """
    state, right, held, place, spent = room[STATE], 1.0, 0, 1.0, 0
    for _ in range(12):
        last, place = place, left + (right - left) * before / (before - after)
        step(place * h, y, room, state, groups, by_root)
        spent += EVALUATIONS
        here = force_growth(state, groups) if growth else state[P]
        if here == 0.0 or abs(place - last) < 1e-9:
            break
        if here > 0.0:
            left, before, after, held = place, here, after * (0.5 if held > 0 else 1.0), 1
        else:
            right, after, before, held = place, here, before * (0.5 if held < 0 else 1.0), -1
    return spent


@kernel
def follow(y, groups, tolerance, most, room):
    """Moves the state y to the end of the contact, in at most so many steps; `room` is ROOM states.

    Gives how it ended, the largest overlap, the largest force, and the evaluations.
    """
    q, s, _, _, _, thickness = groups
    after, state = room[AFTER], room[STATE]
    top_force, top_overlap, spent, gone = force(y, groups), whole(y[W], s), 0, 0.0
    longest = LONGEST * tolerance**FINER / (LEAST + q)
    h = min(FIRST_STEP * tolerance**0.125, LONGEST_FIRST, longest)
    for _ in range(most):
        if sticks(y, groups):
            return STICKS, top_overlap, top_force, spent
        by_root, length = False, h
        slope(y, room[0], groups, by_root)
        size = step(length, y, room, after, groups, by_root) / tolerance
        # A step that would pass the release ends there instead, with w as its variable; one out of all range has no place.
        if size < math.inf and not (after[W] > 0.0 or y[P] >= 0.0 or y[W] == 0.0):
            by_root, length = True, -y[W]
            slope(y, room[0], groups, by_root)
            size = step(length, y, room, after, groups, by_root) / tolerance
            after[W] = 0.0
        spent += STAGES
        if not size <= 1.0 or (after[W] <= 0.0 and not by_root):
            h *= min(0.5, factor(size))
            continue
        if y[P] > 0.0 >= after[P]:
            spent += top_of(0.0, y[P], after[P], False, length, y, groups, by_root, room)
            top_overlap, top_force = whole(state[W], s), max(top_force, force(state, groups))
        if max(top_overlap, whole(after[W], s)) * thickness > 1.0 - NEAREST:
            return TOO_SOFT, top_overlap, top_force, spent
        rising, falling, parts = force_growth(y, groups), force_growth(after, groups), 1
        if y[P] > 0.0 and (max(rising, falling) <= 0.0 or (min(rising, falling) > 0.0 > after[P])):
            # The drag fades first and the spring takes over: within one long step the force may fall, rise, and fall again; or it rises
            # to its maximum and falls until the drag pulls.
            parts = PARTS
        for i in range(1, parts + 1):
            here, growth = i * length / parts, falling
            if i < parts:
                step(here, y, room, state, groups, by_root)
                growth, spent = force_growth(state, groups), spent + EVALUATIONS
            if rising > 0.0 >= growth:
                spent += top_of((i - 1) / i, rising, growth, True, here, y, groups, by_root, room)
                top_force = max(top_force, force(state, groups))
            rising = growth
        for i in range(SIZE):
            y[i] = after[i]
        if by_root:
            return ENDED, top_overlap, top_force, spent
        gone += length
        h = min(h * factor(size), longest * max(1.0, gone / LATE))
    return TOO_LONG, top_overlap, top_force, spent
