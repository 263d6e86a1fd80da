"""The loop that `compiled` runs: everything that happens between the first touch and the last opening, in natural units.

Every number it needs lies in arrays: the state (time, overlaps, velocities), `inverse` masses, and `terms` with stiffness, exponent
and smoothing power of each contact. numba keeps what it compiled until this file changes: touch it after a change elsewhere.
"""

from __future__ import annotations

import math

import numpy as np
from numba import njit  # pyright: ignore[reportMissingImports]

from corollary.scenes.integrate import controller
from corollary.scenes.integrate.compiled_step import STAGES, TIME, slope, step
from corollary.scenes.integrate.contact_events import NEAR_CONTACT
from corollary.scenes.integrate.regularised import (
    FIRST_STRIDE,
    LEAST_STRIDE,
    MOST_TRIALS,
)
from corollary.scenes.integrate.step import EVALUATIONS

MOST_STEPS = 600_000
GRAZING = -2
factor = njit(cache=True)(controller.factor)
RELEASED, MISSED, TOO_LONG, NO_STEP, STILL = 0, 1, 2, 3, 4


@njit(cache=True, inline="always")
def _closing(state, j):
    left = len(state) // 2 + j
    return state[left] - state[left + 1]


@njit(cache=True, error_model="numpy")
def _value_in(state, variable, power):
    if variable == TIME:
        return state[0]
    return state[1 + variable] if power == 1 else max(state[1 + variable], 0.0) ** (1.0 / power)


@njit(cache=True, error_model="numpy")
def _enter(variable, power, w, y, state):
    """From (overlaps, velocities) on a variable that shows w to the state."""
    state[1:] = y
    state[0] = w
    if variable != TIME:
        state[0], state[1 + variable] = y[variable], w**power


@njit(cache=True, error_model="numpy")
def _inactive(state, touching, inverse, terms, noise):
    for j in range(len(touching)):
        if touching[j]:
            k, q, faint = terms[j, 0], terms[j, 1], 0.5 * noise**2 / (inverse[j] + inverse[j + 1])
            if _closing(state, j) > noise or (
                state[1 + j] > 0.0 and k * state[1 + j] ** (q + 1.0) / (q + 1.0) > faint
            ):
                return False
    return True


@njit(cache=True, error_model="numpy")
def _fly(state, touching, noise):
    """On to the next touch; whether there is one."""
    best, after = -1, math.inf
    for j in range(len(touching)):
        closing = _closing(state, j)
        if closing > noise and max(-state[1 + j], 0.0) / closing < after:
            best, after = j, max(-state[1 + j], 0.0) / closing
    if best >= 0:
        for j in range(len(touching)):
            state[1 + j] = min(state[1 + j] + _closing(state, j) * after, 0.0)
            touching[j] = j == best
        state[0] += after
        state[1 + best] = 0.0
    return best >= 0


@njit(cache=True, error_model="numpy")
def _due(state, base, touching, lasting, noise):
    """The contact sure to begin or end next within so long, or none."""
    count, first = len(touching), TIME
    for j in range(count):
        overlap, speed = state[1 + j], base[j]
        ahead = (overlap > 0.0 and speed < -noise) if touching[j] else (overlap < 0.0 and speed > noise)
        if (
            ahead
            and -overlap / speed < lasting
            and abs(overlap * (base[count + j] - base[count + j + 1])) < 0.3 * speed * speed
        ):
            first, lasting = j, -overlap / speed
    return first


@njit(cache=True, error_model="numpy")
def _suited(state, base, touching, lasting, terms, noise):
    """The young or ending contact that is the best variable, or the time."""
    count, best, nearest = len(touching), TIME, 2.0 * lasting
    for j in range(count):
        overlap, speed = state[1 + j], base[j]
        if terms[j, 2] > 1.0 and touching[j] and overlap >= 0.0 and abs(speed) > noise:
            steady = overlap * abs(base[count + j] - base[count + j + 1]) < 0.3 * speed * speed
            if steady and overlap < nearest * abs(speed):
                best, nearest = j, overlap / abs(speed)
    return best


@njit(cache=True, error_model="numpy")
def _turns(state, base, j):
    """Whether an overlap on its way to zero would turn before, if its acceleration stayed as it is."""
    left = len(base) // 2 + j
    growth = base[left] - base[left + 1]
    return growth * base[j] < 0.0 and base[j] * base[j] < 2.0 * abs(state[1 + j] * growth)


@njit(cache=True, error_model="numpy")
def _crossing(variable, state, base, after, touching, terms, noise, tolerance):
    """The contact that begins or ends first between two states; TIME for none, GRAZING where one may have grazed."""
    first, when, grazed = TIME, 2.0, False
    for j in range(len(touching)):
        old, new, sign = state[1 + j], after[1 + j], 1.0 if touching[j] else -1.0
        before, then = sign * _closing(state, j), sign * _closing(after, j)
        near = variable == TIME and terms[j, 2] > 1.0 and then < 0.0 and new < NEAR_CONTACT * old
        near = (
            near
            and terms[j, 0] * old ** terms[j, 1] * (after[0] - state[0]) > tolerance
            and not _turns(state, base, j)
        )
        ends = (new < 0.0 < old or near) if touching[j] else new > 0.0
        if j != variable and ends and max(abs(before), abs(then)) > noise:
            if old / (old - new) < when:
                first, when = j, old / (old - new)
        elif before < 0.0 < then and sign * old < 0.5 * before**2 * (after[0] - state[0]) / (then - before):
            grazed = True
    return GRAZING if first == TIME and grazed else first


@njit(cache=True, error_model="numpy")
def _top(j, variable, power, x, h, y, ends, slopes, touching, inverse, terms):
    """The largest overlap of a contact whose closing speed falls through zero in a step to `ends`, and evaluations spent."""
    left = len(touching) + j
    work, here, state, own = np.empty_like(y), np.empty_like(y), np.empty(len(y) + 1), slopes.copy()
    slope(variable, x + h, ends, here, touching, inverse, terms)
    before, after = y[left] - y[left + 1], ends[left] - ends[left + 1]
    rise, fall = h * (slopes[0, left] - slopes[0, left + 1]), h * (here[left] - here[left + 1])
    low, high, overlap, spent = 0.0, 1.0, 0.0, 1
    for _ in range(16):
        s = 0.5 * (low + high)
        rest = 1.0 - s
        value = rest * rest * ((1.0 + 2.0 * s) * before + s * rise) + s * s * (
            (3.0 - 2.0 * s) * after - rest * fall
        )
        low, high = (s, high) if value > 0.0 else (low, s)
    part = 0.5 * (low + high)
    for _ in range(4):
        step(variable, x, part * h, y, own, work, touching, inverse, terms)
        slope(variable, x + part * h, work, here, touching, inverse, terms)
        _enter(variable, power, x + part * h, work, state)
        speed, growth = _closing(state, j), here[left] - here[left + 1]
        stretch = 1.0 if variable == TIME else here[variable]
        overlap = state[1 + j] - (0.5 * speed * speed * stretch / growth if growth * stretch < 0.0 else 0.0)
        spent += EVALUATIONS + 1
        if abs(speed) <= 3e-5 * max(before, -after) or growth * h >= 0.0:
            break
        part = min(max(part - speed / (growth * h), 0.0), 1.0)
    return overlap, spent


@njit(cache=True, error_model="numpy")
def follow(state, inverse, terms, extrema, tolerance):
    """Moves the state to the end of the collision; says how it ended, when it began and ended, its openings and evaluations."""
    count, noise = len(extrema), max(1e-14, 3.0 * tolerance)
    touching = state[1 : count + 1] >= 0.0
    y, ends, base, after = (
        np.empty(2 * count + 1),
        np.empty(2 * count + 1),
        np.empty(2 * count + 1),
        state.copy(),
    )
    slopes = np.empty((STAGES, 2 * count + 1))
    began, ended, openings, evaluations = math.inf, 0.0, 0, 0
    lasted, landing, last_stride, last_variable = FIRST_STRIDE, False, 0.0, TIME
    for _ in range(MOST_STEPS):
        for j in range(count):
            if state[1 + j] == 0.0:
                touching[j] = _closing(state, j) >= 0.0
        if _inactive(state, touching, inverse, terms, noise):
            for j in range(count):
                if touching[j] and state[1 + j] > 0.0:
                    opening = -_closing(state, j)
                    ended = max(ended, state[0] + (state[1 + j] / opening if opening > noise else 0.0))
                    openings, touching[j], state[1 + j] = openings + 1, False, 0.0
            if not _fly(state, touching, noise):
                return (
                    (RELEASED, began, ended, openings, evaluations)
                    if began <= ended
                    else (MISSED, 0.0, 0.0, 0, evaluations)
                )
            lasted, landing, last_stride, last_variable = FIRST_STRIDE, False, 0.0, TIME
        began = min(began, state[0])
        y[:] = state[1:]
        slope(TIME, state[0], y, base, touching, inverse, terms)
        if landing:  # its speed may have faded or turned on the way
            heads = abs(base[last_variable]) > noise and (base[last_variable] < 0.0) == (
                state[1 + last_variable] > 0.0
            )
            landing = heads and not _turns(state, base, last_variable)
        variable = last_variable if landing else _suited(state, base, touching, lasted, terms, noise)
        if variable == TIME:
            variable = _due(state, base, touching, lasted, noise)
            landing = variable != TIME
        stride = lasted
        if variable != TIME:
            ahead = max(state[1 + variable] + base[variable] * lasted, 0.0)
            power = int(terms[variable, 2]) if touching[variable] else 1
            stride = ahead ** (1.0 / power) - _value_in(state, variable, power)
        if variable == last_variable and 0.0 < abs(last_stride) < abs(stride):
            stride = last_stride
        if stride == 0.0:  # too short for this variable to tick
            variable, landing, stride = TIME, False, lasted
        x, h, size, lands, power = 0.0, 0.0, math.inf, False, 1
        for trial in range(MOST_TRIALS + 1):
            if trial == MOST_TRIALS:
                return NO_STEP, began, ended, openings, evaluations
            power = int(terms[variable, 2]) if variable != TIME and touching[variable] else 1
            x = _value_in(state, variable, power)
            lands = variable != TIME and x * stride < 0.0 and abs(stride) >= abs(x)
            h = -x if lands else stride
            y[:], slopes[0] = state[1:], base
            if variable != TIME:
                y[variable] = state[0]
                stretch = power * x ** (power - 1) / base[variable]
                slopes[0] *= stretch
                slopes[0, variable] = stretch
            size = step(variable, x, h, y, slopes, ends, touching, inverse, terms) / tolerance
            evaluations += EVALUATIONS
            if not size <= 1.0:
                stride = h * factor(size)
                if landing and trial > 20:
                    variable, landing, stride = TIME, False, 0.1 * lasted
                continue
            _enter(variable, power, 0.0 if lands else x + h, ends, after)
            crossing = _crossing(variable, state, base, after, touching, terms, noise, tolerance)
            if crossing == TIME or trial > 60 or (crossing == GRAZING and trial >= 60):
                break
            if crossing != GRAZING and base[crossing] != 0.0 and (base[crossing] < 0.0) == touching[crossing]:
                variable, landing = crossing, True
                stride = -_value_in(state, variable, int(terms[variable, 2]) if touching[variable] else 1)
            else:
                stride = 0.5 * h
        for j in range(count):
            if touching[j] and base[j] > 0.0 >= _closing(after, j) and state[1 + j] >= 0.0 <= after[1 + j]:
                overlap, spent = _top(j, variable, power, x, h, y, ends, slopes, touching, inverse, terms)
                extrema[j], evaluations = max(extrema[j], overlap), evaluations + spent
        grown = factor(size)
        now = max((after[0] - state[0]) * grown, LEAST_STRIDE)
        lasted, landing = max(now, lasted) if lands else now, landing and not lands
        last_stride, last_variable = (0.0, TIME) if lands else (h * grown, variable)
        state[:], evaluations = after, evaluations + 1
        for j in range(count):
            if touching[j] and (state[1 + j] < 0.0 or (lands and j == variable)):
                touching[j], ended, openings = False, state[0], openings + 1
            elif not touching[j] and (state[1 + j] > 0.0 or (lands and j == variable)):
                touching[j] = True
    return TOO_LONG, began, ended, openings, evaluations
