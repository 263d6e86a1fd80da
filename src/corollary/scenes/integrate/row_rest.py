"""Rest by damping in a row: bodies that touch for ever, and the least duration of a collision; a kernel."""

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
def creep(y, touching, row, tolerance):
    """Whether bodies without weight that touch part so slowly that they never do, or not before what they move has faded to the tolerance."""
    falls, start, count = row[1], 0, len(touching)
    for j in range(count + 1):
        if j < count and falls[j + 1] != falls[j]:
            return False
        if j == count or not touching[j]:
            if j > start and not creeps(y, row, start, j, tolerance):
                return False
            start = j + 1
    return True


@kernel
def creeps(y, row, start, stop, tolerance):
    """The same of one chain: that of the contacts start … stop - 1, all alike.

    With A the matrix that makes accelerations of overlaps from forces F = k d^q + eta d', F' = -eta A F + k q d^(q-1) (F - k d^q)/eta.
    Off its diagonal A is negative, so that bounds of F hold as long as they do one by one: F <= 0, and F >= -g s with A s = 1
    if g is at least 2 q k^2 h^(2q-1)/eta^2, where h is the largest overlap, and fades as that. All overlaps then fade as by k d^q/eta alone,
    but for what g s takes from the least of them.
    """
    inverse, _, k, q, eta, _ = row
    highest, least, mass, middle, wall = 0.0, math.inf, 0.0, 0.0, TIME
    for i in range(start, stop + 1):
        if inverse[i] == 0.0:
            wall = i
        else:
            mass, middle = mass + 1.0 / inverse[i], middle + i / inverse[i]
    middle = float(wall) if wall != TIME else middle / mass
    power, viscous, weight, heaviest, pulled, pushed = q[start], eta[start], 0.0, 0.0, 0.0, 0.0
    for j in range(start, stop):
        overlap, rate = y[2 * j + 1], y[2 * j] - y[2 * j + 2]
        alike = k[j] == k[start] and q[j] == power and eta[j] == viscous
        if not alike or overlap <= 0.0 or rate > 0.0:
            return False
        if j == wall:
            weight = 0.0
            for i in range(j + 1, stop + 1):
                weight += (i - j) / inverse[i]
        else:
            weight += (middle - j) / inverse[j]
        if weight <= 0.0:
            return False
        force = push(k[j], power, overlap) + viscous * rate
        pulled, pushed = max(pulled, -force / weight), max(pushed, force / weight)
        highest, least, heaviest = max(highest, overlap), min(least, overlap), max(heaviest, weight)
    largest, slow = push(k[start], power, highest), heaviest / (viscous * viscous)
    # What errors of steps leave of a push is over soon.
    if (3.0 * power - 1.0) * largest / highest * slow > 0.5 or 200.0 * pushed * heaviest * slow > least:
        return False
    pulled = max(pulled, 2.2 * power * largest / highest * largest / (viscous * viscous))
    fades = -math.log(tolerance)
    if power > 1.0:
        fades = min(fades, 1.0 / (power - 1.0))
    return least > 1.1 * highest * pulled * heaviest / largest * fades


@kernel
def holds(y, touching, row, tolerance):
    """Whether the bodies that touch will do so for ever, if no others do.

    Certain for a single damped contact that opens: with z = -rate/overlap, dz/dt = z^2 - (eta/mu) z + (k/mu) overlap^(q-1): once z is
    below the larger root it stays there, and the overlap fades exponentially at most; weight on a floor makes z smaller still.
    Certain on a floor, too, when the energy left does not lift the ball. For several damped contacts: when all have come to rest
    within the tolerance, or `creep`.
    """
    inverse, falls, k, q, eta, _ = row
    live, many, resting = TIME, 0, True
    for j in range(len(k)):
        rate = y[2 * j] - y[2 * j + 2]
        if touching[j]:
            if eta[j] == 0.0:
                return False
            live, many = j, many + 1
            resting = resting and y[2 * j + 1] > 0.0 and abs(rate) < tolerance
    if many != 1:
        return many > 1 and (resting or creep(y, touching, row, tolerance))
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
    return holds(y, touching, row, tolerance)


@kernel
def mean_and_energy(y, row, first, last):
    """The velocity of a wall, or of the centre of mass, of bodies that push none but each other, and their energy seen from there."""
    inverse, _, k, q, _, _ = row
    momentum, mass = 0.0, 0.0
    for i in range(first, last + 1):
        if inverse[i] > 0.0:
            momentum, mass = momentum + y[2 * i] / inverse[i], mass + 1.0 / inverse[i]
    mean, energy = momentum / mass if mass > 0.0 else 0.0, 0.0
    for i in range(first, last + 1):
        if inverse[i] == 0.0:
            mean = y[2 * i]
    for i in range(first, last + 1):
        if inverse[i] > 0.0:
            energy += 0.5 * (y[2 * i] - mean) * (y[2 * i] - mean) / inverse[i]
    for j in range(first, last):
        energy += stored(k[j], q[j], y[2 * j + 1])
    return mean, energy


@kernel
def gone(y, touching, row, first, last, end):
    """Whether the body at one `end` leaves the others faster than any of them can get."""
    inverse, low, high, joint, way = row[0], first, last - 1, last - 1, 1.0
    if end == first:
        low, high, joint, way = first + 1, last, first, -1.0
    if touching[joint]:
        return False
    (mean, energy), lightest = mean_and_energy(y, row, low, high), 0.0
    for i in range(low, high + 1):
        lightest = max(lightest, inverse[i])
    return way * (y[2 * end] - mean) > math.sqrt(2.0 * energy * lightest)


@kernel
def lasts_at_least(y, touching, row, tolerance):
    """How long it takes at least until no two bodies come nearer to each other; zero where damping or weight leaves no bound.

    No contact pulls, or pushes harder than all of the energy, seen from the centre of mass or from a wall, can squeeze it; what is gone for
    good has no part in it. Where all that touch are damped and stay together, half as long as the next one takes to come.
    """
    inverse, falls, k, q, eta, _ = row
    count, damped, comes = len(k), False, math.inf
    for j in range(count):
        closing = y[2 * j] - y[2 * j + 2]
        if falls[j + 1] > 0.0:
            return 0.0
        damped = damped or eta[j] > 0.0
        if not touching[j] and closing > tolerance:
            comes = min(comes, -0.5 * y[2 * j + 1] / closing)
    if damped:
        return comes if comes < math.inf and holds(y, touching, row, tolerance) else 0.0
    first, last, hardest, longest = 0, count, 0.0, 0.0
    while last > first and gone(y, touching, row, first, last, last):
        last -= 1
    while last > first and gone(y, touching, row, first, last, first):
        first += 1
    _, energy = mean_and_energy(y, row, first, last)
    for j in range(first, last):
        hardest = max(hardest, push(k[j], q[j], ((q[j] + 1.0) * energy / k[j]) ** (1.0 / (q[j] + 1.0))))
    for i in range(first, last + 1):
        for j in range(i + 1, last + 1):
            if y[2 * i] > y[2 * j] and inverse[i] + inverse[j] > 0.0:
                longest = max(longest, (y[2 * i] - y[2 * j]) / (inverse[i] + inverse[j]))
    return longest / hardest if hardest > 0.0 else 0.0


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
