"""Contacts of a row that begin, end, or stay for ever by damping, and which bodies take part at all; a kernel."""

from __future__ import annotations

import math

from corollary.scenes.integrate.both_ways import ways

kernel, module = ways(__name__)
law = module("row_law")
push, stored, TIME = law.push, law.stored, law.TIME

# A step in time must leave so much of an overlap whose force is not smooth where it ends: nearer to the end the error of the step
# would not be known. The contact's own variable takes over.
NEAR_CONTACT = 0.3
# What changes a speed by less is not followed: in a long row it runs ahead of the wave, ball by ball, far below the last digit of any speed.
FAINT = 1e-18
# Steps grow five times at most; a gap that closes within twenty of them takes part.
SOON = 20.0


@kernel
def active_part(y, touching, row, own, lasting, margin, noise):
    """The contacts first … last - 1 outside of which every body flies freely for a while, with so many beside them; `own` is one of them."""
    inverse, _, k, q, _, _ = row
    first, last, count = len(k), 0, len(k)
    for j in range(count):
        closing, overlap = y[2 * j] - y[2 * j + 2], y[2 * j + 1]
        if touching[j]:
            on = closing > FAINT or closing < -FAINT
            if not on and overlap > 0.0:
                on = push(k[j], q[j], overlap) * max(inverse[j], inverse[j + 1]) > FAINT
        else:
            on = closing > noise and -overlap < SOON * lasting * closing
        if on or j == own:
            first, last = min(first, j), j + 1
    if last == 0:
        return 0, count
    return max(first - margin, 0), min(last + margin, count)


@kernel
def settle(y, touching, first, last):
    """Where bodies just touch, the speed says whether the contact begins or has ended."""
    for j in range(first, last):
        if y[2 * j + 1] == 0.0:
            touching[j] = y[2 * j] >= y[2 * j + 2]


@kernel
def inactive(y, touching, row, first, last, noise):
    """Whether no contact pushes or is about to: all are open, or touch without closing and with too little stored to matter.

    `noise` is the speed that cannot be told from none; where a dashpot brings it about, closing has to end first: it decides
    whether the contact opens at all.
    """
    inverse, falls, k, q, eta, _ = row
    for j in range(first, last):
        if touching[j]:
            closing, overlap, fall = y[2 * j] - y[2 * j + 2], y[2 * j + 1], falls[j + 1] - falls[j]
            if closing > (0.0 if eta[j] > 0.0 and overlap > 0.0 else noise) or (
                fall > 0.0 and closing >= 0.0
            ):
                return False
            faint = 0.0 if fall > 0.0 else 0.5 * noise * noise / (inverse[j] + inverse[j + 1])
            if stored(k[j], q[j], overlap) > faint:
                return False
    return True


@kernel
def first_touch(y, falls, noise, bounced):
    """The contact that closes next and after how long (TIME: none does), every contact open.

    After a bounce, bodies that only weight would bring back together count as released, unless others are still to meet later.
    """
    best, after, falling, lands = TIME, math.inf, TIME, math.inf
    for j in range(len(falls) - 1):
        gap, closing, fall = max(-y[2 * j + 1], 0.0), y[2 * j] - y[2 * j + 2], falls[j + 1] - falls[j]
        if closing <= noise and fall <= 0.0:
            continue
        square = closing * closing + 2.0 * fall * gap
        if square < 0.0:
            continue
        # The root free of cancellation, whichever sign the closing speed has.
        root = math.sqrt(square)
        wait = 2.0 * gap / (closing + root) if closing > 0.0 else (root - closing) / fall
        if closing <= noise and bounced:
            if wait < lands:
                falling, lands = j, wait
        elif wait < after:
            best, after = j, wait
    if lands < after < math.inf:
        return falling, lands
    return best, after


@kernel
def fly(y, touching, falls, meeting, wait):
    """On to the meeting of two bodies, all others apart."""
    count = len(falls) - 1
    for j in range(count):
        fall = falls[j + 1] - falls[j]
        y[2 * j + 1] = min(y[2 * j + 1] + (y[2 * j] - y[2 * j + 2]) * wait + 0.5 * fall * wait * wait, 0.0)
        touching[j] = j == meeting
    y[2 * meeting + 1] = 0.0
    for i in range(count + 1):
        y[2 * i] -= falls[i] * wait


@kernel
def turns(y, base, j):
    """Whether an overlap on its way to zero would turn before, if its acceleration stayed as it is."""
    rate, growth = base[2 * j + 1], base[2 * j] - base[2 * j + 2]
    return growth * rate < 0.0 and rate * rate < 2.0 * abs(y[2 * j + 1] * growth)


@kernel
def nears_zero(y, base, j, noise):
    """Whether the overlap that is the variable still moves toward zero; its speed may have faded or turned on the way."""
    rate = base[2 * j + 1]
    return abs(rate) > noise and (rate < 0.0) == (y[2 * j + 1] > 0.0) and not turns(y, base, j)


@kernel
def suited(y, base, touching, power, first, last, lasting, noise):
    """The contact whose overlap is nearest in time to its beginning or end, if its speed will not turn soon; else the time.

    Further off than two steps (`lasting` each) the beginning or end is not felt: the time does as well and costs less.
    """
    best, nearest = TIME, 2.0 * lasting
    for j in range(first, last):
        overlap, speed = y[2 * j + 1], abs(base[2 * j + 1])
        if not touching[j] or power[j] == 1 or overlap < 0.0 or speed <= noise:
            continue
        steady = overlap * abs(base[2 * j] - base[2 * j + 2]) < 0.3 * speed * speed
        if steady and overlap < nearest * speed:
            best, nearest = j, overlap / speed
    return best


@kernel
def due(y, base, touching, first, last, lasting, noise):
    """The contact that is sure to begin or end next, within so long; TIME when its speed may turn before."""
    best, soonest = TIME, lasting
    for j in range(first, last):
        overlap, speed = y[2 * j + 1], base[2 * j + 1]
        if (overlap > 0.0 and speed < -noise) if touching[j] else (overlap < 0.0 and speed > noise):
            after = -overlap / speed
            if after < soonest and abs(overlap * (base[2 * j] - base[2 * j + 2])) < 0.3 * speed * speed:
                best, soonest = j, after
    return best


@kernel
def crossing(variable, y, base, after, lasted, touching, row, first, last, noise, tolerance):
    """The contact that begins or ends first in a step (TIME: none), and whether one may have passed zero and come back.

    Too slow ones change nothing that can be seen. The second is judged by a parabola, so it errs on shorter steps.
    """
    _, _, k, q, _, power = row
    found, when, grazed = TIME, 2.0, False
    for j in range(first, last):
        old, new, on = y[2 * j + 1], after[2 * j + 1], touching[j]
        before, then = base[2 * j + 1], after[2 * j] - after[2 * j + 2]
        sign = 1.0 if on else -1.0
        if sign * before < 0.0 < sign * then:
            grazed = grazed or sign * old < 0.5 * before * before * lasted / abs(then - before)
        if j == variable or (abs(before) <= noise and abs(then) <= noise):
            continue
        ends = new > 0.0
        if on:
            ends = new < 0.0 < old
            if (
                not ends
                and variable == TIME
                and power[j] > 1
                and old > 0.0 > then
                and new < NEAR_CONTACT * old
            ):
                ends = push(k[j], q[j], old) * lasted > tolerance and not turns(y, base, j)
        if ends and old / (old - new) < when:
            found, when = j, old / (old - new)
    return found, grazed


@kernel
def never_faster(drag, spring, z):
    """Whether z is below the larger root of z^2 - drag z + spring."""
    room = drag * drag - 4.0 * spring
    return room > 0.0 and z < 0.5 * (drag + math.sqrt(room))


@kernel
def holds(y, touching, row):
    """Whether two bodies that touch will do so for ever, if no others do.

    Certain for a single damped contact that opens: with z = -rate/overlap, dz/dt = z^2 - (eta/mu) z + (k/mu) overlap^(q-1): once z is
    below the larger root it stays there, and the overlap fades exponentially at most; weight on a floor makes z smaller still.
    Certain on a floor, too, when the energy left does not lift the ball. Of several damped contacts nothing is certain.
    """
    inverse, falls, k, q, eta, _ = row
    live, many = TIME, 0
    for j in range(len(k)):
        if touching[j]:
            if eta[j] == 0.0:
                return False
            live, many = j, many + 1
    if many != 1:
        return False
    overlap, rate = y[2 * live + 1], y[2 * live] - y[2 * live + 2]
    mass, fall = 1.0 / (inverse[live] + inverse[live + 1]), falls[live + 1] - falls[live]
    drag, spring, power = eta[live] / mass, k[live] / mass, q[live] - 1.0
    if overlap <= 0.0:
        return False
    if rate > 0.0:
        # It creeps down to its resting overlap without ever passing it: the same argument, seen from there. Slowing down is a push
        # above its weight, which has seen its largest once it falls.
        rest = (fall / spring) ** (1.0 / q[live]) if fall > 0.0 else 0.0
        pushed = spring * overlap ** q[live] + drag * rate
        if (
            overlap >= rest
            or pushed < fall
            or spring * q[live] * overlap**power * rate > drag * (pushed - fall)
        ):
            return False
        return never_faster(drag, spring * q[live] * rest**power, rate / (rest - overlap))
    if fall > 0.0 and 0.5 * mass * rate * rate + stored(k[live], q[live], overlap) < mass * fall * overlap:
        return True
    return never_faster(drag, spring * overlap**power, -rate / overlap)


@kernel
def stays(y, touching, row, tolerance):
    """Whether the bodies that touch will touch for ever, and no others will: overlaps and forces have seen their largest, or do so at rest."""
    for j in range(len(touching)):
        if not touching[j] and y[2 * j] - y[2 * j + 2] > tolerance:
            return False
    return holds(y, touching, row)


@kernel
def at_rest(y, touching, row, deepest, hardest):
    """Gives every chain of touching bodies its common velocity, and every contact in it the overlap to which weight squeezes it, and that force."""
    inverse, falls, k, q, _, _ = row
    count, start = len(k), 0
    while start <= count:
        stop, wall, mass, carried = start, TIME, 0.0, 0.0
        while True:
            if inverse[stop] == 0.0:
                wall = stop
            else:
                mass, carried = mass + 1.0 / inverse[stop], carried + y[2 * stop] / inverse[stop]
            if stop == count or not touching[stop]:
                break
            fall = falls[stop + 1] - falls[stop]
            if fall > 0.0:
                weighs = fall / (inverse[stop] + inverse[stop + 1])
                deepest[stop] = max(deepest[stop], (weighs / k[stop]) ** (1.0 / q[stop]))
                hardest[stop] = max(hardest[stop], weighs)
            stop += 1
        together = y[2 * wall] if wall != TIME else carried / mass
        for i in range(start, stop + 1):
            y[2 * i] = together
        start = stop + 1
