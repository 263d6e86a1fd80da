"""Families with weight and hard walls: plates that move, corners, inclines, spin, hoppers; references are closed forms or `follow`."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import numpy as np
from mpmath import mp

from corollary.scenes.forces.drag import Drag
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.rod import Rod
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .case import Case
from .reference import follow
from .rough import floats

V, X, S = Observable.VELOCITIES, Observable.TRAJECTORY, Observable.SPINS
G = 9.8
NAN = math.nan


def met(gap: Any, low: Any, high: Any, steps: int = 400) -> Any:
    """The first time in an interval at which a gap that is above zero at its start (or just after) is gone, in 30 digits."""
    with mp.workdps(30):
        width = (mp.mpf(high) - low) / steps
        for i in range(1, steps + 1):
            a, b = low + (i - 1) * width, low + i * width
            if gap(b) <= 0 and (i > 1 or gap(a + width / 100) > 0):
                a = a + width / 100 if i == 1 else a
                for _ in range(100):
                    c = (a + b) / 2
                    a, b = (c, b) if gap(c) > 0 else (a, c)
                return b
        return None


def juggled(draw: Random) -> Case:
    """A ball bounces on a plate that swings, a few times."""
    a, w, e = draw.uniform(0.01, 0.05), draw.uniform(5, 15), draw.uniform(0.7, 1)
    h, until = draw.uniform(0.5, 1), draw.uniform(0.8, 1.5)
    with mp.workdps(30):
        t, x, v = mp.mpf(0), mp.mpf(h), mp.mpf(0)
        while hit := met(
            lambda s, t=t, x=x, v=v: x + v * (s - t) - mp.mpf(G) / 2 * (s - t) ** 2 - a * mp.sin(w * s),
            t,
            until,
        ):
            x, v = a * mp.sin(w * hit), v - G * (hit - t)
            plate = a * w * mp.cos(w * hit)
            v, t = plate + e * (plate - v), hit
        left = until - t
        x, v = x + v * left - mp.mpf(G) / 2 * left**2, v - G * left

    def moves(t: float) -> tuple[float, float, float]:
        return a * math.sin(w * t), a * w * math.cos(w * t), -a * w * w * math.sin(w * t)

    scene = Scene(
        (Body(0.3, (0.0, h), (0.4, 0.0)),),
        (Weight(G), HardWall((0.0, 1.0), 0.0, e, moves=moves)),
        until=until,
    )
    return Case("juggled", scene, {V: floats(0.4, v), X: floats(0.4 * until, x)}, (until,))


def fermi_ulam(draw: Random) -> Case:
    """A ball flies between a wall and one that swings."""
    a, w, v0, until = draw.uniform(0.02, 0.1), draw.uniform(1, 4), draw.uniform(2, 5), draw.uniform(1, 3)
    with mp.workdps(30):
        t, x, v = mp.mpf(0), mp.mpf("0.5"), mp.mpf(v0)
        while True:
            at_zero = t - x / v if v < 0 else mp.inf
            hit = met(
                lambda s, t=t, x=x, v=v: 1 + a * mp.sin(w * s) - x - v * (s - t), t, min(until, at_zero)
            )
            if hit is None and at_zero > until:
                break
            if hit is None:
                t, x, v = at_zero, mp.mpf(0), -v
            else:
                t, x, v = hit, 1 + a * mp.sin(w * hit), 2 * a * w * mp.cos(w * hit) - v
        x += v * (until - t)

    def moves(t: float) -> tuple[float, float, float]:
        return -1 - a * math.sin(w * t), -a * w * math.cos(w * t), a * w * w * math.sin(w * t)

    scene = Scene(
        (Body(1.0, (0.5,), (v0,)),), (HardWall((1.0,)), HardWall((-1.0,), moves=moves)), until=until
    )
    return Case("Fermi and Ulam", scene, {V: floats(v), X: floats(x)}, (until,))


def lift(draw: Random) -> Case:
    """A ball bounces itself to rest in a lift that gathers speed."""
    a, e, h, u = draw.uniform(-3, 5), draw.uniform(0.2, 0.7), draw.uniform(0.3, 2), draw.uniform(-1, 1)
    fall = math.sqrt(2 * h / (G + a))
    until = fall * (1 + e) / (1 - e) * draw.uniform(1.1, 2)
    scene = Scene(
        (Body(0.3, (0.0, h), (u, 0.0)),),
        (Weight(G), HardWall((0.0, 1.0), 0.0, e, moves=lambda t: (a * t * t / 2, a * t, a))),
        until=until,
    )
    return Case("lift", scene, {V: (u, a * until), X: (u * until, a * until * until / 2)}, (until,))


def dropped_together(draw: Random) -> Case:
    """Five balls of other heights and restitutions bounce side by side; some lie while others still fly."""
    until, bodies, walls = draw.uniform(1, 3), [], []
    v_end: list[float] = []
    x_end: list[float] = []
    for i in range(5):
        h, e = draw.uniform(0.2, 3), draw.choice([0.0, draw.uniform(0.1, 0.5), draw.uniform(0.5, 1.0)])
        bodies.append(Body(0.1 + i, (float(i), h), (0.0, 0.0)))
        walls.append(HardWall((0.0, 1.0), 0.0, e, only=(i,)))
        t, speed = math.sqrt(2 * h / G), math.sqrt(2 * h * G)
        if t > until:
            v_end += [0, -G * until]
            x_end += [i, h - G * until**2 / 2]
            continue
        if t + 2 * speed / G * e / (1 - e) <= until:
            v_end += [0, 0]
            x_end += [i, 0]
            continue
        speed *= e
        while t + 2 * speed / G <= until:
            t, speed = t + 2 * speed / G, speed * e
        left = until - t
        v_end += [0, speed - G * left]
        x_end += [i, speed * left - G * left**2 / 2]
    return Case(
        "dropped together",
        Scene(tuple(bodies), (Weight(G), *walls), until=until),
        {V: tuple(v_end), X: tuple(x_end)},
        (until,),
    )


def dropped_into_a_wedge(draw: Random) -> Case:
    """A ball let go from rest bounces in a wedge that is not right-angled: what it was let go from doubles at every few bounces."""
    angle, until = draw.uniform(0.7, 1.1), draw.uniform(8, 13)
    ball = (draw.uniform(0.1, 0.5), draw.uniform(1.0, 2.5))
    c, s = math.cos(angle), math.sin(angle)
    with mp.workdps(60):
        x, v, left = mp.matrix(ball), mp.matrix([0, 0]), mp.mpf(until)
        weight, normals = mp.matrix([0, -mp.mpf(G)]), (mp.matrix([s, c]), mp.matrix([-s, c]))

        def hit(n: Any) -> Any:
            half, rate, gap = mp.fdot(n, weight) / 2, mp.fdot(n, v), mp.fdot(n, x)
            return (-rate - mp.sqrt(rate * rate - 4 * half * gap)) / (2 * half)

        while True:
            lasts, n = min(((hit(n), n) for n in normals), key=lambda each: each[0])
            if lasts > left:
                break
            x, v, left = x + v * lasts + weight * lasts**2 / 2, v + weight * lasts, left - lasts
            v -= 2 * mp.fdot(n, v) / mp.fdot(n, n) * n
            # On the side itself, which the next hit is not to be at once.
            x -= mp.fdot(n, x) / mp.fdot(n, n) * n
        x, v = x + v * left + weight * left**2 / 2, v + weight * left
    scene = Scene(
        (Body(0.5, ball, (0.0, 0.0)),), (Weight(G), HardWall((s, c)), HardWall((-s, c))), until=until
    )
    return Case("dropped into a wedge", scene, {V: floats(*v), X: floats(*x)}, (until,))


def right_wedge(draw: Random) -> Case:
    """A ball bounces in a right wedge: each side knows only its own share of the weight."""
    angle, until = draw.uniform(0.3, 1.2), draw.uniform(1, 5)
    c, s = math.cos(angle), math.sin(angle)
    normals, place, speed = ((s, c), (-c, s)), [], []
    starts = [(draw.uniform(0.3, 2), draw.uniform(-1, 1)) for _ in normals]
    for (x, v), n in zip(starts, normals, strict=True):
        g = G * n[1]
        # Up to the first touch, then periods of 2 v / g.
        top = x + v * v / (2 * g)
        hit = math.sqrt(2 * g * top)
        t = until - (v + hit) / g
        if t < 0:
            place.append(x + v * until - g * until**2 / 2)
            speed.append(v - g * until)
        else:
            t = math.fmod(t, 2 * hit / g)
            place.append(hit * t - g * t * t / 2)
            speed.append(hit - g * t)

    def whole(a: float, b: float) -> tuple[float, float]:
        return a * s - b * c, a * c + b * s

    body = Body(0.7, whole(starts[0][0], starts[1][0]), whole(starts[0][1], starts[1][1]))
    scene = Scene((body,), (Weight(G), *(HardWall(n) for n in normals)), until=until)
    return Case("right wedge", scene, {V: whole(*speed), X: whole(*place)}, (until,))


def into_the_corner(draw: Random) -> Case:
    """A disc flies exactly into the corner of two cushions and comes back the way it came."""
    v, e, r = draw.uniform(0.5, 3), draw.uniform(0.3, 1), draw.choice([0.125, 0.25])
    until = (1 - r) / v * draw.uniform(1.1, 1.9)
    left = until - (1 - r) / v
    scene = Scene(
        (Body(0.7, (1.0, 1.0), (-v, -v), r),),
        (HardWall((1.0, 0.0), 0.0, e), HardWall((0.0, 1.0), 0.0, e)),
        until=until,
    )
    return Case("into the corner", scene, {V: (e * v, e * v), X: (r + e * v * left,) * 2}, (until,))


def down_a_rough_incline(draw: Random) -> Case:
    """A point falls on a rough incline, bounces without end in a finite time, and slides on."""
    angle, mu, e, h = (
        draw.uniform(0.5, 1.0),
        draw.uniform(0.05, 0.3),
        draw.uniform(0.2, 0.6),
        draw.uniform(0.3, 2),
    )
    c, s = math.cos(angle), math.sin(angle)
    across, along = G * c, G * s
    speed, t = math.sqrt(2 * h * across), math.sqrt(2 * h / across)
    v, x = along * t, along * t * t / 2
    # The impulses of friction, mu (1 + e) times the normal speed, while it bounces: summed hit by hit.
    while speed > 1e-18:
        v -= mu * (1 + e) * speed
        speed *= e
        flight = 2 * speed / across
        x += v * flight + along * flight**2 / 2
        v, t = v + along * flight, t + flight
    until = t * draw.uniform(1.05, 2)
    a, left = along - mu * across, until - t
    x, v = x + v * left + a * left**2 / 2, v + a * left
    scene = Scene(
        (Body(0.4, (h * s, h * c), (0.0, 0.0)),), (Weight(G), HardWall((s, c), 0.0, e, mu)), until=until
    )
    return Case("down a rough incline", scene, {V: (v * c, -v * s), X: (x * c, -x * s)}, (until,))


def up_an_incline(draw: Random) -> Case:
    """A block slides up an incline, and stays there or comes back."""
    angle, mu, v0 = draw.uniform(0.1, 1.0), draw.uniform(0.05, 0.6), draw.uniform(1, 4)
    static, c, s = mu * draw.uniform(1, 1.4), math.cos(angle), math.sin(angle)
    up, down = G * (s + mu * c), G * (s - mu * c)
    t, top = v0 / up, v0**2 / (2 * up)
    until = t * draw.uniform(0.5, 3)
    if until < t:
        x, v = v0 * until - up * until**2 / 2, v0 - up * until
    elif math.tan(angle) <= static:
        x, v = top, 0.0
    else:
        x, v = top - down * (until - t) ** 2 / 2, -down * (until - t)
    wall = HardWall((-s, c), restitution=0.0, mu=mu, static=static)
    scene = Scene((Body(0.4, (0.0, 0.0), (v0 * c, v0 * s)),), (Weight(G), wall), until=until)
    return Case("up an incline", scene, {V: (v * c, v * s), X: (x * c, x * s)}, (until,))


def incline_and_floor(draw: Random) -> Case:
    """A point slides down a smooth incline and on along a rough floor, until it stops."""
    angle, h, mu, until = (
        draw.uniform(0.2, 1.1),
        draw.uniform(0.1, 1),
        draw.uniform(0.1, 0.5),
        draw.uniform(0.2, 4),
    )
    c, s = math.cos(angle), math.sin(angle)
    t = math.sqrt(2 * h / (G * s * s))
    if until < t:
        way = G * s * until**2 / 2
        x, y, u, w = (way - h / s) * c, h - way * s, G * s * until * c, -G * s * until * s
    else:
        # On the floor the blow is -v sin(angle), and friction takes its part of it.
        v = G * s * t
        u = max(v * c - mu * v * s, 0.0)
        left = min(until - t, u / (mu * G))
        x, y, w = u * left - mu * G * left**2 / 2, 0.0, 0.0
        u = u - mu * G * left if left == until - t else 0.0
    walls = HardWall((s, c), 0.0, 0.0), HardWall((0.0, 1.0), 0.0, 0.0, mu)
    scene = Scene((Body(0.4, (-h * c / s, h), (0.0, 0.0)),), (Weight(G), *walls), until=until)
    return Case("incline and floor", scene, {V: (u, w), X: (x, y)}, (until,))


def pressed_to_a_wall(draw: Random) -> Case:
    """A force that fades presses a block to a wall: it holds, then slips."""
    m, mu, rate = draw.uniform(0.2, 2), draw.uniform(0.2, 0.8), draw.uniform(0.3, 2)
    static = mu * draw.uniform(1, 1.4)
    start = m * G / static * draw.uniform(1.2, 3)
    slips = math.log(static * start / (m * G)) / rate
    until = slips + draw.uniform(-0.9 * slips, 1.5)
    t = max(until - slips, 0.0)
    # m v' = -m g + mu F(t)
    held = m * G / static
    v = -G * t + mu * held / m * -math.expm1(-rate * t) / rate
    x = -G * t * t / 2 + mu * held / m * (t + math.expm1(-rate * t) / rate) / rate
    scene = Scene(
        (Body(m, (0.0, 0.0), (0.0, 0.0)),),
        (
            Weight(G),
            ForceFunction(0, lambda t, x, v: (-start * math.exp(-rate * t), 0.0)),
            HardWall((1.0, 0.0), 0.0, 0.0, mu, static),
        ),
        until=until,
    )
    return Case("pressed to a wall", scene, {V: (0, v), X: (0, x)}, (until,))


def spun_in_a_corner(draw: Random) -> Case:
    """A spinning ball lies in the corner of a floor and a wall, which brake it together."""
    m, r, mu, spin = (
        draw.uniform(0.1, 1),
        draw.uniform(0.05, 0.3),
        draw.uniform(0.1, 0.5),
        draw.uniform(5, 60),
    )
    # Turning counter-clockwise it presses the wall on its left... the floor pushes it to the left.
    floor = m * G / (1 + mu * mu)
    rate = mu * (floor + mu * floor) * r / (0.4 * m * r * r)
    until = spin / rate * draw.choice([draw.uniform(0.2, 0.9), draw.uniform(1.1, 2)])
    end = max(spin - rate * until, 0.0)
    # Clockwise at the bottom point means moving left there for a counter-clockwise spin? v = w x r: (w r, 0) at the bottom.
    scene = Scene(
        (Body(m, (r, r), (0.0, 0.0), r, spin=spin),),
        (Weight(G), HardWall((1.0, 0.0), 0.0, 0.0, mu), HardWall((0.0, 1.0), 0.0, 0.0, mu)),
        until=until,
    )
    return Case("spun in a corner", scene, {V: (0, 0), X: (r, r), S: (end,)}, (until,))


def drawn_back(draw: Random) -> Case:
    """A ball with backspin slides out, stops and rolls back."""
    m, r, mu, v = draw.uniform(0.1, 1), draw.uniform(0.05, 0.3), draw.uniform(0.1, 0.4), draw.uniform(0.5, 2)
    spin = v / r * draw.uniform(2.6, 6)  # counter-clockwise: its lowest point moves forward still faster
    slip, a = v + spin * r, mu * G
    ends = slip / (3.5 * a)
    until = ends * draw.uniform(0.3, 2)
    t = min(until, ends)
    speed, turn = v - a * t, spin - 2.5 * a / r * t
    x = v * t - a * t * t / 2 + speed * (until - t)
    scene = Scene(
        (Body(m, (0.0, r), (v, 0.0), r, spin=spin),),
        (Weight(G), HardWall((0.0, 1.0), 0.0, 0.0, mu)),
        until=until,
    )
    return Case("drawn back", scene, {V: (speed, 0), X: (x, r), S: (turn,)}, (until,))


def dropped_dumbbell(draw: Random) -> Case:
    """Two masses on a rod fall slantwise; the lower one hits the floor and sets the rod turning."""
    m, d, angle = (draw.uniform(0.2, 1), draw.uniform(0.2, 1)), 0.6, draw.uniform(0.2, 1.2)
    h, e, u = draw.uniform(0.2, 1), draw.uniform(0.3, 1), draw.uniform(-1, 1)
    total = sum(m)
    reduced, t = m[0] * m[1] / total, math.sqrt(2 * h / G)
    arm = (-d * m[1] / total, d * m[0] / total)
    inertia, c, s = reduced * d * d, math.cos(angle), math.sin(angle)
    fall = G * t
    blow = (1 + e) * fall / (1 / total + (arm[0] * c) ** 2 / inertia)
    w, omega = -fall + blow / total, blow * arm[0] * c / inertia

    # Until a second touch, of either end.
    def low(i: int, left: float) -> float:
        return -arm[0] * s + w * left - G * left**2 / 2 + arm[i] * math.sin(angle + omega * left)

    left, step = 0.0, 1e-4
    while left < 0.4 and all(low(i, left + step) > 0 for i in range(2)):
        left += step
    left *= draw.uniform(0.3, 0.95)
    until = t + left
    at, places, ends = angle + omega * left, [], []
    for i in range(2):
        places += [u * until + arm[i] * math.cos(at), low(i, left)]
        ends += [u - omega * arm[i] * math.sin(at), w - G * left + omega * arm[i] * math.cos(at)]
    scene = Scene(
        tuple(Body(m[i], (arm[i] * c, h + (arm[i] - arm[0]) * s), (u, 0.0)) for i in range(2)),
        (Weight(G), Rod((0, 1)), HardWall((0.0, 1.0), 0.0, e)),
        until=until,
    )
    return Case("dropped dumbbell", scene, {V: tuple(ends), X: tuple(places)}, (until,))


def hopper(draw: Random) -> Case:
    """Two masses on an upright spring fall; the lower one stays on the floor until the spring lifts it again."""
    m, k, h = (draw.uniform(0.2, 1), draw.uniform(0.2, 1)), draw.uniform(100, 600), draw.uniform(0.1, 0.8)
    t, until = math.sqrt(2 * h / G), math.sqrt(2 * h / G) + draw.uniform(0.02, 0.6)

    def f(t: Any, y: Any, flags: Any) -> Any:
        push = k * (0.8 - (y[1] - y[0]))
        return y[2], y[3], (-push / m[0] - G if flags == "flies" else 0), push / m[1] - G

    def presses(y: Any) -> Any:
        return m[0] * G + k * (0.8 - (y[1] - y[0]))

    def lands(t: Any, y: Any, flags: Any) -> Any:
        y = y.copy()
        y[0] = y[2] = 0
        return y, "stands" if presses(y) > 0 else "flies"  # the spring may lift it at once

    events = [
        (lambda t, y, flags: y[0] if flags == "flies" else 1, lands),
        (lambda t, y, flags: presses(y) if flags == "stands" else 1, lambda t, y, flags: (y, "flies")),
    ]
    y = follow(f, (0, 0.8, 0, -np.sqrt(np.longdouble(2) * G * h)), until - t, events, "stands")
    scene = Scene(
        (Body(m[0], (0.0, h), (0.0, 0.0)), Body(m[1], (0.0, h + 0.8), (0.0, 0.0))),
        (Weight(G), Spring((0, 1), k, 0.8), HardWall((0.0, 1.0), 0.0, 0.0)),
        until=until,
    )
    return Case("hopper", scene, {V: floats(0, y[2], 0, y[3]), X: floats(0, y[0], 0, y[1])}, (until,))


def thrown_in_syrup(draw: Random) -> Case:
    """A point with linear drag bounces off a rough floor twice or so."""
    m, c, mu, e = (
        draw.uniform(0.2, 1),
        draw.uniform(0.05, 0.3),
        draw.uniform(0.05, 0.5),
        draw.uniform(0.75, 1),
    )
    u, w, until = draw.uniform(1, 4), draw.uniform(0.5, 3), draw.uniform(0.6, 1.2)

    def f(t: Any, y: Any, flags: Any) -> Any:
        return y[2], y[3], -c / m * y[2], -c / m * y[3] - G

    def hits(t: Any, y: Any, flags: Any) -> Any:
        blow = -(1 + e) * y[3]
        grip = min(mu * blow, abs(y[2]))
        y = np.array([y[0], 0 * y[1], y[2] - np.sign(y[2]) * grip, -e * y[3]])
        return y, flags

    y = follow(f, (0, 0.5, u, w), until, [(lambda t, y, flags: y[1] if y[3] < 0 else np.longdouble(1), hits)])
    scene = Scene(
        (Body(m, (0.0, 0.5), (u, w)),), (Weight(G), Drag(0, c), HardWall((0.0, 1.0), 0.0, e, mu)), until=until
    )
    return Case("thrown in syrup", scene, {V: floats(*y[2:]), X: floats(*y[:2])}, (until,))


def thrown_in_air(draw: Random) -> Case:
    """A point with quadratic drag in a wind bounces off a smooth floor."""
    m, c, e, wind = draw.uniform(0.2, 1), draw.uniform(0.01, 0.2), draw.uniform(0.7, 1), draw.uniform(-3, 3)
    u, w, until = draw.uniform(3, 6), draw.uniform(0.5, 3), draw.uniform(0.5, 1.2)

    def f(t: Any, y: Any, flags: Any) -> Any:
        across = y[2] - wind
        speed = np.sqrt(across**2 + y[3] ** 2)
        return y[2], y[3], -c / m * speed * across, -c / m * speed * y[3] - G

    def hits(t: Any, y: Any, flags: Any) -> Any:
        return np.array([y[0], 0 * y[1], y[2], -e * y[3]]), flags

    y = follow(
        f, (0, 0.5, u, w), until, [(lambda t, y, flags: y[1] if y[3] < 0 else np.longdouble(1), hits)], h=0.01
    )
    scene = Scene(
        (Body(m, (0.0, 0.5), (u, w)),),
        (Weight(G), Drag(0, quadratic=c, wind=(wind, 0.0)), HardWall((0.0, 1.0), 0.0, e)),
        until=until,
    )
    return Case("thrown in air", scene, {V: floats(*y[2:]), X: floats(*y[:2])}, (until,))


def struck(
    v: float, rim: float, into: float, e: float, mu: float, share: float = 0.4
) -> tuple[float, float, float]:
    """Velocity along a surface, speed of turning (as that of the rim there) and normal velocity after a hit; v + rim slips."""
    blow, slip = (1 + e) * into, v + rim
    grip = min(mu * blow, abs(slip) / (1 + 1 / share)) * math.copysign(1.0, slip)
    return v - grip, rim - grip / share, e * into


def floor_then_wall(draw: Random) -> Case:
    """A spinning ball bounces off a rough floor and then off a rough wall."""
    r, m, e, mu = 0.1, draw.uniform(0.1, 1), draw.uniform(0.5, 0.9), draw.uniform(0.05, 0.6)
    h, u, spin = draw.uniform(0.5, 1), draw.uniform(1, 3), draw.uniform(-40, 40)
    t = math.sqrt(2 * h / G)
    x1 = u * t
    # On the floor a counter-clockwise spin moves the lowest point by +spin r.
    v, rim, up = struck(u, spin * r, G * t, e, mu)
    spin1 = rim / r
    if v <= 0.2:
        return floor_then_wall(draw)
    flight = min(2 * up / G * draw.uniform(0.2, 0.8), 1.0)
    wall = x1 + v * flight
    # On the wall on the right the outermost point moves up by spin r.
    w, rim, back = struck(up - G * flight, spin1 * r, v, e, mu)
    y, left = up * flight - G * flight**2 / 2, 0.05
    left = min(left, 0.5 * y / max(abs(w), 1))
    until = t + flight + left
    y += w * left - G * left**2 / 2
    scene = Scene(
        (Body(m, (0.0, h + r), (u, 0.0), r, spin=spin),),
        (Weight(G), HardWall((0.0, 1.0), 0.0, e, mu), HardWall((-1.0, 0.0), -wall - r, e, mu)),
        until=until,
    )
    return Case(
        "floor, then wall",
        scene,
        {V: (-back, w - G * left), X: (wall - back * left, y + r), S: (rim / r,)},
        (until,),
    )


def carried_by_a_plate(draw: Random) -> Case:
    """A plate that is pushed less and less carries a block by friction, until that is too little."""
    m, mu, a, rate = draw.uniform(0.2, 2), draw.uniform(0.3, 0.8), draw.uniform(40, 80), draw.uniform(1, 4)
    static = mu * draw.uniform(1, 1.3)
    slips = math.log(static * a / G) / rate
    until = slips + draw.uniform(-0.8 * slips, 0.5)

    def moves(t: float) -> tuple[float, float, float]:
        return (
            a * (t + math.expm1(-rate * t) / rate) / rate,
            -a * math.expm1(-rate * t) / rate,
            a * math.exp(-rate * t),
        )

    at, speed, _ = moves(until)
    t = max(until - slips, 0.0)
    held = G / static
    v = -G * t - mu * held * math.expm1(-rate * t) / rate
    y = -G * t * t / 2 + mu * held * (t + math.expm1(-rate * t) / rate) / rate
    scene = Scene(
        (Body(m, (0.0, 0.0), (0.0, 0.0)),),
        (Weight(G), HardWall((1.0, 0.0), 0.0, 0.0, mu, static, moves=moves)),
        until=until,
    )
    return Case("carried by a plate", scene, {V: (speed, v), X: (at, y)}, (until,))


def springs_to_the_floor(draw: Random) -> Case:
    """A weight on a spring that hangs is let go near the floor and hits it time and again."""
    m, k, e = draw.uniform(0.3, 1), draw.uniform(20, 100), draw.uniform(0.5, 1)
    w = math.sqrt(k / m)
    rest = m * G / k  # below the unstretched end
    floor, until = -rest * draw.uniform(1.05, 1.6), draw.uniform(0.5, 4)
    with mp.workdps(30):
        t, x, v = mp.mpf(0), mp.mpf(rest), mp.mpf(0)  # seen from the place of rest
        low = mp.mpf(floor) + rest
        while hit := met(
            lambda s, t=t, x=x, v=v: x * mp.cos(w * (s - t)) + v / w * mp.sin(w * (s - t)) - low,
            t,
            until,
            2000,
        ):
            s = w * (hit - t)
            t, x, v = hit, low, -e * (v * mp.cos(s) - w * x * mp.sin(s))
        s = w * (until - t)
        x, v = x * mp.cos(s) + v / w * mp.sin(s), v * mp.cos(s) - w * x * mp.sin(s)
    scene = Scene(
        (Body(math.inf, (0.0, 2.0), (0.0, 0.0)), Body(m, (0.0, 0.0), (0.0, 0.0))),
        (Weight(G), Spring((0, 1), k, 2.0), HardWall((0.0, 1.0), floor, e, only=(1,))),
        until=until,
    )
    return Case(
        "springs to the floor", scene, {V: floats(0, 0, 0, v), X: floats(0, 2, 0, x - rest)}, (until,)
    )


FAMILIES = (
    juggled,
    fermi_ulam,
    lift,
    dropped_together,
    dropped_into_a_wedge,
    right_wedge,
    into_the_corner,
    down_a_rough_incline,
    up_an_incline,
    incline_and_floor,
    pressed_to_a_wall,
    spun_in_a_corner,
    drawn_back,
    dropped_dumbbell,
    hopper,
    thrown_in_syrup,
    thrown_in_air,
    floor_then_wall,
    carried_by_a_plate,
    springs_to_the_floor,
)
