"""Families on rough tables: blocks that stick and slip on springs, belts and strings; references by `sliding` or closed forms."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.drag import Drag
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.rod import Rod, String
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .case import Case
from .reference import follow, sliding

V, X = Observable.VELOCITIES, Observable.TRAJECTORY
G = 9.8
INF = math.inf
ROUNDED = 1e-11


def floats(*values: Any) -> tuple[float, ...]:
    return tuple(float(v) for v in values)


def nudged_through_a_spring(draw: Random) -> Case:
    """A block slides away and drags another along by a spring, once that no longer holds."""
    m, mu = (draw.uniform(0.3, 2), draw.uniform(0.3, 2)), (draw.uniform(0.05, 0.3), draw.uniform(0.1, 0.4))
    static = tuple(c * draw.uniform(1, 1.5) for c in mu)
    k, v, until = draw.uniform(20, 120), draw.uniform(1, 5), draw.uniform(0.5, 3)
    scene = Scene(
        (Body(m[0], (3.0,), (v,)), Body(m[1], (0.0,), (0.0,))),
        (Spring((0, 1), k, 3.0), *(Friction(i, mu[i], G, static[i]) for i in range(2))),
        until=until,
    )

    def force(t: Any, x: Any, v: Any) -> Any:
        pull = k * (x[0] - x[1] - 3)
        return -pull, pull

    weigh = [each * G for each in m]
    x, u = sliding(
        m,
        [a * w for a, w in zip(mu, weigh, strict=True)],
        [a * w for a, w in zip(static, weigh, strict=True)],
        force,
        (3.0, 0.0),
        (v, 0.0),
        until,
    )
    return Case("nudged through a spring", scene, {V: floats(*u), X: floats(*x)}, (until,))


def earthquakes(draw: Random) -> Case:
    """Two blocks on a spring, each pulled by a spring of its own from a body that moves steadily (Burridge and Knopoff)."""
    m, k, coupling = draw.uniform(0.5, 2), draw.uniform(20, 60), draw.uniform(10, 60)
    mu, static = 0.1, (draw.uniform(0.15, 0.3), draw.uniform(0.15, 0.3))
    pulled, until = draw.uniform(0.1, 0.5), draw.uniform(3, 9)
    scene = Scene(
        (Body(m, (0.0,), (0.0,)), Body(m, (0.5,), (0.0,)), Body(INF, (1.0,), (pulled,))),
        (
            Spring((0, 1), coupling, 0.5),
            Spring((0, 2), k, 1.0),
            Spring((1, 2), k, 0.5),
            *(Friction(i, mu, G, static[i]) for i in range(2)),
        ),
        until=until,
    )

    def force(t: Any, x: Any, v: Any) -> Any:
        inner, end = coupling * (x[1] - x[0] - 0.5), 1 + pulled * t
        return inner + k * (end - x[0] - 1), -inner + k * (end - x[1] - 0.5)

    x, u = sliding(
        (m, m), (mu * m * G,) * 2, tuple(s * m * G for s in static), force, (0, 0.5), (0, 0), until
    )
    end = 1 + pulled * until
    return Case("earthquakes", scene, {V: (*floats(*u), pulled), X: (*floats(*x), end)}, (until,))


def shaken_block(draw: Random) -> Case:
    """A force that swings moves a block whenever it overcomes static friction."""
    m, mu = draw.uniform(0.3, 3), draw.uniform(0.1, 0.3)
    static, w = mu * draw.uniform(1.05, 1.6), draw.uniform(1, 5)
    push, until = static * m * G * draw.uniform(1.1, 2.5), draw.uniform(2, 8)
    scene = Scene(
        (Body(m, (0.0,), (0.0,)),),
        (ForceFunction(0, lambda t, x, v: (push * math.sin(w * t),)), Friction(0, mu, G, static)),
        until=until,
    )

    def force(t: Any, x: Any, v: Any) -> Any:
        return (push * np.sin(w * t),)

    x, u = sliding((m,), (mu * m * G,), (static * m * G,), force, (0,), (0,), until)
    return Case("shaken block", scene, {V: floats(*u), X: floats(*x)}, (until,))


def three_frictions(draw: Random) -> Case:
    """A spring, dry friction and a fluid brake a block together."""
    m, k, mu, c = draw.uniform(0.3, 2), draw.uniform(30, 200), draw.uniform(0.02, 0.2), draw.uniform(0.05, 2)
    static, x0, until = mu * draw.uniform(1, 2), draw.uniform(0.2, 1), draw.uniform(0.5, 5)
    scene = Scene(
        (Body(INF, (0.0,), (0.0,)), Body(m, (2.0 + x0,), (0.0,))),
        (Spring((0, 1), k, 2.0), Friction(1, mu, G, static), Drag(1, linear=c)),
        until=until,
    )

    def force(t: Any, x: Any, v: Any) -> Any:
        return (-k * (x[0] - 2) - c * v[0],)

    x, u = sliding((m,), (mu * m * G,), (static * m * G,), force, (2 + x0,), (0,), until)
    return Case("three frictions", scene, {V: (0, *floats(*u)), X: (0, *floats(*x))}, (until,))


def chain_on_a_table(draw: Random) -> Case:
    """Three blocks on springs, each with its own friction; the middle one is hit."""
    m = [draw.uniform(0.3, 2) for _ in range(3)]
    mu = [draw.uniform(0.05, 0.3) for _ in range(3)]
    static = [c * draw.uniform(1, 1.5) for c in mu]
    k, v, until = (draw.uniform(30, 200), draw.uniform(30, 200)), draw.uniform(0.5, 3), draw.uniform(0.3, 3)
    scene = Scene(
        (Body(m[0], (0.0,), (0.0,)), Body(m[1], (2.0,), (v,)), Body(m[2], (4.0,), (0.0,))),
        (
            Spring((0, 1), k[0], 2.0),
            Spring((1, 2), k[1], 2.0),
            *(Friction(i, mu[i], G, static[i]) for i in range(3)),
        ),
        until=until,
    )

    def force(t: Any, x: Any, v: Any) -> Any:
        left, right = k[0] * (x[1] - x[0] - 2), k[1] * (x[2] - x[1] - 2)
        return left, right - left, -right

    x, u = sliding(
        m,
        [a * b * G for a, b in zip(mu, m, strict=True)],
        [a * b * G for a, b in zip(static, m, strict=True)],
        force,
        (0, 2, 4),
        (0, v, 0),
        until,
    )
    return Case("chain on a table", scene, {V: floats(*u), X: floats(*x)}, (until,))


def bumper(draw: Random) -> Case:
    """A block slides into a bumper (a linear contact) and out of it, and stops on the table."""
    m, k, mu = draw.uniform(0.3, 3), draw.uniform(200, 5000), draw.uniform(0.05, 0.4)
    far, v = draw.uniform(0.2, 1), draw.uniform(3, 6)
    a, w = mu * G, math.sqrt(k / m)
    shift, u = mu * m * G / k, math.sqrt(v * v - 2 * a * far)
    # In: x = -shift + sqrt(shift^2 + (u/w)^2) at most; out: about +shift.
    deep = math.hypot(shift, u / w) - shift
    t = (v - u) / a + (math.pi / 2 - math.atan2(shift, u / w)) / w
    out = w * math.sqrt(deep * (deep - 2 * shift))
    t += math.acos(-shift / (deep - shift)) / w
    until = t + draw.uniform(0.1, 1.5) * out / a
    left = min(until - t, out / a)
    x = 1.0 - 0.1 - out * left + a * left * left / 2
    scene = Scene(
        (Body(m, (1.0 - 0.1 - far,), (v,), 0.1), Body(INF, (1.2,), (0.0,), 0.2)),
        (Contact(k, 1.0), Friction(0, mu)),
        until=until,
    )
    truth = {V: (-(out - a * left) if left < out / a else 0.0, 0), X: (x, 1.2)}
    return Case("bumper", scene, truth, (until,))


def two_belts(draw: Random) -> Case:
    """Two blocks on a spring stand on belts that run against each other."""
    m, k = (draw.uniform(0.5, 2), draw.uniform(0.5, 2)), draw.uniform(10, 60)
    mu = (draw.uniform(0.1, 0.3), draw.uniform(0.1, 0.3))
    static = tuple(c * draw.uniform(1.1, 1.6) for c in mu)
    belts, until = (-draw.uniform(0.2, 1), draw.uniform(0.2, 1)), draw.uniform(1, 6)
    scene = Scene(
        (Body(m[0], (0.0,), (0.0,)), Body(m[1], (1.0,), (0.0,))),
        (Spring((0, 1), k, 1.0), *(Friction(i, mu[i], G, static[i], (belts[i],)) for i in range(2))),
        until=until,
    )

    def force(t: Any, x: Any, v: Any) -> Any:
        pull = k * (x[1] - x[0] - 1)
        return pull, -pull

    weights = [each * G for each in m]
    kinetic = [a * b for a, b in zip(mu, weights, strict=True)]
    held = [a * b for a, b in zip(static, weights, strict=True)]
    x, u = sliding(m, kinetic, held, force, (0, 1), (0, 0), until, belts)
    return Case("two belts", scene, {V: floats(*u), X: floats(*x)}, (until,))


def coupled_by_a_rod(draw: Random) -> Case:
    """A spring swings two blocks on a rod; only one of them rubs."""
    m, k, mu = (draw.uniform(0.3, 2), draw.uniform(0.3, 2)), draw.uniform(30, 200), draw.uniform(0.02, 0.2)
    static, x0, until = mu * draw.uniform(1, 2), draw.uniform(0.2, 0.6), draw.uniform(0.5, 5)
    scene = Scene(
        (Body(INF, (0.0,), (0.0,)), Body(m[0], (1.0 + x0,), (0.0,)), Body(m[1], (1.7 + x0,), (0.0,))),
        (Spring((0, 1), k, 1.0), Rod((1, 2)), Friction(2, mu, G, static)),
        until=until,
    )

    def force(t: Any, x: Any, v: Any) -> Any:
        return (-k * (x[0] - 1),)

    x, u = sliding((sum(m),), (mu * m[1] * G,), (static * m[1] * G,), force, (1 + x0,), (0,), until)
    at, speed = float(x[0]), float(u[0])
    return Case("coupled by a rod", scene, {V: (0, speed, speed), X: (0, at, at + 0.7)}, (until,))


def puck_on_a_string(draw: Random) -> Case:
    """A puck circles a nail on a taut string, slower and slower, and stops."""
    r, v, mu, m = draw.uniform(0.3, 1), draw.uniform(1, 4), draw.uniform(0.1, 0.4), draw.uniform(0.1, 1)
    stop, link = v / (mu * G), draw.choice([Rod, String])
    until = stop * draw.choice([draw.uniform(0.2, 0.95), draw.uniform(1.05, 1.5)])
    t = min(until, stop)
    angle, speed = (v * t - mu * G * t * t / 2) / r, v - mu * G * t if until < stop else 0.0
    scene = Scene(
        (Body(INF, (0.0, 0.0), (0.0, 0.0)), Body(m, (r, 0.0), (0.0, v))),
        (link((0, 1)), Friction(1, mu)),
        until=until,
    )
    c, s = math.cos(angle), math.sin(angle)
    return Case(
        "puck on a string", scene, {V: (0, 0, -speed * s, speed * c), X: (0, 0, r * c, r * s)}, (until,)
    )


def puck_on_a_belt(draw: Random) -> Case:
    """A puck shot across a belt is taken along by it."""
    v, belt = (draw.uniform(-3, 3), draw.uniform(-3, 3)), (draw.uniform(-2, 2), draw.uniform(-2, 2))
    mu, until = draw.uniform(0.1, 0.5), draw.uniform(0.2, 3)
    rel = (v[0] - belt[0], v[1] - belt[1])
    speed = math.hypot(*rel)
    t = min(until, speed / (mu * G))
    share, way = (
        (1 - mu * G * t / speed if t == until else 0.0),
        (speed * t - mu * G * t * t / 2) / speed,
    )
    scene = Scene((Body(0.5, (1.0, -2.0), v),), (Friction(0, mu, belt=belt),), until=until)
    end = tuple(b + share * r for b, r in zip(belt, rel, strict=True))
    at = tuple(x + b * until + way * r for x, b, r in zip((1.0, -2.0), belt, rel, strict=True))
    return Case("puck on a belt", scene, {V: end, X: at}, (until,))


def puck_off_a_cushion(draw: Random) -> Case:
    """A puck on a rough table bounces off a cushion and another one and comes to rest."""
    angle, v, mu, e = (
        draw.uniform(0.3, 1.2),
        draw.uniform(3, 6),
        draw.uniform(0.05, 0.3),
        draw.uniform(0.5, 1),
    )
    x, y, u, w = 0.4, 0.3, v * math.cos(angle), v * math.sin(angle)
    t, until = 0.0, draw.uniform(0.5, 3)
    hit_x = hit_y = 0
    a, d = mu * G, 0.05
    while True:
        speed = math.hypot(u, w)
        way = min(
            speed * (until - t) - a * (until - t) ** 2 / 2 if until - t < speed / a else INF, speed**2 / 2 / a
        )
        # How far to each of the walls x = 1, x = 0, y = 1, y = 0 along the line.
        to_x = ((1 - d - x) if u > 0 else (x - d)) / abs(u) * speed
        to_y = ((1 - d - y) if w > 0 else (y - d)) / abs(w) * speed
        go = min(way, to_x, to_y)
        x, y = x + u / speed * go, y + w / speed * go
        left = math.sqrt(max(speed**2 - 2 * a * go, 0.0))
        t += (speed - left) / a
        u, w = u / speed * left, w / speed * left
        if go == way:
            break
        if go == to_x:
            u, hit_x = -e * u, hit_x + 1
        else:
            w, hit_y = -e * w, hit_y + 1
    walls = [
        HardWall(n, o, e)
        for n, o in (((1.0, 0.0), 0.0), ((-1.0, 0.0), -1.0), ((0.0, 1.0), 0.0), ((0.0, -1.0), -1.0))
    ]
    scene = Scene(
        (Body(0.2, (0.4, 0.3), (v * math.cos(angle), v * math.sin(angle)), d),),
        (*walls, Friction(0, mu)),
        until=until,
    )
    stopped = math.hypot(u, w) < 1e-7
    return Case("puck off cushions", scene, {V: (0.0, 0.0) if stopped else (u, w), X: (x, y)}, (until,))


def sliding_dumbbell(draw: Random) -> Case:
    """Two pucks on a rod slide and turn over a rough table; one may all but stop, or stop and be turned about.

    The reference rounds friction off below `ROUNDED` (m/s), with implicit steps: nothing then stops, and no step passes over a stop.
    """
    m, mu, d = (
        (draw.uniform(0.2, 1), draw.uniform(0.2, 1)),
        (draw.uniform(0.05, 0.3), draw.uniform(0.05, 0.3)),
        0.8,
    )
    u, w, omega, until = draw.uniform(0.5, 3), draw.uniform(-1, 1), draw.uniform(1, 6), draw.uniform(0.1, 0.6)
    total = sum(m)
    arm = (-d * m[1] / total, d * m[0] / total)
    inertia = m[0] * arm[0] ** 2 + m[1] * arm[1] ** 2

    def f(t: float, y: Any) -> Any:
        c, s = math.cos(y[2]), math.sin(y[2])
        fx = fy = turn = 0
        for i in range(2):
            vx, vy = y[3] - y[5] * arm[i] * s, y[4] + y[5] * arm[i] * c
            speed = math.hypot(vx, vy, ROUNDED)
            px, py = -mu[i] * m[i] * G * vx / speed, -mu[i] * m[i] * G * vy / speed
            fx, fy, turn = fx + px, fy + py, turn + arm[i] * (c * py - s * px)
        return [*y[3:], fx / total, fy / total, turn / inertia]

    y = solve_ivp(f, (0, until), (0, 0, 0, u, w, omega), "Radau", rtol=3e-14, atol=1e-16).y[:, -1]
    places, ends = [], []
    for i in range(2):
        c, s = np.cos(y[2]), np.sin(y[2])
        places += [y[0] + arm[i] * c, y[1] + arm[i] * s]
        ends += [y[3] - y[5] * arm[i] * s, y[4] + y[5] * arm[i] * c]
    scene = Scene(
        tuple(Body(m[i], (arm[i], 0.0), (u, w + omega * arm[i])) for i in range(2)),
        (Rod((0, 1)), *(Friction(i, mu[i]) for i in range(2))),
        until=until,
    )
    return Case("sliding dumbbell", scene, {V: floats(*ends), X: floats(*places)}, (until,))


def pucks_on_a_spring(draw: Random) -> Case:
    """Two pucks on a spring slide over a rough table, in a plane."""
    m, mu, k = (
        (draw.uniform(0.2, 1), draw.uniform(0.2, 1)),
        (0.1, draw.uniform(0.05, 0.2)),
        draw.uniform(5, 40),
    )
    v, until = ((draw.uniform(1, 3), 1.0), (-1.0, draw.uniform(-3, -1))), draw.uniform(0.1, 0.5)

    def f(t: Any, y: Any, flags: Any) -> Any:
        apart = y[2:4] - y[:2]
        r = np.sqrt(apart @ apart)
        pull = k * (r - 1) * apart / r
        rates = [*y[4:]]
        for i, sign in enumerate((1, -1)):
            u = y[4 + 2 * i : 6 + 2 * i]
            rates += [*(sign * pull / m[i] - mu[i] * G * u / np.sqrt(u @ u))]
        return rates

    y = follow(f, (0, 0, 1, 0, *v[0], *v[1]), until, h=0.01)
    scene = Scene(
        (Body(m[0], (0.0, 0.0), v[0]), Body(m[1], (1.0, 0.0), v[1])),
        (Spring((0, 1), k, 1.0), *(Friction(i, mu[i]) for i in range(2))),
        until=until,
    )
    return Case("pucks on a spring", scene, {V: floats(*y[4:]), X: floats(*y[:4])}, (until,))


def dragged_round(draw: Random) -> Case:
    """A force that grows and turns sets a puck moving: at first as slowly as friction lets it, in a direction that is the force's."""
    mu, c, w, until = draw.uniform(0.1, 0.5), draw.uniform(1, 5), draw.uniform(-3, 3), draw.uniform(0.2, 1)
    m, press = 0.5, mu * 0.5 * G
    begin = (1 - 0.9) / c

    def push(t: float) -> tuple[float, float]:
        strong = press * (0.9 + c * t)
        return strong * math.cos(w * t), strong * math.sin(w * t)

    def f(t: float, y: Any) -> Any:
        (px, py), speed = push(t), math.hypot(y[2], y[3])
        return y[2], y[3], (px - press * y[2] / speed) / m, (py - press * y[3] / speed) / m

    # From where it is still slow, along the force: friction turns it there at a rate mu g over its speed.
    slow = 1e-12
    y = (0.0, 0.0, slow * math.cos(w * begin), slow * math.sin(w * begin))
    y = solve_ivp(f, (begin, begin + until), y, "LSODA", rtol=1e-12, atol=1e-15).y[:, -1]
    scene = Scene(
        (Body(m, (0.0, 0.0), (0.0, 0.0)),),
        (ForceFunction(0, lambda t, x, v: push(t)), Friction(0, mu)),
        until=begin + until,
    )
    return Case("dragged round", scene, {V: floats(*y[2:]), X: floats(*y[:2])}, (begin + until,))


FAMILIES = (
    dragged_round,
    nudged_through_a_spring,
    earthquakes,
    shaken_block,
    three_frictions,
    chain_on_a_table,
    bumper,
    two_belts,
    coupled_by_a_rod,
    puck_on_a_string,
    puck_on_a_belt,
    puck_off_a_cushion,
    sliding_dumbbell,
    pucks_on_a_spring,
)
