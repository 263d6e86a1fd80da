"""Four families composed of bodies and forces: a hard wall, dry friction, an orbit, a fall in a thick fluid; their motion is known in closed form."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import numpy as np

from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import Friction, HardWall
from corollary.scenes.forces.fields import InverseSquare, Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.plan import play
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .problem import Event, Found, Mode, Problem, Truth, halves, no_events, nothing, of_run

G, POINTS = 9.8, 8
V, X = Observable.VELOCITIES, Observable.TRAJECTORY
NAIL = Body(math.inf, (0.0,), (0.0,))


def sampled(until: float) -> tuple[float, ...]:
    return tuple(until * i / POINTS for i in range(1, POINTS + 1))


def truth_of(
    state_at: Callable[[float], tuple[Sequence[float], Sequence[float]]], times: Sequence[float]
) -> Truth:
    return Truth(np.array(state_at(times[-1])[1]), np.array([state_at(t)[0] for t in times]), 14)


def asked(scene: Scene, times: Sequence[float], fast: float, picked: slice, axes: int, away: float = 0.0):
    """The package's route: velocities and places of one of the bodies, counted from `away`."""

    def run(tolerance: float) -> Found:
        made = of_run(play(scene, {V, X}, tolerance, times), fast, picked, picked, axes, len(times))
        assert made.places is not None
        return Found(made.velocities, made.places - away, made.evaluations, made.stated, made.notes)

    return {"composed": run}


def wall_right_side(t, y, p, mode):
    return np.array([y[1], -p[0] * y[0]])


def wall_fix(y, before, p):
    if y[0] > p[1] and y[1] > 0.0:
        y[1] = -p[2] * y[1]


def wall(draw: int) -> Problem:
    """An oscillator that hits a hard wall again and again, often only just."""
    chance = Random(f"wall {draw}")
    w, at, e = chance.uniform(1.0, 5.0), chance.uniform(0.05, 0.3), chance.uniform(0.3, 1.0)
    amplitude = at * (1.0 + 10.0 ** chance.uniform(-4.0, 0.3))
    arcs = [(0.0, -amplitude, 0.0)]
    angle = math.pi - math.acos(at / amplitude)
    for _ in range(4):
        t0, x, v = arcs[-1]
        hit = t0 + angle / w
        speed = -x * w * math.sin(angle) + v * math.cos(angle)
        arcs.append((hit, at, -e * speed))
        angle = 2.0 * math.pi - 2.0 * math.atan2(e * speed, w * at)
    until = arcs[-1][0] - 0.3 * (arcs[-1][0] - arcs[-2][0])

    def state_at(t: float):
        t0, x, v = next(arc for arc in reversed(arcs) if arc[0] <= t)
        c, s = math.cos(w * (t - t0)), math.sin(w * (t - t0))
        return [x * c + v / w * s], [-x * w * s + v * c]

    times = sampled(until)
    scene = Scene(
        (NAIL, Body(2.0, (1.0 - amplitude,), (0.0,))),
        (Spring((0, 1), 2.0 * w * w, 1.0), HardWall((-1.0,), -1.0 - at, e)),
        until=until,
    )
    hits = Event(lambda y: y[0] - at, 1, lambda y, mode: (np.array([at, -e * y[1]]), mode))
    return Problem(
        "wall", wall_right_side, wall_fix, np.array([w * w, at, e]), np.array([-amplitude, 0.0]), until, times, 0,
        lambda mode: (hits,), truth_of(state_at, times), amplitude, amplitude * w,
        asked(scene, times, amplitude * w, slice(1, 2), 2, 1.0), lambda y: halves(y)[0], lambda y: halves(y)[1],
        lambda hy, y, mode: [y[1], -w * w * y[0]], False,
    )  # fmt: skip


def friction_right_side(t, y, p, mode):
    if mode == 0:
        return np.zeros(2)
    way = np.sign(y[1]) if mode == 2 else float(mode)
    return np.array([y[1], -p[0] * y[0] - p[1] * way])


def friction_fix(y, before, p):
    if y[1] * before[1] <= 0.0 and p[0] * abs(y[0]) <= p[2]:
        y[1] = 0.0


def friction(draw: int) -> Problem:
    """A block on a spring with dry friction swings until it is held."""
    chance = Random(f"friction {draw}")
    k, m, mu = chance.uniform(20.0, 300.0), chance.uniform(0.2, 3.0), chance.uniform(0.02, 0.3)
    static = mu * chance.uniform(1.0, 2.5)
    shift, holds, w = mu * m * G / k, static * m * G / k, math.sqrt(k / m)
    turns = [holds * chance.uniform(2.0, 9.0)]
    while abs(turns[-1]) > holds:
        turns.append(-(abs(turns[-1]) - 2.0 * shift) * math.copysign(1.0, turns[-1]))
    until, start = math.pi / w * (len(turns) - 1.4), turns[0]

    def state_at(t: float):
        i = min(int(t * w / math.pi), len(turns) - 1)
        if i == len(turns) - 1:
            return [turns[-1]], [0.0]
        middle, phase = math.copysign(shift, turns[i]), w * t - math.pi * i
        return [middle + (turns[i] - middle) * math.cos(phase)], [-(turns[i] - middle) * w * math.sin(phase)]

    def after(y: Any, mode: Mode) -> tuple[Any, Mode]:
        held = abs(y[0]) <= holds
        return np.array([y[0], 0.0]), 0 if held else (-1 if y[0] > 0.0 else 1)

    times = sampled(until)
    scene = Scene(
        (NAIL, Body(m, (2.0 * start + start,), (0.0,))),
        (Spring((0, 1), k, 2.0 * start), Friction(1, mu, G, static)),
        until=until,
    )
    return Problem(
        "friction", friction_right_side, friction_fix, np.array([w * w, mu * G, static * G]), np.array([start, 0.0]), until, times, -1,
        lambda mode: () if mode == 0 else (Event(lambda y: y[1], -mode, after),),
        truth_of(state_at, times), start, start * w, asked(scene, times, start * w, slice(1, 2), 2, 2.0 * start),
        lambda y: halves(y)[0], lambda y: halves(y)[1], lambda hy, y, mode: [y[1], -w * w * y[0] - mu * G * mode],
    )  # fmt: skip


def orbit_right_side(t, y, p, mode):
    r = math.sqrt(y[0] * y[0] + y[1] * y[1])
    pull = -p[0] / (r * r * r)
    return np.array([y[2], y[3], pull * y[0], pull * y[1]])


def orbit(draw: int) -> Problem:
    """Two rounds and a bit of an ellipse, from its nearest point: Kepler's equation."""
    chance = Random(f"orbit {draw}")
    e, a, mu = chance.uniform(0.2, 0.8), chance.uniform(0.5, 3.0), chance.uniform(0.5, 3.0)
    n, b = math.sqrt(mu / a**3), a * math.sqrt(1.0 - e * e)
    speed = math.sqrt(mu * (1.0 + e) / (a * (1.0 - e)))
    until = chance.uniform(2.1, 2.9) * 2.0 * math.pi / n

    def state_at(t: float):
        mean = math.remainder(n * t, 2.0 * math.pi)
        u = mean
        for _ in range(60):
            u -= (u - e * math.sin(u) - mean) / (1.0 - e * math.cos(u))
        c, s = math.cos(u), math.sin(u)
        d = a * n / (1.0 - e * c)
        return [a * (c - e), b * s], [-d * s, d * b / a * c]

    times, start = sampled(until), a * (1.0 - e)
    scene = Scene(
        (Body(1.0, (start, 0.0), (0.0, speed)), Body(math.inf, (0.0, 0.0), (0.0, 0.0))),
        (InverseSquare((0, 1), mu),),
        until=until,
    )
    return Problem(
        "orbit", orbit_right_side, nothing, np.array([mu]), np.array([start, 0.0, 0.0, speed]), until, times, 0,
        no_events, truth_of(state_at, times), a, speed, asked(scene, times, speed, slice(0, 2), 4),
        lambda y: halves(y)[0], lambda y: halves(y)[1],
        lambda hy, y, mode: [y[2], y[3], *(-mu * x * (y[0] * y[0] + y[1] * y[1]) ** -1.5 for x in (y[0], y[1]))],
    )  # fmt: skip


def fluid_right_side(t, y, p, mode):
    return np.array([y[2], y[3], -p[0] * y[2], -p[0] * y[3] - p[1]])


def fluid(draw: int) -> Problem:
    """A stone falls in a thick fluid: its velocity settles a hundred to two thousand times faster than the fall lasts."""
    chance = Random(f"fluid {draw}")
    rate, u, v = 10.0 ** chance.uniform(2.0, 3.3), chance.uniform(1.0, 5.0), chance.uniform(-5.0, 5.0)
    last = G / rate

    def state_at(t: float):
        gone = -math.expm1(-rate * t)
        x, y = u * gone / rate, (v + last) * gone / rate - last * t
        return [x, y], [u * (1.0 - gone), (v + last) * (1.0 - gone) - last]

    times, fast = sampled(1.0), math.hypot(u, v)
    scene = Scene((Body(1.0, (0.0, 0.0), (u, v)),), (Weight(G), Drag(0, linear=rate)), until=1.0)
    return Problem(
        "fluid", fluid_right_side, nothing, np.array([rate, G]), np.array([0.0, 0.0, u, v]), 1.0, times, 0,
        no_events, truth_of(state_at, times), fast / rate, fast, asked(scene, times, fast, slice(0, 2), 2),
        lambda y: halves(y)[0], lambda y: halves(y)[1], lambda hy, y, mode: [y[2], y[3], -rate * y[2], -rate * y[3] - G],
    )  # fmt: skip
