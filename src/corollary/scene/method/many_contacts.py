"""Single contacts of many pairs of spheres at once, as numpy arrays: one run for a whole course.

The state is turned into an angle: w = rho sin(phase), its rate rho cos(phase), so that every contact lasts from phase 0 to pi and
all of them take the same steps.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from corollary.scene.force.contact import Contact, smoothing_power
from corollary.scene.method.dop853 import DOP853
from corollary.scene.method.runge_kutta import step
from corollary.scene.method.single_contact import follow
from corollary.scene.model.pair import Pair, after_parting, meet

Array = NDArray[np.floating]

# A pair whose error is larger than this after equal steps is followed alone.
WORST = 1e-5


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
    """Relative velocities after the contact, (n, 2), and the error of each in units of the speed before, (n,).

    `missed` says which pairs never met, `alone` which had to be followed one by one: damped too much for equal steps, or
    touching at the start.
    """

    relative: Array
    errors: Array
    missed: NDArray[np.bool_]
    alone: NDArray[np.bool_]


def collide_many(pairs: Pairs, steps: int = 12) -> Swarm:
    """Each pair takes 2 `steps` steps of order 8 and, for the error, `steps` more."""
    (x, y), (u, v) = pairs.apart.T, pairs.relative.T
    speed, spin, radial = np.hypot(u, v), x * v - y * u, x * u + y * v
    room = (pairs.reach * speed - np.abs(spin)) * (pairs.reach * speed + np.abs(spin))
    inside = np.hypot(x, y) < pairs.reach
    missed = ~inside & ((radial >= 0.0) | (room <= 0.0))
    with np.errstate(all="ignore"):
        inward = np.sqrt(room) / pairs.reach
        depth = _depth(pairs, inward, spin)
        groups = _Groups(
            q=pairs.q,
            s=smoothing_power(Contact(1.0, pairs.q)),
            spring=pairs.k * depth ** (pairs.q + 1.0) / (pairs.mass * inward**2),
            drag=pairs.eta * depth / (pairs.mass * inward),
            across=spin / (pairs.reach * inward),
            thickness=depth / pairs.reach,
        )
        coarse, fine = (_turned(pairs, groups, inward, spin, speed, _through(groups, n)) for n in (steps, 2 * steps))
        errors = np.hypot(*(fine - coarse).T) / speed
    alone = ~missed & (inside | ~(errors < WORST))
    relative = np.where(missed[:, None], pairs.relative, fine)
    for i in np.flatnonzero(alone):
        relative[i], errors[i] = _one(pairs, int(i))
    return Swarm(relative, np.where(missed, 0.0, errors), missed, alone)


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
    return np.where(pairs.eta > 0.0, np.minimum(x, pairs.mass * inward / np.where(pairs.eta > 0.0, pairs.eta, 1.0)), x)


def _through(groups: _Groups, steps: int) -> tuple[Array, Array, Array]:
    """Rate at the release, share of the spin left, angle turned."""
    s, q = groups.s, groups.q

    def slope(phase: float, state: list[Array]) -> list[Array]:
        rho, share, _ = state
        sine, cosine = math.sin(phase), math.cos(phase)
        w, rate = rho * sine, rho * cosine
        x, pace = w**s, s * w ** (s - 1)
        near = 1.0 - groups.thickness * x
        push = groups.spring * x**q + groups.drag * rate + groups.across**2 * groups.thickness * share**2 / near**3
        ahead = (rate * rate + w * pace * push) / rho**2
        ahead = np.where(ahead > 0.0, ahead, np.nan)  # the phase stands still: this pair sticks, or nearly
        return [
            (w * rate - rate * pace * push) / rho / ahead,
            -pace * groups.drag * share / ahead,
            pace * groups.across * groups.thickness * share / near**2 / ahead,
        ]

    ones = np.ones_like(groups.spring)
    state, h = [ones, ones, 0.0 * ones], math.pi / steps
    for i in range(steps):
        state, _ = step(DOP853, slope, i * h, state, h, slope(i * h, state))  # pyright: ignore[reportArgumentType]
    return state[0], state[1], state[2]  # pyright: ignore[reportReturnType]


def _turned(
    pairs: Pairs, groups: _Groups, inward: Array, spin: Array, speed: Array, passed: tuple[Array, Array, Array]
) -> Array:
    """Relative velocities from what the contact left; the directions come from the line of flight, not from places."""
    rate, share, turn = passed
    u, v = pairs.relative.T / speed
    along, level = -inward / speed, -spin / (pairs.reach * speed)
    # The direction of B at the touch, turned on by the contact.
    c0, s0 = along * u - level * v, along * v + level * u
    c, s = c0 * np.cos(turn) - s0 * np.sin(turn), s0 * np.cos(turn) + c0 * np.sin(turn)
    outward, across = rate * inward, share * spin / pairs.reach
    return np.stack([outward * c - across * s, outward * s + across * c], axis=1)


def _one(pairs: Pairs, i: int) -> tuple[tuple[float, float], float]:
    """A pair followed alone, twice for the error."""
    (x, y), (u, v) = pairs.apart[i].tolist(), pairs.relative[i].tolist()
    m = 2.0 * float(pairs.mass[i])
    pair = Pair(m, m, (x, y), (u, v), float(pairs.reach[i]), Contact(float(pairs.k[i]), pairs.q, float(pairs.eta[i])))
    met = meet(pair)
    if met is None:
        return (u, v), 0.0
    coarse, fine = (after_parting(pair, met, follow(pair, met, tolerance)) for tolerance in (1e-11, 1e-12))
    return fine, max(math.dist(coarse, fine) / math.hypot(u, v), 2e-15)
