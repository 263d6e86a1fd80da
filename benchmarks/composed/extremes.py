"""Families that a physicist's exercises and their extremes suggest: fades, wind, chains of springs, three bodies, hits at one moment."""

from __future__ import annotations

import math
from random import Random

import numpy as np
from scipy.optimize import brentq

from corollary.scenes.forces.bonds import Spring, String
from corollary.scenes.forces.contact import Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, InverseSquare, Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .case import Case

V, X = Observable.VELOCITIES, Observable.TRAJECTORY
G = 9.8


def stiff_dashpot(draw: Random) -> Case:
    """Two carts with a dashpot between them that fades their relative velocity e^20 to e^2000 times, in 1e-9 s to 10 s."""
    fade, t = 10 ** draw.uniform(1.3, 3.3), 10 ** draw.uniform(-9, 1)
    a, b, v, u = 10 ** draw.uniform(-3, 3), 10 ** draw.uniform(-3, 3), draw.uniform(1, 9), draw.uniform(-9, 1)
    m, force = a * b / (a + b), draw.choice([0.0, draw.uniform(-3, 3)])
    left, late, apart = math.exp(-fade), force * t / (a * fade), 30 * (v - u) * t + 1.0
    push = (ForceFunction(0, lambda t, x, v: (force,)),) if force else ()
    scene = Scene(
        (Body(a, (0.0,), (v,)), Body(b, (apart,), (u,))),
        (Spring((0, 1), 0.0, damping=fade * m / t), *push),
        until=t,
    )
    relative = late + (v - u - late) * left
    common = (a * v + b * u + force * t) / (a + b)
    return Case(
        "stiff dashpot", scene, {V: (common + b / (a + b) * relative, common - a / (a + b) * relative)}, ()
    )


def thick_fluid(draw: Random) -> Case:
    """A stone falls in a thick fluid."""
    rate, u, v, t = 10 ** draw.uniform(2, 5), draw.uniform(1, 5), draw.uniform(-5, 5), draw.uniform(0.1, 3)
    end, gone = G / rate, -math.expm1(-rate * t)
    scene = Scene((Body(1.0, (0.0, 0.0), (u, v)),), (Weight(G), Drag(0, linear=rate)), until=t)
    return Case(
        "thick fluid", scene, {V: (0.0, -end), X: (u * gone / rate, (v + end) * gone / rate - end * t)}, (t,)
    )


def damped_swing(draw: Random) -> Case:
    """A damped oscillator, weakly to strongly: exponentials of complex roots."""
    k, m, share = 10 ** draw.uniform(-3, 6), 10 ** draw.uniform(-3, 3), draw.uniform(0.01, 3)
    w = math.sqrt(k / m)
    t, x0, v0 = draw.uniform(0.1, 12) / w, draw.uniform(0.1, 0.8), 0.3 * w
    root = complex(share * share - 1) ** 0.5 * w
    one, two = -share * w + root, -share * w - root
    first = (v0 - two * x0) / (one - two)
    second = x0 - first
    x = first * np.exp(one * t) + second * np.exp(two * t)
    v = first * one * np.exp(one * t) + second * two * np.exp(two * t)
    scene = Scene(
        (Body(math.inf, (0.0,), (0.0,)), Body(m, (3.0 + x0,), (v0,))),
        (Spring((0, 1), k, 3.0, 2 * share * math.sqrt(k * m)),),
        until=t,
    )
    return Case("damped swing", scene, {V: (0, float(v.real)), X: (0, float(3.0 + x.real))}, (t,))


def chain_of_springs(draw: Random) -> Case:
    """Three to five unequal bodies on springs in a row: normal modes, by an eigenvalue problem."""
    n, t = draw.choice([3, 4, 5]), draw.uniform(0.3, 4)
    m = [10 ** draw.uniform(-1, 1) for _ in range(n)]
    k = [10 ** draw.uniform(0, 2) for _ in range(n - 1)]
    off, v = [draw.uniform(-0.1, 0.1) for _ in range(n)], [draw.uniform(-0.5, 0.5) for _ in range(n)]
    stiff = np.zeros((n, n))
    for i, each in enumerate(k):
        stiff[i : i + 2, i : i + 2] += each * np.array([[1, -1], [-1, 1]])
    root = np.sqrt(m)
    squares, modes = np.linalg.eigh(stiff / np.outer(root, root))
    p, q = modes.T @ (root * off), modes.T @ (root * v)
    w = np.sqrt(np.maximum(squares, 0.0))
    w[0] = 0.0
    swings = np.where(w > 0, np.sin(w * t) / np.where(w > 0, w, 1), t)
    ends = modes @ (p * np.cos(w * t) + q * swings) / root
    rates = modes @ (q * np.cos(w * t) - p * w * np.sin(w * t)) / root
    bodies = tuple(Body(m[i], (2.0 * i + off[i],), (v[i],)) for i in range(n))
    springs = tuple(Spring((i, i + 1), each, 2.0) for i, each in enumerate(k))
    places = tuple(2.0 * i + float(x) for i, x in enumerate(ends))
    return Case(
        "chain of springs", Scene(bodies, springs, until=t), {V: tuple(map(float, rates)), X: places}, (t,)
    )


def lagrange(draw: Random) -> Case:
    """Three equal stars at the corners of a turning triangle (Lagrange): they stay there."""
    m, strength, side = draw.uniform(0.5, 2), draw.uniform(0.5, 2), draw.uniform(0.5, 3)
    r = side / math.sqrt(3)
    w = math.sqrt(math.sqrt(3) * strength / side**2 / (m * r))
    t = draw.uniform(0.1, 0.9) * 2 * math.pi / w

    def at(time: float):
        angles = [w * time + 2 * math.pi * i / 3 for i in range(3)]
        places = [(r * math.cos(a), r * math.sin(a)) for a in angles]
        return places, [(-w * y, w * x) for x, y in places]

    (places, speeds), (ends, rates) = at(0.0), at(t)
    bodies = tuple(Body(m, x, v) for x, v in zip(places, speeds, strict=True))
    pulls = tuple(InverseSquare(pair, strength) for pair in ((0, 1), (1, 2), (0, 2)))
    truth = {V: tuple(c for v in rates for c in v), X: tuple(c for x in ends for c in x)}
    return Case("three bodies", Scene(bodies, pulls, until=t), truth, (t,))


def hits_at_one_moment(draw: Random) -> Case:
    """Two to four balls fall from one height beside each other and hit the floor at one moment, each with its own restitution."""
    h, n, part = draw.uniform(0.5, 5), draw.choice([2, 3, 4]), draw.uniform(0.1, 0.9)
    es, us = [draw.uniform(0.2, 1) for _ in range(n)], [draw.uniform(-1, 1) for _ in range(n)]
    t0 = math.sqrt(2 * h / G)
    left = part * 2 * min(es) * t0
    bodies = tuple(Body(1.0 + i, (5.0 * i, h), (u, 0.0)) for i, u in enumerate(us))
    walls = tuple(HardWall((0.0, 1.0), 0.0, e, only=(i,)) for i, e in enumerate(es))
    speeds = [e * G * t0 for e in es]
    truth = {
        V: tuple(c for u, v in zip(us, speeds, strict=True) for c in (u, v - G * left)),
        X: tuple(
            c
            for i, (u, v) in enumerate(zip(us, speeds, strict=True))
            for c in (5.0 * i + u * (t0 + left), v * left - G * left**2 / 2)
        ),
    }
    return Case(
        "hits at one moment", Scene(bodies, (Weight(G), *walls), until=t0 + left), truth, (t0 + left,)
    )


def braked_by_both(draw: Random) -> Case:
    """Dry friction and quadratic drag stop a body while another falls: tangent and cosine."""
    m, mu, c, v = (
        10 ** draw.uniform(-2, 3),
        draw.uniform(0.05, 0.8),
        10 ** draw.uniform(-3, 2),
        10 ** draw.uniform(0, 2),
    )
    scale, rate = math.sqrt(mu * m * G / c), math.sqrt(mu * G * c / m)
    stops = math.atan(v / scale) / rate
    t = stops * draw.uniform(0.2, 2)
    angle = max(math.atan(v / scale) - rate * t, 0.0)
    way = m / (2 * c) * (math.log1p((v / scale) ** 2) - math.log1p(math.tan(angle) ** 2))
    scene = Scene((Body(m, (1.0,), (v,)),), (Friction(0, mu, G), Drag(0, quadratic=c)), until=t)
    return Case("braked by both", scene, {V: (scale * math.tan(angle),), X: (1.0 + way,)}, (t,))


def bounce_in_air(draw: Random) -> Case:
    """A ball falls through air with wind, bounces once, and rises: exponentials, and the moment by Brent's method."""
    m, c, h, e, wind = (
        draw.uniform(0.1, 2),
        draw.uniform(0.05, 1),
        draw.uniform(1, 9),
        draw.uniform(0.3, 1),
        draw.uniform(-4, 4),
    )
    tau = m / c
    end = G * tau

    def fallen(t, y, v):
        gone = -math.expm1(-t / tau)
        return y + (v + end) * tau * gone - end * t, (v + end) * math.exp(-t / tau) - end

    t0 = brentq(lambda t: fallen(t, h, 0.0)[0], 0.0, 20 + h / end * 2, xtol=1e-16, rtol=1e-15)
    up = -e * fallen(t0, h, 0.0)[1]
    left = draw.uniform(0.1, 0.8) * up / G
    y, v = fallen(left, 0.0, up)
    t = t0 + left
    level = -wind * math.expm1(-t / tau)
    scene = Scene(
        (Body(m, (0.0, h), (0.0, 0.0)),),
        (Weight(G), Drag(0, linear=c, wind=(wind, 0.0)), HardWall((0.0, 1.0), 0.0, e)),
        until=t,
    )
    return Case("bounce in air", scene, {V: (level, v), X: (wind * t - tau * level, y)}, (t,))


def jerk(draw: Random) -> Case:
    """A flying body jerks another, at rest, along by a string, with any restitution and masses up to 1e8 times as heavy."""
    a, b, length, v, e = (
        10 ** draw.uniform(-4, 4),
        10 ** draw.uniform(-4, 4),
        draw.uniform(1, 3),
        draw.uniform(1, 5),
        draw.random(),
    )
    t0 = (length - 0.5) / v
    left = draw.uniform(0.1, 0.9)
    impulse = (1 + e) * a * b / (a + b) * v
    va, vb = v - impulse / a, impulse / b
    scene = Scene(
        (Body(a, (0.5, 0.0), (v, 0.0)), Body(b, (0.0, 0.0), (0.0, 0.0))),
        (String((0, 1), length, restitution=e),),
        until=t0 + min(left, 0.5 * length / v),
    )
    left = scene.until - t0
    return Case("jerk", scene, {V: (va, 0, vb, 0), X: (length + va * left, 0, vb * left, 0)}, (scene.until,))


def unequal_pair(draw: Random) -> Case:
    """Two bodies on a spring whose masses differ by up to 1e12."""
    a, b, k, length = 10 ** draw.uniform(-6, 6), 10 ** draw.uniform(-6, 6), 10 ** draw.uniform(-2, 4), 2.0
    m = a * b / (a + b)
    w, v = math.sqrt(k / m), draw.uniform(0.1, 1)
    r0 = 0.3 * length
    t = draw.uniform(0.2, 9) / w
    speed = v * r0 * w
    r = length + r0 * math.cos(w * t) + speed / w * math.sin(w * t)
    rate = -r0 * w * math.sin(w * t) + speed * math.cos(w * t)
    scene = Scene(
        (Body(a, (0.0,), (-b / (a + b) * speed,)), Body(b, (length + r0,), (a / (a + b) * speed,))),
        (Spring((0, 1), k, length),),
        until=t,
    )
    centre = b * (length + r0) / (a + b)
    truth = {
        V: (-b / (a + b) * rate, a / (a + b) * rate),
        X: (centre - b / (a + b) * r, centre + a / (a + b) * r),
    }
    return Case("unequal pair on a spring", scene, truth, (t,))


FAMILIES = (
    stiff_dashpot, thick_fluid, damped_swing, chain_of_springs, lagrange, hits_at_one_moment, braked_by_both, bounce_in_air,
    jerk, unequal_pair,
)  # fmt: skip
