"""Rest by damping of two bodies that touch for ever; a kernel."""

from __future__ import annotations

import math

from corollary.scenes.integrate.both_ways import ways

kernel, module = ways(__name__)
law = module("row_law")
push, stored, TIME = law.push, law.stored, law.TIME


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
