"""Bodies in a plane that push each other, followed in plain time and Cartesian places: nothing of how the scenes themselves go about it.

A step ends where a contact begins or ends. What starts or ends with the power 3/2 is neared and left in steps as short as their error
asks for.
"""

# pyright: reportMissingParameterType=false, reportUnknownParameterType=false, reportUnknownArgumentType=false, reportUnknownVariableType=false, reportUnknownMemberType=false, reportUntypedFunctionDecorator=false, reportOptionalSubscript=false, reportOptionalMemberAccess=false

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from ready.law import (
    CHANGE,
    CORE,
    FARTHEST,
    GROWTH,
    INNER,
    NEAREST,
    OUTER,
    PARTS,
    REACH,
    A,
    B,
    get,
    largest,
    left_of,
    located,
    put,
    seen,
    stepped,
    watched,
)
from ready.twofold import compiled, minus, number, pair, plus, times


@compiled
def turned_back(y, n, contact):
    """An elastic hit on the core of the first body, which is held."""
    nx, nz, _, _, _, rate = seen(y, n, contact)
    b = 2 * n + 2 * int(contact[B])
    twice = 2.0 * rate[0], 2.0 * rate[1]
    put(y, b, minus(get(y, b), times(twice, nx)))
    put(y, b + 1, minus(get(y, b + 1), times(twice, nz)))


@compiled
def noted(y, n, contact, t, turns, count):
    """The time and the relative place at a turn of the first contact."""
    a, b = int(contact[A]), int(contact[B])
    for i, value in (
        (0, t),
        (1, minus(get(y, 2 * b), get(y, 2 * a))),
        (2, minus(get(y, 2 * b + 1), get(y, 2 * a + 1))),
    ):
        turns[count, i, 0], turns[count, i, 1] = value


@compiled
def follow(y, n, inverse, gravity, contacts, acts, scale, until, longest, pressed, turns, best, work, most):
    """Moves `y` to the time `until`; or, if that is infinite, to where no contact acts and none comes, or all `turns` are filled.

    Gives (first touch, last change, end) and how often a contact changed, -1 if it took too many steps. `turns` gets time and place of the
    turns of the first contact's distance, `best` the largest overlap and force squared. `scale` is what a step may be off in places and in speeds, `longest` a step,
    and `pressed` one while a contact acts.
    """
    out, tried, f = np.zeros_like(y), np.zeros_like(y), work[4]
    t, first, last = (0.0, 0.0), (-1.0, 0.0), (0.0, 0.0)
    h, changes, turned = pressed * 1e-9, 0, 0
    for c in range(len(contacts)):
        if acts[c]:
            first = 0.0, 0.0
            largest(y, n, contacts[c], best)
    for _ in range(most):
        if math.isinf(until[0]):
            ended = len(turns) == 0 or turned == len(turns)
            for c in range(len(contacts)):
                # What comes no faster than errors of steps may make it does not come.
                comes = left_of(y, n, contacts[c], False)[1] < -1e3 * scale[1]
                ended = ended and (not (acts[c] or comes) or len(turns) > 0)
            gone = len(turns) > 0 and not acts[0] and left_of(y, n, contacts[0], False)[1] >= 0.0
            if ended or gone:
                return first, last, t, changes
        elif minus(until, t)[0] <= 0.0:
            return first, last, t, changes
        span = min(h, pressed if acts.any() else longest), 0.0
        if minus(plus(t, span), until)[0] > 0.0:
            span = minus(until, t)
        places, speeds = stepped(y, span, n, inverse, gravity, contacts, acts, work, out)
        error = max(places / scale[0], speeds / scale[1])
        if error > 1.0:
            h = span[0] * max(0.15, 0.8 * error ** (-1.0 / 17.0))
            continue
        ahead = span[0] * min(4.0, 0.8 * max(error, 1e-30) ** (-1.0 / 17.0))
        for c in range(len(contacts)):
            # Into the core and out again within the step: it ends at the turn between.
            if not acts[c] or contacts[c, CORE] == 0.0:
                continue
            before = watched(NEAREST, y, f, n, inverse, gravity, contacts, acts, c)
            after = watched(NEAREST, out, f, n, inverse, gravity, contacts, acts, c)
            if before > 0.0 > after and watched(INNER, out, f, n, inverse, gravity, contacts, acts, c) > 0.0:
                part = located(
                    NEAREST, y, span, before, after, n, inverse, gravity, contacts, acts, c, work, tried
                )
                if watched(INNER, tried, f, n, inverse, gravity, contacts, acts, c) < 0.0:
                    span = part
                    out[:] = tried
        for c in range(len(contacts)):
            # A pair of changes within the step: it ends at the turn between them.
            turn = FARTHEST if acts[c] else NEAREST
            before = watched(turn, y, f, n, inverse, gravity, contacts, acts, c)
            after = watched(turn, out, f, n, inverse, gravity, contacts, acts, c)
            if before > 0.0 > after and watched(CHANGE, out, f, n, inverse, gravity, contacts, acts, c) > 0.0:
                part = located(
                    turn, y, span, before, after, n, inverse, gravity, contacts, acts, c, work, tried
                )
                if watched(CHANGE, tried, f, n, inverse, gravity, contacts, acts, c) < 0.0:
                    span = part
                    out[:] = tried
        hit, kind = -1, CHANGE
        for c in range(len(contacts)):
            for each in (CHANGE, INNER):
                if each == INNER and not (acts[c] and contacts[c, CORE] > 0.0):
                    continue
                before = watched(each, y, f, n, inverse, gravity, contacts, acts, c)
                after = watched(each, out, f, n, inverse, gravity, contacts, acts, c)
                # What has just opened may be off by a rounding; it counts only if it goes on to sink.
                sinks = before > 0.0 or left_of(out, n, contacts[c], acts[c])[1] < 0.0
                if each == INNER:
                    sinks = seen(y, n, contacts[c])[5][0] < 0.0
                if after < 0.0 and sinks:
                    if before > 0.0:
                        span = located(
                            each, y, span, before, after, n, inverse, gravity, contacts, acts, c, work, tried
                        )
                        out[:] = tried
                    else:
                        span = 0.0, 0.0
                        out[:] = y
                    hit, kind = c, each
        for c in range(len(contacts)):
            for turn in (NEAREST, FARTHEST):
                before = watched(turn, y, f, n, inverse, gravity, contacts, acts, c)
                after = watched(turn, out, f, n, inverse, gravity, contacts, acts, c)
                if before > 0.0 > after and (acts[c] or c == 0):
                    part = located(
                        turn, y, span, before, after, n, inverse, gravity, contacts, acts, c, work, tried
                    )
                    if acts[c] and turn == NEAREST:
                        largest(tried, n, contacts[c], best)
                    if c == 0 and turned < len(turns):
                        noted(tried, n, contacts[0], plus(t, part), turns, turned)
                        turned += 1
            if not acts[c]:
                continue
            rising = watched(GROWTH, y, f, n, inverse, gravity, contacts, acts, c)
            falling = watched(GROWTH, out, f, n, inverse, gravity, contacts, acts, c)
            if rising > 0.0 > falling:
                located(GROWTH, y, span, rising, falling, n, inverse, gravity, contacts, acts, c, work, tried)
                largest(tried, n, contacts[c], best)
            largest(out, n, contacts[c], best)
        t = plus(t, span)
        y[:] = out
        h = ahead
        if hit >= 0 and kind == CHANGE:
            acts[hit] = not acts[hit]
            changes += 1
            h = 1e-8 * pressed
            last = t
            if first[0] < 0.0:
                first = t
            if acts[hit]:
                largest(y, n, contacts[hit], best)
        elif hit >= 0:
            turned_back(y, n, contacts[hit])
            if turned < len(turns):
                noted(y, n, contacts[hit], t, turns, turned)
                turned += 1
    return first, last, t, -1


@dataclass(frozen=True, slots=True)
class Followed:
    """What came of it; `changes` is how often a contact began or ended, `force_square` the square of the largest force."""

    places: tuple[Fraction, ...]
    velocities: tuple[Fraction, ...]
    first: Fraction
    last: Fraction
    end: Fraction
    overlap: Fraction
    force_square: Fraction
    turns: tuple[tuple[Fraction, ...], ...]
    changes: int


class TooLong(ArithmeticError):
    """The motion was not followed to its end."""


def followed(
    masses: Sequence[float],
    places: Sequence[Fraction | float],
    velocities: Sequence[Fraction | float],
    contacts: Sequence[Sequence[float]],
    scale: tuple[float, float],
    gravity: float = 0.0,
    until: float = math.inf,
    turns: int = 0,
    accuracy: float = 1e-18,
    pressed: float = math.inf,
    most: int = 40_000,
) -> Followed:
    """Bodies in a plane, places and velocities one component after the other (SI); `scale` is an overlap and a speed, of which
    a step may be off by `accuracy`; while a contact acts, a step lasts no longer than `pressed`. Raises TooLong.
    """
    n = len(masses)
    inverse = np.array([pair(Fraction(0) if math.isinf(m) else 1 / Fraction(m)) for m in masses])
    y = np.array([pair(x) for x in (*places, *velocities)])
    laws = np.array([[*each, *(0.0,) * (8 - len(each))] for each in contacts], dtype=float)
    laws[:, OUTER] = np.where(laws[:, OUTER] > 0.0, laws[:, OUTER], laws[:, REACH])
    acts = np.array([left_of(y, n, law, True)[0] >= 0.0 for law in laws])
    work = (np.zeros((PARTS, 4 * n, 2)), *(np.zeros((4 * n, 2)) for _ in range(5)))
    unit = scale[0] / scale[1]
    found, best = np.zeros((turns, 3, 2)), np.zeros((2, 2))
    first, last, end, changes = follow(
        y,
        n,
        inverse,
        gravity,
        laws,
        acts,
        (accuracy * scale[0], accuracy * scale[1]),
        (until, 0.0),
        8.0 * unit,
        min(0.5 * unit, pressed),
        found,
        best,
        work,
        most,
    )
    if changes < 0:
        raise TooLong
    exact = [number(*each) for each in y]
    return Followed(
        tuple(exact[: 2 * n]),
        tuple(exact[2 * n :]),
        number(*first),
        number(*last),
        number(*end),
        number(*best[0]),
        number(*best[1]),
        tuple(tuple(number(*each) for each in turn) for turn in found),
        changes,
    )
