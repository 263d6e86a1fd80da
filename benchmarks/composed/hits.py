"""Families of contacts among other forces: breaks, bumpers, stacks, oscillators that collide; references by `follow`."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import numpy as np

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.drag import Drag
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.rod import Rod
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .case import Case
from .reference import Act, L, Watched, follow
from .rough import floats

V, X, S = Observable.VELOCITIES, Observable.TRAJECTORY, Observable.SPINS
G = 9.8


def touching(overlaps: Sequence[Callable[[Any], Any]]) -> list[tuple[Watched, Act]]:
    """Events for flags that say which of some overlaps are above zero; an overlap is a function of the state."""

    def toggled(i: int) -> Act:
        return lambda t, y, flags: (y, (*flags[:i], not flags[i], *flags[i + 1 :]))

    events: list[tuple[Watched, Act]] = []
    for i, deep in enumerate(overlaps):
        events.append((lambda t, y, flags, i=i, deep=deep: L(1) if flags[i] else -deep(y), toggled(i)))
        events.append((lambda t, y, flags, i=i, deep=deep: deep(y) if flags[i] else L(1), toggled(i)))
    return events


def wagons(draw: Random) -> Case:
    """Three wagons with damped linear buffers run into each other."""
    m, v, k, eta = (
        [draw.uniform(0.5, 2) for _ in range(3)],
        draw.uniform(1, 3),
        draw.uniform(500, 5000),
        draw.uniform(0, 15),
    )
    until, r = draw.uniform(0.5, 1.5), 0.125

    def deep(i: int) -> Callable[[Any], Any]:
        return lambda y: 2 * r - (y[i + 1] - y[i])

    def f(t: Any, y: Any, flags: Any) -> Any:
        rates = [L(0)] * 3
        for i in range(2):
            if flags[i]:
                push = k * deep(i)(y) + eta * (y[3 + i] - y[4 + i])
                rates[i] -= push / m[i]
                rates[i + 1] += push / m[i + 1]
        return [*y[3:], *rates]

    places = (0.0, 0.5, 1.0)
    y = follow(f, (*places, v, 0, 0), until, touching([deep(0), deep(1)]), (False, False), h=0.002)
    bodies = tuple(Body(m[i], (places[i],), (v if i == 0 else 0.0,), r) for i in range(3))
    scene = Scene(bodies, (Contact(k, 1.0, eta),), until=until)
    return Case("wagons", scene, {V: floats(*y[3:]), X: floats(*y[:3])}, (until,))


def swings_that_collide(draw: Random) -> Case:
    """Two bodies on springs of their own hit each other, time and again."""
    m, k = (draw.uniform(0.3, 1), draw.uniform(0.3, 1)), (draw.uniform(20, 80), draw.uniform(20, 80))
    hard, a, until, r = draw.uniform(500, 5000), draw.uniform(0.1, 0.4), draw.uniform(0.5, 3), 0.0625

    def deep(y: Any) -> Any:
        return 2 * r - (y[1] - y[0])

    def f(t: Any, y: Any, flags: Any) -> Any:
        push = hard * deep(y) if flags[0] else L(0)
        return y[2], y[3], (-k[0] * y[0] - push) / m[0], (-k[1] * (y[1] - 0.25) + push) / m[1]

    y = follow(f, (-a, 0.25, 0, 0), until, touching([deep]), (False,), h=0.005)
    nails = Body(math.inf, (-1.0,), (0.0,)), Body(math.inf, (1.25,), (0.0,))
    scene = Scene(
        (*nails, Body(m[0], (-a,), (0.0,), r), Body(m[1], (0.25,), (0.0,), r)),
        (Spring((0, 2), k[0], 1.0), Spring((3, 1), k[1], 1.0), Contact(hard, 1.0)),
        until=until,
    )
    return Case(
        "swings that collide", scene, {V: floats(0, 0, *y[2:]), X: floats(-1, 1.25, *y[:2])}, (until,)
    )


def planar(
    y: Any, n: int, links: Sequence[tuple[int, int, float]], flags: Any, k: float, q: int, m: Sequence[float]
) -> Any:
    """Accelerations of discs that push with k overlap^q where the flags say that they touch."""
    rates = np.zeros((n, 2), L)
    for (i, j, reach), on in zip(links, flags, strict=True):
        if on:
            d = y[2 * j : 2 * j + 2] - y[2 * i : 2 * i + 2]
            r = np.sqrt(d @ d)
            push = k * (reach - r) ** q * d / r
            rates[i] -= push / m[i]
            rates[j] += push / m[j]
    return rates


def overlap(i: int, j: int, reach: float) -> Callable[[Any], Any]:
    def deep(y: Any) -> Any:
        d = y[2 * j : 2 * j + 2] - y[2 * i : 2 * i + 2]
        return reach - np.sqrt(d @ d)

    return deep


def break_shot(draw: Random) -> Case:
    """A ball is shot between two that lie side by side, not quite in the middle."""
    r, k, v, m = (
        0.0625,
        draw.uniform(1e5, 1e6),
        draw.uniform(0.5, 2),
        (draw.uniform(0.2, 1), 0.3, draw.uniform(0.2, 1)),
    )
    off, until = draw.uniform(-0.02, 0.02), 0.6
    links = [(0, 1, 2 * r), (0, 2, 2 * r), (1, 2, 2 * r)]
    places = (-0.3, off, 0.0, r + 0.001, 0.0, -r - 0.001)

    def f(t: Any, y: Any, flags: Any) -> Any:
        return [*y[6:], *planar(y, 3, links, flags, k, 2, m).ravel()]

    # Long steps to the touch, short ones through it.
    free = (0.3 - 2 * r) / v
    y = numbers_free(places, (v, 0, 0, 0, 0, 0), free)
    y = follow(f, y, 0.15, touching([overlap(*each) for each in links]), (False,) * 3, h=0.001)
    y[:6] += y[6:] * (L(until) - free - L(0.15))
    bodies = tuple(Body(m[i], places[2 * i : 2 * i + 2], (v if i == 0 else 0.0, 0.0), r) for i in range(3))
    scene = Scene(bodies, (Contact(k, 2.0),), until=until)
    return Case("break shot", scene, {V: floats(*y[6:]), X: floats(*y[:6])}, (until,))


def numbers_free(places: Sequence[float], speeds: Sequence[float], t: float) -> Any:
    x, v = np.array(places, L), np.array(speeds, L)
    return np.concatenate([x + v * t, v])


def ball_on_ball(draw: Random) -> Case:
    """Two balls, one above the other, fall on a hard floor."""
    m, k, e = (draw.uniform(0.2, 1), draw.uniform(0.05, 0.3)), draw.uniform(3e4, 3e5), draw.uniform(0.7, 1)
    h, gap, r, until = draw.uniform(0.2, 0.6), draw.uniform(0.01, 0.05), 0.0625, draw.uniform(0.4, 0.7)

    def deep(y: Any) -> Any:
        return 2 * r - (y[1] - y[0])

    def f(t: Any, y: Any, flags: Any) -> Any:
        push = k * deep(y) ** 2 if flags[0] else L(0)
        return y[2], y[3], -push / m[0] - G, push / m[1] - G

    def bounce(t: Any, y: Any, flags: Any) -> Any:
        return np.array([y[0], y[1], -e * y[2], y[3]]), flags

    events = [*touching([deep]), (lambda t, y, g: y[0] - r if y[2] < 0 else L(1), bounce)]
    y = follow(f, (h, h + 2 * r + gap, 0, 0), until, events, (False,), h=0.001)
    scene = Scene(
        (Body(m[0], (0.0, h), (0.0, 0.0), r), Body(m[1], (0.0, h + 2 * r + gap), (0.0, 0.0), r)),
        (Weight(G), Contact(k, 2.0), HardWall((0.0, 1.0), 0.0, e)),
        until=until,
    )
    return Case("ball on ball", scene, {V: floats(0, y[2], 0, y[3]), X: floats(0, y[0], 0, y[1])}, (until,))


def resting_stack(draw: Random) -> Case:
    """Three balls lie on each other on a floor, pressed as deep as they weigh; one beside them falls."""
    m, k, until, q = (
        [draw.uniform(0.2, 2) for _ in range(3)],
        draw.uniform(1e3, 1e5),
        draw.uniform(0.1, 1),
        draw.choice([1.0, 2.0]),
    )
    r, y, places = 0.25, 0.25, []
    for i in range(3):
        if i:
            y += 2 * r - (sum(m[i:]) * G / k) ** (1 / q)
        places.append(y)
    scene = Scene(
        (
            *(Body(m[i], (0.0, places[i]), (0.0, 0.0), r) for i in range(3)),
            Body(1.0, (3.0, 9.0), (0.0, 0.0), r),
        ),
        (Weight(G), Contact(k, q), HardWall((0.0, 1.0), 0.0, 0.0)),
        until=until,
    )
    truth = {
        V: (0, 0, 0, 0, 0, 0, 0, -G * until),
        X: (0, places[0], 0, places[1], 0, places[2], 3, 9 - G * until**2 / 2),
    }
    return Case("resting stack", scene, truth, (until,))


def settling(draw: Random) -> Case:
    """A ball falls on a springy, damped post and comes to rest there."""
    m, k, eta, h = (
        draw.uniform(0.3, 1),
        draw.uniform(200, 3000),
        draw.uniform(0.5, 15),
        draw.uniform(0.05, 0.4),
    )
    until, reach = draw.uniform(0.5, 2), 0.5

    def deep(y: Any) -> Any:
        return reach - y[0]

    def f(t: Any, y: Any, flags: Any) -> Any:
        return y[1], ((k * deep(y) - eta * y[1]) / m if flags[0] else 0) - G

    y = follow(f, (reach + h, 0), until, touching([deep]), (False,), h=0.002)
    scene = Scene(
        (Body(math.inf, (0.0, 0.0), (0.0, 0.0), 0.25), Body(m, (0.0, reach + h), (0.0, 0.0), 0.25)),
        (Weight(G), Contact(k, 1.0, eta)),
        until=until,
    )
    return Case("settling", scene, {V: floats(0, 0, 0, y[1]), X: floats(0, 0, 0, y[0])}, (until,))


def spinning_disc_hits(draw: Random) -> Case:
    """A spinning disc hits one at rest, off centre; they rub, slipping throughout."""
    m, r, k, mu, v = (
        (draw.uniform(0.2, 1), draw.uniform(0.2, 1)),
        0.125,
        draw.uniform(1e4, 1e5),
        draw.uniform(0.02, 0.1),
        draw.uniform(1, 2),
    )
    spin, b, until = draw.choice([-1, 1]) * draw.uniform(60, 120), draw.uniform(-0.1, 0.1), 0.5
    inertia = [0.4 * each * r * r for each in m]

    def f(t: Any, y: Any, flags: Any) -> Any:
        if not flags[0]:
            return [*y[4:8], *(L(0),) * 4, L(0), L(0)]
        d = y[2:4] - y[:2]
        dist = np.sqrt(d @ d)
        n = d / dist
        along = np.array([-n[1], n[0]])
        push = k * (2 * r - dist) ** 2
        # The surface of the first at the contact moves with + spin r along, that of the second with - spin r; r to the middle of the lens.
        arm = dist / 2
        slip = (y[4:6] - y[6:8]) @ along + (y[8] + y[9]) * arm
        rub = -mu * push * np.sign(slip)
        force = -push * n + rub * along
        return [*y[4:8], *(force / m[0]), *(-force / m[1]), arm * rub / inertia[0], arm * rub / inertia[1]]

    free = (0.5 - 2 * r) / v
    y = np.array([-0.5 + v * L(free), b, 0, 0, v, 0, 0, 0, spin, 0], L)
    y = follow(f, y, 0.2, touching([overlap(0, 1, 2 * r)]), (False,), h=0.001)
    y[:4] += y[4:8] * (L(until) - free - L(0.2))
    scene = Scene(
        (Body(m[0], (-0.5, b), (v, 0.0), r, spin=spin), Body(m[1], (0.0, 0.0), (0.0, 0.0), r)),
        (Contact(k, 2.0, mu=mu),),
        until=until,
    )
    return Case(
        "spinning disc hits", scene, {V: floats(*y[4:8]), X: floats(*y[:4]), S: floats(*y[8:])}, (until,)
    )


def dumbbell_struck(draw: Random) -> Case:
    """A ball hits one end of a dumbbell in space."""
    m, k, v, r = (
        [draw.uniform(0.2, 1) for _ in range(3)],
        draw.uniform(1e4, 1e5),
        draw.uniform(0.5, 2),
        0.0625,
    )
    b, d, until = draw.uniform(-0.08, 0.08), 0.5, 0.7
    # Body 0 is the ball, 1 and 2 the dumbbell, which lies across: centre, angle.
    total = m[1] + m[2]
    arms = (-d * m[2] / total, d * m[1] / total)
    inertia = m[1] * m[2] / total * d * d

    def ends(y: Any) -> tuple[Any, Any]:
        u = np.array([-np.sin(y[4]), np.cos(y[4])])
        return y[2:4] + arms[0] * u, y[2:4] + arms[1] * u

    def deep(i: int) -> Callable[[Any], Any]:
        def at(y: Any) -> Any:
            d = ends(y)[i] - y[:2]
            return 2 * r - np.sqrt(d @ d)

        return at

    def f(t: Any, y: Any, flags: Any) -> Any:
        ball, centre, turn = np.zeros(2, L), np.zeros(2, L), L(0)
        for i in range(2):
            if flags[i]:
                apart = ends(y)[i] - y[:2]
                dist = np.sqrt(apart @ apart)
                push = k * (2 * r - dist) ** 2 * apart / dist
                u = arms[i] * np.array([-np.sin(y[4]), np.cos(y[4])])
                ball, centre, turn = ball - push, centre + push, turn + u[0] * push[1] - u[1] * push[0]
        return [*y[5:], *(ball / m[0]), *(centre / total), turn / inertia]

    free = (0.4 - 2 * r) / v
    y = np.array([-0.4 + v * L(free), b, 0, -arms[0], 0, v, 0, 0, 0, 0], L)
    y = follow(f, y, until - free, touching([deep(0), deep(1)]), (False, False), h=0.001)
    u, w = np.array([-np.sin(y[4]), np.cos(y[4])]), np.array([-np.cos(y[4]), -np.sin(y[4])])
    one, two = ends(y)
    scene = Scene(
        (
            Body(m[0], (-0.4, b), (v, 0.0), r),
            Body(m[1], (0.0, 0.0), (0.0, 0.0), r),
            Body(m[2], (0.0, d), (0.0, 0.0), r),
        ),
        (Contact(k, 2.0, chosen=((0, 1), (0, 2))), Rod((1, 2))),
        until=until,
        passes=((1, 2),),
    )
    del u
    speeds = [y[7:9] + arm * w * y[9] for arm in arms]
    return Case(
        "dumbbell struck",
        scene,
        {V: floats(*y[5:7], *speeds[0], *speeds[1]), X: floats(*y[:2], *one, *two)},
        (until,),
    )


def pucks_collide(draw: Random) -> Case:
    """Two pucks that slide on a rough table collide, and come to rest one after the other."""
    m, mu, k, r = (
        (draw.uniform(0.2, 1), draw.uniform(0.2, 1)),
        (draw.uniform(0.05, 0.3), draw.uniform(0.05, 0.3)),
        draw.uniform(1e4, 1e5),
        0.125,
    )
    v, b, until = draw.uniform(1.5, 3), draw.uniform(-0.2, 0.2), draw.uniform(0.4, 3)
    links = [(0, 1, 2 * r)]

    def f(t: Any, y: Any, flags: Any) -> Any:
        rates = planar(y, 2, links, flags[:1], k, 2, m)
        for i in range(2):
            if flags[1 + i]:
                u = y[4 + 2 * i : 6 + 2 * i]
                speed = np.sqrt(u @ u)
                if speed:
                    rates[i] -= mu[i] * G * u / speed
            else:
                rates[i] *= 0
        return [*y[4:], *rates.ravel()]

    # Until they touch the second one lies, and while they do it is pushed by far more than friction.
    deep = overlap(*links[0])
    close = math.sqrt(4 * r * r - b * b)
    way = 0.6 - close
    speed = math.sqrt(v * v - 2 * mu[0] * G * way)
    t0 = (v - speed) / (mu[0] * G)
    # The second one starts when the push reaches its static friction: static m g = k deep^2.
    static = mu[1] * draw.uniform(1.2, 2)
    starts = math.sqrt(static * m[1] * G / k)

    met: list[Any] = []

    def meets(t: Any, y: Any, flags: Any) -> Any:
        met.append((t, y))
        return y, (False, False, False)

    moves = (lambda t, y, g: starts - deep(y) if g[0] else L(1), meets)
    opens = (lambda t, y, g: deep(y) if g[2] else L(1), meets)
    follow(f, (-close, b, 0, 0, speed, 0, 0, 0), 4 * starts / speed, [moves], (True, True, False), h=0.00005)
    t, y = met.pop()
    y[6:8] = 1e-25 * (y[2:4] - y[:2])
    # As long as it is slow, friction turns it fast: short steps to begin with.
    h = 1e-9
    while not met:
        begun, t, y = t, t + 16 * h, follow(f, y, 16 * h, [opens], (True, True, True), h)
        h = min(2 * h, 0.00005)
    t, y = begun + met[0][0], met[0][1]
    left, ends, places = L(until) - t0 - t, [], []
    if left < 0:
        return pucks_collide(draw)
    for i in range(2):
        u, x = y[4 + 2 * i : 6 + 2 * i], y[2 * i : 2 * i + 2]
        fast = np.sqrt(u @ u)
        s = min(left, fast / (mu[i] * G))
        places += [*(x + u / fast * (fast * s - mu[i] * G * s * s / 2))]
        ends += [*(u * (1 - mu[i] * G * s / fast if s == left else 0))]
    scene = Scene(
        (Body(m[0], (-0.6, b), (v, 0.0), r), Body(m[1], (0.0, 0.0), (0.0, 0.0), r)),
        (Contact(k, 2.0), Friction(0, mu[0]), Friction(1, mu[1], G, static)),
        until=until,
    )
    return Case("pucks collide", scene, {V: floats(*ends), X: floats(*places)}, (until,))


def between_bumpers(draw: Random) -> Case:
    """A ball in a fluid flies to and fro between two springy bumpers."""
    m, c, k, v, until = (
        draw.uniform(0.2, 1),
        draw.uniform(0.02, 0.3),
        draw.uniform(200, 3000),
        draw.uniform(1, 4),
        draw.uniform(1, 4),
    )

    def f(t: Any, y: Any, flags: Any) -> Any:
        push = (-k * (y[0] - 0.5) ** 2 if flags[0] else 0) + (k * (-0.5 - y[0]) ** 2 if flags[1] else 0)
        return y[1], (push - c * y[1]) / m

    y = follow(
        f,
        (0, v),
        until,
        touching([lambda y: y[0] - L(0.5), lambda y: -y[0] - L(0.5)]),
        (False, False),
        h=0.004,
    )
    scene = Scene(
        (
            Body(math.inf, (-1.0,), (0.0,), 0.25),
            Body(m, (0.0,), (v,), 0.25),
            Body(math.inf, (1.0,), (0.0,), 0.25),
        ),
        (Contact(k, 2.0), Drag(1, c)),
        until=until,
    )
    return Case("between bumpers", scene, {V: floats(0, y[1], 0), X: floats(-1, y[0], 1)}, (until,))


def pendulum_hits_block(draw: Random) -> Case:
    """A pendulum hits a ball that stands on the floor; that slides away, the pendulum swings on."""
    m, k, length, start = (
        (draw.uniform(0.2, 1), draw.uniform(0.2, 1)),
        draw.uniform(1e4, 1e5),
        0.5,
        draw.uniform(0.4, 1.3),
    )
    r, until = 0.0625, draw.uniform(0.5, 1.0)

    # The bob hangs so that at its lowest it touches the ball, at the same height.
    def deep(y: Any) -> Any:
        bx, by = length * np.sin(y[0]), length * (1 - np.cos(y[0]))
        return 2 * r - np.sqrt((y[1] - bx) ** 2 + by * by)

    def f(t: Any, y: Any, flags: Any) -> Any:
        turn, slide = -G / length * np.sin(y[0]), L(0)
        if flags[0]:
            s, c = np.sin(y[0]), np.cos(y[0])
            dx, dy = y[1] - length * s, -length * (1 - c)
            dist = np.sqrt(dx * dx + dy * dy)
            push = k * (2 * r - dist) ** 2
            # On the bob: -push along (dx, dy); across the rod (c, s).
            turn = turn - push * (dx * c + dy * s) / dist / (m[0] * length)
            slide = push * dx / dist / m[1]
        return y[2], y[3], turn, slide

    y = follow(f, (-start, 2 * r + 0.01, 0, 0), until, touching([deep]), (False,), h=0.001)
    s, c = np.sin(y[0]), np.cos(y[0])
    scene = Scene(
        (
            Body(math.inf, (0.0, length + r), (0.0, 0.0)),
            Body(m[0], (-length * math.sin(start), length + r - length * math.cos(start)), (0.0, 0.0), r),
            Body(m[1], (2 * r + 0.01, r), (0.0, 0.0), r),
        ),
        (
            Rod((0, 1), length),
            Weight(G),
            Contact(k, 2.0, chosen=((1, 2),)),
            HardWall((0.0, 1.0), 0.0, 0.0, only=(2,)),
        ),
        until=until,
    )
    truth = {
        V: floats(0, 0, length * c * y[2], length * s * y[2], y[3], 0),
        X: floats(0, length + r, length * s, length + r - length * c, y[1], r),
    }
    return Case("pendulum hits a ball", scene, truth, (until,))


def galton_peg(draw: Random) -> Case:
    """A disc falls on a springy peg, off centre, and then on the hard floor."""
    m, k, r, h, e = (
        draw.uniform(0.1, 0.5),
        draw.uniform(1e4, 1e5),
        0.125,
        draw.uniform(0.1, 0.5),
        draw.uniform(0.6, 1),
    )
    b, until = draw.choice([-1, 1]) * draw.uniform(0.02, 0.2), draw.uniform(0.4, 0.9)

    def deep(y: Any) -> Any:
        return 2 * r - np.sqrt(y[0] ** 2 + (y[1] - 1) ** 2)

    def f(t: Any, y: Any, flags: Any) -> Any:
        ax, ay = L(0), L(-G)
        if flags[0]:
            x, h = y[0], y[1] - 1
            dist = np.sqrt(x * x + h * h)
            push = k * (2 * r - dist) ** 2 / m
            ax, ay = push * x / dist, ay + push * h / dist
        return y[2], y[3], ax, ay

    def bounce(t: Any, y: Any, flags: Any) -> Any:
        return np.array([y[0], y[1], y[2], -e * y[3]]), flags

    events = [*touching([deep]), (lambda t, y, g: y[1] - r if y[3] < 0 else L(1), bounce)]
    y = follow(f, (b, 1 + 2 * r + h, 0, 0), until, events, (False,), h=0.001)
    scene = Scene(
        (Body(math.inf, (0.0, 1.0), (0.0, 0.0), r), Body(m, (b, 1 + 2 * r + h), (0.0, 0.0), r)),
        (Weight(G), Contact(k, 2.0), HardWall((0.0, 1.0), 0.0, e, only=(1,))),
        until=until,
    )
    return Case("Galton's peg", scene, {V: floats(0, 0, *y[2:]), X: floats(0, 1, *y[:2])}, (until,))


FAMILIES = (
    wagons,
    swings_that_collide,
    break_shot,
    ball_on_ball,
    resting_stack,
    settling,
    spinning_disc_hits,
    dumbbell_struck,
    pucks_collide,
    between_bumpers,
    pendulum_hits_block,
    galton_peg,
)
