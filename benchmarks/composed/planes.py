"""Families in a plane: pendula, strings, orbits, discs; references are closed forms, quadratures, or other coordinates in LSODA and DOP853."""

from __future__ import annotations

import math
from random import Random

from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipk

from corollary.derive.ready_scenes import run
from corollary.scenes.forces.bonds import Rod, Spring, String
from corollary.scenes.forces.contact import Contact, HardWall
from corollary.scenes.forces.fields import InverseSquare, Weight
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .case import Case

V, X, S = Observable.VELOCITIES, Observable.TRAJECTORY, Observable.SPINS
NAIL = Body(math.inf, (0.0, 0.0), (0.0, 0.0))
G = 9.8
NAN = math.nan
NOT_COMPARED = (NAN, NAN)


def _end(slope, start, t):
    return solve_ivp(slope, (0.0, t), start, method="DOP853", rtol=3e-14, atol=1e-14).y[:, -1]


def pendulum(draw: Random) -> Case:
    """A rod and a bob let go at an angle: elliptic functions."""
    length, a, t = draw.uniform(0.3, 3), draw.uniform(0.1, 2.9), draw.uniform(0.3, 6)
    k, w = math.sin(a / 2), math.sqrt(G / length)
    quarter = float(ellipk(k * k))
    sn, cn, _, _ = ellipj((quarter - w * t) % (4 * quarter), k * k)
    angle, rate = 2 * math.asin(k * sn), -2 * k * w * cn
    scene = Scene(
        (NAIL, Body(0.6, (length * math.sin(a), -length * math.cos(a)), (0.0, 0.0))),
        (Rod((0, 1)), Weight(G)),
        until=t,
    )
    c, s = math.cos(angle), math.sin(angle)
    truth = {V: (0, 0, length * rate * c, length * rate * s), X: (0, 0, length * s, -length * c)}
    return Case("pendulum", scene, truth, (t,))


def double_pendulum(draw: Random) -> Case:
    """Two rods, one below the other: angles and Lagrange's equations."""
    l1, l2, m1, m2 = (draw.uniform(0.3, 1.5) for _ in range(4))
    a1, a2, t = draw.uniform(-1.2, 1.2), draw.uniform(-1.2, 1.2), draw.uniform(0.3, 2.5)

    def slope(_, y):
        p, q, u, v = y
        c, s = math.cos(p - q), math.sin(p - q)
        m11, m12, m22 = (m1 + m2) * l1 * l1, m2 * l1 * l2 * c, m2 * l2 * l2
        f1 = -m2 * l1 * l2 * s * v * v - (m1 + m2) * G * l1 * math.sin(p)
        f2 = m2 * l1 * l2 * s * u * u - m2 * G * l2 * math.sin(q)
        d = m11 * m22 - m12 * m12
        return [u, v, (m22 * f1 - m12 * f2) / d, (m11 * f2 - m12 * f1) / d]

    p, q, u, v = _end(slope, [a1, a2, 0.0, 0.0], t)

    def ends(p, q):
        x, y = l1 * math.sin(p), -l1 * math.cos(p)
        return (x, y), (x + l2 * math.sin(q), y - l2 * math.cos(q))

    first, second = ends(a1, a2)
    scene = Scene(
        (NAIL, Body(m1, first, (0.0, 0.0)), Body(m2, second, (0.0, 0.0))),
        (Rod((0, 1)), Rod((1, 2)), Weight(G)),
        until=t,
    )
    va = l1 * u * math.cos(p), l1 * u * math.sin(p)
    vb = va[0] + l2 * v * math.cos(q), va[1] + l2 * v * math.sin(q)
    (x1, y1), (x2, y2) = ends(p, q)
    return Case("double pendulum", scene, {V: (0, 0, *va, *vb), X: (0, 0, x1, y1, x2, y2)}, (t,))


def thrown_on_a_string(draw: Random) -> Case:
    """A ball on a slack string is thrown; the string jerks taut, takes the radial velocity, and it swings on."""
    length = draw.uniform(0.8, 2)
    x0, y0 = draw.uniform(-0.3, 0.3) * length, draw.uniform(-0.5, 0.1) * length
    u, v = draw.choice([-1, 1]) * draw.uniform(1, 3), draw.uniform(-2, 1)

    def beyond(t):
        return math.hypot(x0 + u * t, y0 + v * t - G * t * t / 2) - length

    low, high = 0.0, 1e-3
    while beyond(high) < 0.0:
        low, high = high, high + 1e-3
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if beyond(middle) < 0.0 else (low, middle)
    t0 = high
    x, y, w = x0 + u * t0, y0 + v * t0 - G * t0 * t0 / 2, v - G * t0
    angle, rate = math.atan2(x, -y), (u * -y + w * x) / length**2
    left = draw.uniform(0.05, 0.4)
    # Taut only while it pulls: below the height of the nail it always does.
    if y > -0.2 * length:
        return thrown_on_a_string(draw)
    angles = solve_ivp(
        lambda _, s: [s[1], -G / length * math.sin(s[0])],
        (0, left),
        [angle, rate],
        method="DOP853",
        rtol=3e-14,
        atol=1e-14,
    ).y
    if any(math.cos(p) < 0.05 for p in angles[0]):
        return thrown_on_a_string(draw)
    p, r = angles[:, -1]
    scene = Scene((NAIL, Body(0.4, (x0, y0), (u, v))), (String((0, 1), length), Weight(G)), until=t0 + left)
    c, s = math.cos(p), math.sin(p)
    truth = {V: (0, 0, length * r * c, length * r * s), X: (0, 0, length * s, -length * c)}
    return Case("thrown on a string", scene, truth, (t0 + left,))


def over_the_top(draw: Random) -> Case:
    """A ball on a string without enough speed for the loop: it leaves the circle where the string no longer pulls."""
    length = draw.uniform(0.5, 2)
    speed = math.sqrt(G * length * draw.uniform(2.3, 4.7))
    height = (speed**2 - 2 * G * length) / (
        3 * G * length
    )  # cos of the angle from the top where the pull ends
    leaves = math.pi - math.acos(height)

    def stop(_, s):
        return s[0] - leaves

    stop.terminal = True
    found = solve_ivp(
        lambda _, s: [s[1], -G / length * math.sin(s[0])],
        (0, 50),
        [0.0, speed / length],
        method="DOP853",
        rtol=3e-14,
        atol=1e-14,
        events=stop,
    )
    t0, (angle, rate) = float(found.t_events[0][0]), found.y_events[0][0]
    c, s = math.cos(angle), math.sin(angle)
    x, y, u, v = length * s, -length * c, length * rate * c, length * rate * s
    left = draw.uniform(0.1, 0.6) * v / G
    scene = Scene(
        (NAIL, Body(0.4, (0.0, -length), (speed, 0.0))), (String((0, 1)), Weight(G)), until=t0 + left
    )
    truth = {V: (0, 0, u, v - G * left), X: (0, 0, x + u * left, y + v * left - G * left**2 / 2)}
    return Case("over the top", scene, truth, (t0 + left,))


def cradle_with_gravity(draw: Random) -> Case:
    """Two balls on rods beside each other, one let go: angles, and the contact between, from its first touch to its last."""
    length, r, k, m1, m2 = (
        draw.uniform(0.3, 1),
        0.03,
        10 ** draw.uniform(4, 6),
        draw.uniform(0.1, 0.4),
        draw.uniform(0.1, 0.4),
    )
    a, t = draw.uniform(0.1, 0.8), 1.9 * math.sqrt(length / G)

    def apart(p, q):
        return 2 * r + length * (math.sin(q) - math.sin(p)), -length * (math.cos(q) - math.cos(p))

    def gap(_, y):
        return math.hypot(*apart(y[0], y[1])) - 2 * r

    def slope(_, y):
        p, q, u, v = y
        dx, dy = apart(p, q)
        d = math.hypot(dx, dy)
        push = k * max(2 * r - d, 0.0) ** 1.5
        on = push * dx / d, push * dy / d
        return [
            u,
            v,
            -G / length * math.sin(p) - (on[0] * math.cos(p) + on[1] * math.sin(p)) / (m1 * length),
            -G / length * math.sin(q) + (on[0] * math.cos(q) + on[1] * math.sin(q)) / (m2 * length),
        ]

    y, begun = [-a, 0.0, 0.0, 0.0], 0.0
    gap.terminal = True
    for gap.direction, longest in ((-1, math.inf), (1, 1e-4), (-1, math.inf)):
        solved = solve_ivp(
            slope, (begun, t), y, "DOP853", events=gap, rtol=1e-13, atol=1e-15, max_step=longest
        )
        y, begun = solved.y[:, -1], solved.t[-1]
    p, q, u, v = y
    bodies = (
        Body(math.inf, (0.0, 0.0), (0.0, 0.0)),
        Body(math.inf, (2 * r, 0.0), (0.0, 0.0)),
        Body(m1, (-length * math.sin(a), -length * math.cos(a)), (0.0, 0.0), r),
        Body(m2, (2 * r, -length), (0.0, 0.0), r),
    )
    scene = Scene(bodies, (Rod((0, 2)), Rod((1, 3)), Weight(G), Contact(k, 1.5, chosen=((2, 3),))), until=t)
    first = length * u * math.cos(p), length * u * math.sin(p)
    second = length * v * math.cos(q), length * v * math.sin(q)
    return Case("cradle with gravity", scene, {V: (0, 0, 0, 0, *first, *second)}, ())


def dumbbell(draw: Random) -> Case:
    """Two balls on a rod thrown: the centre flies, the rod turns steadily."""
    m1, m2, length, rate, t = (draw.uniform(0.3, 2) for _ in range(5))
    rate *= 3
    u, v = draw.uniform(-3, 3), draw.uniform(0, 6)
    r1, r2 = m2 / (m1 + m2) * length, m1 / (m1 + m2) * length
    scene = Scene(
        (Body(m1, (-r1, 0.0), (u, v - rate * r1)), Body(m2, (r2, 0.0), (u, v + rate * r2))),
        (Rod((0, 1)), Weight(G)),
        until=t,
    )
    c, s = math.cos(rate * t), math.sin(rate * t)
    x, y, w = u * t, v * t - G * t * t / 2, v - G * t
    truth = {
        V: (u + rate * r1 * s, w - rate * r1 * c, u - rate * r2 * s, w + rate * r2 * c),
        X: (x - r1 * c, y - r1 * s, x + r2 * c, y + r2 * s),
    }
    return Case("dumbbell", scene, truth, (t,))


def kepler(draw: Random) -> Case:
    """A bound orbit, looked up at a time: Kepler's equation."""
    e, a, mu = draw.uniform(0, 0.85), draw.uniform(0.5, 3), draw.uniform(0.5, 3)
    n = math.sqrt(mu / a**3)
    t = draw.uniform(0.2, 2.2) * 2 * math.pi / n
    q = a * (1 - e)
    speed = math.sqrt(mu * (1 + e) / q)
    anomaly = n * t
    for _ in range(100):
        anomaly -= (anomaly - e * math.sin(anomaly) - n * t) / (1 - e * math.cos(anomaly))
    c, s = math.cos(anomaly), math.sin(anomaly)
    b = a * math.sqrt(1 - e * e)
    d = a * n / (1 - e * c)
    scene = Scene((Body(1.0, (q, 0.0), (0.0, speed)), NAIL), (InverseSquare((0, 1), mu),), until=t)
    return Case("Kepler", scene, {V: (-d * s, d * b / a * c, 0, 0), X: (a * (c - e), b * s, 0, 0)}, (t,))


def grazing_disc(draw: Random) -> Case:
    """Two discs nearly miss each other, a third far off makes it a composed scene: quadrature of the pair."""
    r, m1, m2, v = 0.05, draw.uniform(0.1, 1), draw.uniform(0.1, 1), draw.uniform(0.5, 3)
    k, b = 10 ** draw.uniform(4, 6), 2 * r * (1 - 10 ** draw.uniform(-6, -0.5))
    far = 10 ** draw.uniform(0, 1.5)
    found = run(
        "spheres",
        {
            "mA": m1,
            "mB": m2,
            "R": r,
            "k": k,
            "eta": 0.0,
            "dx": far,
            "dy": b,
            "vA": (v, 0.0),
            "vB": (0.0, 0.0),
        },
    )
    if found.model != "quadrature":
        return grazing_disc(draw)
    bodies = (
        Body(m1, (0.0, 0.0), (v, 0.0), r),
        Body(m2, (far, b), (0.0, 0.0), r),
        Body(1.0, (0.0, -500.0), (0.0, -1.0), r),
    )
    return Case(
        "grazing discs", Scene(bodies, (Contact(k, 1.5),)), {V: (*found.observed["velocities"], 0, -1)}, ()
    )


def row_in_a_plane(draw: Random) -> Case:
    """A touching row of balls in a plane, turned by an angle: the cradle on its line."""
    n, q, angle = draw.choice([3, 4]), draw.choice([1.0, 1.5, 3.0]), draw.uniform(0, 6.28)
    c, s = math.cos(angle), math.sin(angle)
    k = {1.0: 1e4, 1.5: 1e5, 3.0: 1e9}[q]
    gap = draw.choice([1e-3, 1e-4])
    found = run("cradle", {"N": n, "q": q, "m": 0.2, "k": k, "v0": 1.0, "gaps": gap}).observed["velocities"]
    bodies = tuple(
        Body(0.2, (c * i * (0.1 + gap), s * i * (0.1 + gap)), (c * (i == 0), s * (i == 0)), 0.05)
        for i in range(n)
    )
    scene = Scene(bodies, (Contact(k, q),))
    return Case("row in a plane", scene, {V: tuple(x for v in found for x in (v * c, v * s))}, ())


def spring_pair_in_a_plane(draw: Random) -> Case:
    """Two balls on a spring, thrown and turning: the relative motion in polar coordinates."""
    m1, m2, k, length = (
        draw.uniform(0.3, 2),
        draw.uniform(0.3, 2),
        draw.uniform(10, 100),
        draw.uniform(0.5, 1.5),
    )
    v, t, m = draw.uniform(0.5, 2), draw.uniform(0.5, 4), 0.0
    m = m1 * m2 / (m1 + m2)
    spin = length * v
    r, dr, p = _end(
        lambda _, y: [y[1], spin**2 / y[0] ** 3 - k / m * (y[0] - length), spin / y[0] ** 2],
        [length, 0.3, 0.0],
        t,
    )
    a, b = m2 / (m1 + m2), m1 / (m1 + m2)
    u = dr * math.cos(p) - spin / r * math.sin(p), dr * math.sin(p) + spin / r * math.cos(p)
    scene = Scene(
        (Body(m1, (0.0, 0.0), (1.0 - a * 0.3, -a * v)), Body(m2, (length, 0.0), (1.0 + b * 0.3, b * v))),
        (Spring((0, 1), k, length),),
        until=t,
    )
    return Case("spring in a plane", scene, {V: (1 - a * u[0], -a * u[1], 1 + b * u[0], b * u[1])}, ())


def billiard(draw: Random) -> Case:
    """A point in a box: unfolded, it flies straight."""
    w, h, u, v, t = (
        draw.uniform(0.5, 2),
        draw.uniform(0.5, 2),
        draw.uniform(-3, 3),
        draw.uniform(-3, 3),
        draw.uniform(1, 12),
    )
    x0, y0 = draw.uniform(0.1, 0.9) * w, draw.uniform(0.1, 0.9) * h

    def folded(x, size):
        x %= 2 * size
        return (x, 1.0) if x <= size else (2 * size - x, -1.0)

    (x, sx), (y, sy) = folded(x0 + u * t, w), folded(y0 + v * t, h)
    walls = HardWall((1.0, 0.0)), HardWall((-1.0, 0.0), -w), HardWall((0.0, 1.0)), HardWall((0.0, -1.0), -h)
    scene = Scene((Body(1.0, (x0, y0), (u, v)),), walls, until=t)
    return Case("billiard", scene, {V: (u * sx, v * sy), X: (x, y)}, (t,))


FAMILIES = (
    pendulum, double_pendulum, thrown_on_a_string, over_the_top, cradle_with_gravity, dumbbell, kepler, grazing_disc,
    row_in_a_plane, spring_pair_in_a_plane, billiard,
)  # fmt: skip
