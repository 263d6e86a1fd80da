"""Single contacts of many pairs of spheres at once, as numpy arrays: one run for a whole course.

The state is turned into an angle: w = rho sin(phase), its rate rho cos(phase), so that every contact lasts from phase 0 to pi and
all of them take the same steps.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from corollary.scenes.forces.contact import Contact, smoothing_power
from corollary.scenes.integrate.array_steps import power, stepped
from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.single_contact import follow
from corollary.scenes.models.pair import Pair, after_parting, meet
from corollary.scenes.run import BadSetting

Array = NDArray[np.floating]

# A pair whose error is larger than this takes more steps, then is followed alone; so is one squeezed to more than this of its reach.
WORST, DEEP = 1e-7, 0.9
# The least order of shrinking that is believed, how much more than it promises is stated, and what rounding leaves of a contact.
CONFIRMED, SAFE, ROUNDING = 4.0, 12.0, 1e-13


@dataclass(frozen=True, slots=True)
class Pairs:
    """n pairs: mass (reduced), reach, k, eta are (n,); apart and relative (of B seen from A) are (n, 2); q is shared."""

    mass: Array
    reach: Array
    k: Array
    eta: Array
    apart: Array
    relative: Array
    q: float = 1.5


@dataclass(frozen=True, slots=True)
class Swarm:
    """Relative velocities after the contact, (n, 2), and a bound on the error of each in units of the speed before, (n,).

    `missed` says which pairs never met, `alone` which had to be followed one by one: damped too much for equal steps, or
    touching at the start, or very soft. Those of `soft` pass through each other; they have no velocity (nan).
    """

    relative: Array
    errors: Array
    missed: NDArray[np.bool_]
    alone: NDArray[np.bool_]
    soft: NDArray[np.bool_]


def collide_many(pairs: Pairs, steps: int = 12) -> Swarm:
    """Each pair takes 2 `steps` steps of order 8 and, to know the error, `steps` and 1.4 `steps` more; twice and four times as
    many where the error is still more than `WORST`.

    Raises GuardFailed when a pair that has to be followed alone comes to no end.
    """
    (x, y), (u, v) = pairs.apart.T, pairs.relative.T
    speed, spin, radial = np.hypot(u, v), x * v - y * u, x * u + y * v
    inside = np.hypot(x, y) < pairs.reach
    missed = ~inside & ((radial >= 0.0) | (np.abs(spin) >= pairs.reach * speed))
    relative, soft = pairs.relative.astype(float), np.zeros_like(missed)
    errors = np.where(missed, 0.0, np.inf)
    for count in (steps, 2 * steps, 4 * steps):
        left = np.flatnonzero(~inside & ~(errors < WORST))
        if left.size:
            relative[left], errors[left] = _together(_some(pairs, left), count)
    alone = ~(errors < WORST)
    for i in np.flatnonzero(alone):
        found = _one(pairs, int(i))
        soft[i] = found is None
        relative[i], errors[i] = found or ((math.nan, math.nan), math.inf)
    return Swarm(relative, errors, missed, alone, soft)


def _some(pairs: Pairs, which: NDArray[np.intp]) -> Pairs:
    each = (pairs.mass, pairs.reach, pairs.k, pairs.eta, pairs.apart, pairs.relative)
    return Pairs(*(values[which] for values in each), q=pairs.q)


def _together(pairs: Pairs, steps: int) -> tuple[Array, Array]:
    """Relative velocities and their errors (nan where equal steps are not enough) of pairs that all come to touch."""
    (x, y), (u, v) = pairs.apart.T, pairs.relative.T
    speed, spin = np.hypot(u, v), x * v - y * u
    counts = (steps, round(1.4 * steps), 2 * steps)
    with np.errstate(all="ignore"):
        inward = (
            np.sqrt((pairs.reach * speed - np.abs(spin)) * (pairs.reach * speed + np.abs(spin))) / pairs.reach
        )
        depth = _depth(pairs, inward, spin)
        groups = _Groups(
            q=pairs.q,
            s=smoothing_power(Contact(1.0, pairs.q)),
            spring=pairs.k * depth ** (pairs.q + 1.0) / (pairs.mass * inward**2),
            drag=pairs.eta * depth / (pairs.mass * inward),
            across=spin / (pairs.reach * inward),
            thickness=depth / pairs.reach,
        )
        coarse, middle, fine = (
            _turned(pairs, groups, inward, spin, speed, _through(groups, n)) for n in counts
        )
        errors = _error(np.hypot(*(fine - coarse).T) / speed, np.hypot(*(fine - middle).T) / speed, counts)
    return fine, np.where(depth > DEEP * pairs.reach, np.nan, errors)


def _error(coarse: Array, middle: Array, counts: tuple[int, int, int]) -> Array:
    """A bound on the error of the finest of three runs, from how far the other two are from it.

    The distance of the coarsest is a sure bound, but a thousand times too large. Where the two distances shrink with an order of
    `CONFIRMED` at least, the error is taken to do so too (at order 8 at most), and SAFE times that is the bound.
    """
    few, some, many = counts
    order = np.log(coarse / middle) / math.log(some / few)
    trusted = np.clip(order, 0.0, float(DOP853.order))
    promised = SAFE * np.maximum(coarse * (few / many) ** trusted, middle * (some / many) ** trusted)
    return np.where(order >= CONFIRMED, np.minimum(promised, coarse), coarse) + ROUNDING


@dataclass(frozen=True, slots=True)
class _Groups:
    """The pure numbers of `single_contact`, an array of each."""

    q: float
    s: int
    spring: Array
    drag: Array
    across: Array
    thickness: Array


def _depth(pairs: Pairs, inward: Array, spin: Array) -> Array:
    """About the largest overlap: where spring and turning, or the dashpot, have used up the speed."""
    p = pairs.q + 1.0
    stiff, turning = 2.0 * pairs.k / (p * pairs.mass), 2.0 * spin**2 / pairs.reach**3
    x = np.minimum((inward**2 / stiff) ** (1.0 / p), inward**2 / turning)
    for _ in range(12):  # from above on a convex curve: every step stays above the root
        x = x - (stiff * x**p + turning * x - inward**2) / (stiff * p * x ** (p - 1.0) + turning)
    return np.where(
        pairs.eta > 0.0, np.minimum(x, pairs.mass * inward / np.where(pairs.eta > 0.0, pairs.eta, 1.0)), x
    )


def _through(groups: _Groups, steps: int) -> Array:
    """Rate at the release, share of the spin left, angle turned: (3, n)."""
    s, whole = groups.s, round(groups.s * groups.q)
    smooth = abs(s * groups.q - whole) < 1e-12
    turning = groups.across * groups.thickness

    def slope(phase: float, state: Array) -> tuple[Array, Array, Array]:
        rho, share, _ = state
        sine, cosine = math.sin(phase), math.cos(phase)
        w, rate = rho * sine, rho * cosine
        pace, spring = s * power(w, s - 1), power(w, whole) if smooth else w ** (s * groups.q)
        near = 1.0 - groups.thickness * power(w, s)
        across = groups.across * share / near
        push = pace * (
            groups.spring * spring + groups.drag * rate + groups.thickness * across * across / near
        )
        ahead = rate * cosine + push * sine
        # Where the phase stands still the pair sticks, or nearly.
        per = np.where(ahead > 0.0, rho, np.nan) / ahead
        paced = pace * per
        return (
            (rate * sine - push * cosine) * per,
            -groups.drag * share * paced,
            turning * share / near**2 * paced,
        )

    return stepped(
        slope, np.stack([np.ones_like(groups.spring)] * 2 + [np.zeros_like(groups.spring)]), math.pi, steps
    )


def _turned(pairs: Pairs, groups: _Groups, inward: Array, spin: Array, speed: Array, passed: Array) -> Array:
    """Relative velocities from what the contact left; the directions come from the line of flight, not from places."""
    rate, share, turn = passed
    u, v = pairs.relative.T / speed
    along, level = -inward / speed, -spin / (pairs.reach * speed)
    # The direction of B at the touch, turned on by the contact.
    c0, s0 = along * u - level * v, along * v + level * u
    c, s = c0 * np.cos(turn) - s0 * np.sin(turn), s0 * np.cos(turn) + c0 * np.sin(turn)
    outward, across = rate * inward, share * spin / pairs.reach
    return np.stack([outward * c - across * s, outward * s + across * c], axis=1)


def _one(pairs: Pairs, i: int) -> tuple[tuple[float, float], float] | None:
    """A pair followed alone, twice for the error; none when the spheres pass through each other."""
    (x, y), (u, v) = pairs.apart[i].tolist(), pairs.relative[i].tolist()
    m = 2.0 * float(pairs.mass[i])
    pair = Pair(
        m, m, (x, y), (u, v), float(pairs.reach[i]), Contact(float(pairs.k[i]), pairs.q, float(pairs.eta[i]))
    )
    met = meet(pair)
    if met is None:
        return (u, v), 0.0
    try:
        coarse, fine = (
            after_parting(pair, met, follow(pair, met, tolerance)) for tolerance in (1e-11, 1e-12)
        )
    except BadSetting:
        return None
    return fine, math.dist(coarse, fine) / math.hypot(u, v) + ROUNDING
