"""Families with rods and strings: pendula on carts and at walls, a ladder, a train that jerks taut; references in angles."""

from __future__ import annotations

import math
from random import Random
from typing import Any

import numpy as np

from corollary.scenes.forces.drag import Drag
from corollary.scenes.forces.rod import Rod, String
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .case import Case
from .reference import L, follow
from .rough import floats

V, X = Observable.VELOCITIES, Observable.TRAJECTORY
G = 9.8


def nail(*place: float, velocity: tuple[float, float] = (0.0, 0.0)) -> Body:
    return Body(math.inf, place, velocity)


def bob_state(theta: Any, rate: Any, length: float) -> tuple[list[Any], list[Any]]:
    s, c = np.sin(theta), np.cos(theta)
    return [length * s, -length * c], [length * c * rate, length * s * rate]


def pendulum_at_a_wall(draw: Random) -> Case:
    """A pendulum swings against a wall, again and again."""
    length, start, e = draw.uniform(0.3, 1), draw.uniform(0.5, 2), draw.uniform(0.5, 1)
    at, until = draw.uniform(0, 0.4) * length, draw.uniform(0.5, 3)

    def bounce(t: Any, y: Any, flags: Any) -> Any:
        return np.array([y[0], -e * y[1]]), flags

    # The wall is met where the angle is asin(-at / length), moving outwards.
    edge = np.arcsin(L(-at) / length)
    events = [(lambda t, y, flags: y[0] - edge if y[1] < 0 else L(1), bounce)]
    y = follow(lambda t, y, flags: (y[1], -G / length * np.sin(y[0])), (start, 0), until, events)
    place, speed = bob_state(*y, length)
    scene = Scene(
        (nail(0.0, 0.0), Body(0.4, (length * math.sin(start), -length * math.cos(start)), (0.0, 0.0))),
        (Rod((0, 1)), Weight(G), HardWall((1.0, 0.0), -at, e, only=(1,))),
        until=until,
    )
    return Case("pendulum at a wall", scene, {V: floats(0, 0, *speed), X: floats(0, 0, *place)}, (until,))


def pendulum_in_a_fluid(draw: Random) -> Case:
    """A pendulum swings in a fluid with linear drag, let go above the nail."""
    length, start, m, c = (
        draw.uniform(0.3, 1),
        draw.uniform(1.6, 3),
        draw.uniform(0.2, 1),
        draw.uniform(0.05, 1),
    )
    until = draw.uniform(0.5, 4)
    y = follow(lambda t, y, flags: (y[1], -G / length * np.sin(y[0]) - c / m * y[1]), (start, 0), until)
    place, speed = bob_state(*y, length)
    scene = Scene(
        (nail(0.0, 0.0), Body(m, (length * math.sin(start), -length * math.cos(start)), (0.0, 0.0))),
        (Rod((0, 1)), Weight(G), Drag(1, c)),
        until=until,
    )
    return Case("pendulum in a fluid", scene, {V: floats(0, 0, *speed), X: floats(0, 0, *place)}, (until,))


def three_in_a_chain(draw: Random) -> Case:
    """A pendulum of three rods."""
    m, a = [draw.uniform(0.2, 1) for _ in range(3)], [draw.uniform(0.2, 0.6) for _ in range(3)]
    start, until = [draw.uniform(-1.5, 1.5) for _ in range(3)], draw.uniform(0.3, 1.2)
    beyond = [sum(m[i:]) for i in range(3)]

    def f(t: Any, y: Any, flags: Any) -> Any:
        # Rows of the mass matrix: beyond[max(i, j)] a_i a_j cos(t_i - t_j); three equations by Cramer's rule.
        rows, right = [], []
        for i in range(3):
            rows.append([beyond[max(i, j)] * a[j] * np.cos(y[i] - y[j]) for j in range(3)])
            turn = sum(beyond[max(i, j)] * a[j] * np.sin(y[i] - y[j]) * y[3 + j] ** 2 for j in range(3))
            right.append(-turn - beyond[i] * G * np.sin(y[i]))

        def det(p: Any) -> Any:
            return (
                p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1])
                - p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0])
                + p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])
            )

        whole = det(rows)
        rates = [
            det([[right[i] if j == k else rows[i][j] for j in range(3)] for i in range(3)]) / whole
            for k in range(3)
        ]
        return [*y[3:], *rates]

    y = follow(f, (*start, 0, 0, 0), until, h=0.005)  # an inner rod may flick round

    def laid(angles: Any, rates: Any) -> tuple[list[Any], list[Any]]:
        place, speed, x, v = [], [], np.zeros(2, L), np.zeros(2, L)
        for length, theta, rate in zip(a, angles, rates, strict=True):
            one, two = bob_state(theta, rate, length)
            x, v = x + np.array(one), v + np.array(two)
            place += [*x]
            speed += [*v]
        return place, speed

    place, speed = laid(y[:3], y[3:])
    at, _ = laid(np.array(start, L), np.zeros(3, L))
    bodies = [Body(m[i], floats(*at[2 * i : 2 * i + 2]), (0.0, 0.0)) for i in range(3)]
    scene = Scene(
        (nail(0.0, 0.0), *bodies), (*(Rod((i, i + 1), a[i]) for i in range(3)), Weight(G)), until=until
    )
    return Case("three in a chain", scene, {V: floats(0, 0, *speed), X: floats(0, 0, *place)}, (until,))


def springy_pendulum(draw: Random) -> Case:
    """A pendulum on a spring."""
    m, k, length = draw.uniform(0.2, 1), draw.uniform(20, 80), draw.uniform(0.4, 1)
    start, r, until = draw.uniform(0.3, 1.5), length * draw.uniform(0.9, 1.3), draw.uniform(0.5, 3)

    def f(t: Any, y: Any, flags: Any) -> Any:
        r, theta, dr, rate = y
        return (
            dr,
            rate,
            r * rate**2 + G * np.cos(theta) - k / m * (r - length),
            -(G * np.sin(theta) + 2 * dr * rate) / r,
        )

    r1, theta, dr, rate = follow(f, (r, start, 0, 0), until, h=0.01)
    s, c = np.sin(theta), np.cos(theta)
    scene = Scene(
        (nail(0.0, 0.0), Body(m, (r * math.sin(start), -r * math.cos(start)), (0.0, 0.0))),
        (Spring((0, 1), k, length), Weight(G)),
        until=until,
    )
    return Case(
        "springy pendulum",
        scene,
        {
            V: floats(0, 0, dr * s + r1 * c * rate, -dr * c + r1 * s * rate),
            X: floats(0, 0, r1 * s, -r1 * c),
        },
        (until,),
    )


def cart(draw: Random, mu: float, static: float) -> tuple[Scene, Case]:
    heavy, m, length = draw.uniform(0.5, 2), draw.uniform(0.2, 1), draw.uniform(0.3, 0.8)
    start, until = draw.uniform(0.6, 1.4), draw.uniform(0.3, 2)

    def solved(y: Any, slip: int) -> tuple[Any, Any, Any, Any]:
        # Unknown: acceleration of the cart, of the angle, tension, press; friction -slip mu press, or what holds.
        s, c, rate = np.sin(y[1]), np.cos(y[1]), y[3]
        if slip:
            # heavy a = T s - slip mu N; N = heavy G + T c; a c + length w' = -G s; T = m (length rate^2 + G c - a s)
            f = slip * mu
            top = (s - f * c) * m * (length * rate**2 + G * c) - f * heavy * G
            a = top / (heavy + (s - f * c) * m * s)
        else:
            a = L(0)
        pull = m * (length * rate**2 + G * c - a * s)
        return a, -(G * s + a * c) / length, pull, heavy * G + pull * c

    def f(t: Any, y: Any, slip: int) -> Any:
        a, turn, _, _ = solved(y, slip)
        return y[2], y[3], a, turn

    def state(t: Any, y: Any, slip: int) -> Any:
        y = y.copy()
        y[2] = 0
        return y, begins(y)

    def begins(y: Any) -> int:
        _, _, pull, press = solved(y, 0)
        push = pull * np.sin(y[1])
        return 0 if abs(push) <= static * press else int(np.sign(push))

    def spare(t: Any, y: Any, slip: int) -> Any:
        _, _, pull, press = solved(y, 0)
        return static * press - abs(pull * np.sin(y[1])) if not slip else L(1)

    def breaks(t: Any, y: Any, slip: int) -> Any:
        _, _, pull, _ = solved(y, 0)
        return y, int(np.sign(pull * np.sin(y[1])))

    y0 = np.array([0, start, 0, 0], L)
    events = [(lambda t, y, slip: slip * y[2] if slip else L(1), state), (spare, breaks)] if mu else []
    y = follow(f, y0, until, events, begins(y0) if mu else 1, h=0.01)
    place, speed = bob_state(y[1], y[3], length)
    scene = Scene(
        (
            Body(heavy, (0.0, 0.0), (0.0, 0.0)),
            Body(m, (length * math.sin(start), -length * math.cos(start)), (0.0, 0.0)),
        ),
        (Rod((0, 1)), Weight(G), HardWall((0.0, 1.0), 0.0, 0.0, mu, static, only=(0,))),
        until=until,
    )
    truth = {V: floats(y[2], 0, speed[0] + y[2], speed[1]), X: floats(y[0], 0, place[0] + y[0], place[1])}
    return scene, Case("cart with a pendulum", scene, truth, (until,))


def smooth_cart(draw: Random) -> Case:
    """A pendulum hangs from a cart on a smooth rail."""
    return cart(draw, 0.0, 0.0)[1]


def rough_cart(draw: Random) -> Case:
    """The same on a rough rail: the swing of the pendulum decides whether the cart is held."""
    mu = draw.uniform(0.02, 0.25)
    case = cart(draw, mu, mu * draw.uniform(1, 1.5))[1]
    return Case("cart on a rough rail", case.scene, case.truth, case.times)


def ladder(draw: Random) -> Case:
    """A ladder (two masses on a rod) slides down a smooth wall and leaves it."""
    m, length, start = (
        (draw.uniform(0.5, 2), draw.uniform(0.5, 2)),
        draw.uniform(0.5, 2),
        draw.uniform(0.1, 0.5),
    )
    # The angle from the wall; m0 slides on the floor at x = length sin, m1 on the wall at y = length cos.

    def f(t: Any, y: Any, leans: bool) -> Any:
        if leans:
            s, c = np.sin(y[0]), np.cos(y[0])
            inertia = m[0] * c * c + m[1] * s * s
            return (
                y[1],
                (m[1] * G / length * s + (m[0] - m[1]) * s * c * y[1] ** 2) / inertia,
                L(0),
                L(0),
            )
        s, c = np.sin(y[0]), np.cos(y[0])
        # The centre of mass moves steadily: x of the upper end is that of the lower one less length sin.
        reduced = m[0] * m[1] / sum(m)
        inertia = reduced * length * c * c + m[1] * length * s * s
        rate = (m[1] * G * s + (reduced - m[1]) * length * s * c * y[1] ** 2) / inertia
        return y[1], rate, y[3], L(0)

    def presses(t: Any, y: Any, leans: bool) -> Any:
        if not leans:
            return L(1)
        s, c = np.sin(y[0]), np.cos(y[0])
        return c * f(t, y, True)[1] - s * y[1] ** 2  # the acceleration of the foot, which the wall gives

    def leaves(t: Any, y: Any, leans: bool) -> Any:
        x, v = length * np.sin(y[0]), length * np.cos(y[0]) * y[1]
        return np.array([y[0], y[1], m[0] * x / sum(m), m[0] * v / sum(m)]), False

    ends: list[Any] = []
    follow(
        f,
        (start, 0, 0, 0),
        5,
        [(presses, leaves), (lambda t, y, leans: np.cos(y[0]), lambda t, y, g: _end(ends, t, y))],
    )
    until = float(ends[0]) * draw.uniform(0.2, 0.95)
    theta, rate, x, v = follow(f, (start, 0, 0, 0), until, [(presses, leaves)], True, h=0.01)
    s, c = np.sin(theta), np.cos(theta)
    if x:  # left the wall
        foot, speed = x + m[1] / sum(m) * length * s, v + m[1] / sum(m) * length * c * rate
    else:
        foot, speed = length * s, length * c * rate
    top, drift = foot - length * s, speed - length * c * rate
    scene = Scene(
        (
            Body(m[0], (length * math.sin(start), 0.0), (0.0, 0.0)),
            Body(m[1], (0.0, length * math.cos(start)), (0.0, 0.0)),
        ),
        (Rod((0, 1)), Weight(G), HardWall((0.0, 1.0), 0.0, 0.0), HardWall((1.0, 0.0), 0.0, 0.0)),
        until=until,
    )
    truth = {V: floats(speed, 0, drift, -length * s * rate), X: floats(foot, 0, top, length * c)}
    return Case("ladder", scene, truth, (until,))


def _end(ends: list[Any], t: Any, y: Any) -> Any:
    ends.append(t)
    return np.array([y[0] * 0, 0 * y[1], y[2], y[3]]), True


def thrown_bola(draw: Random) -> Case:
    """Two bodies on a slack string fly apart under their weight, jerk taut and turn about each other."""
    m, length = (draw.uniform(0.2, 1), draw.uniform(0.2, 1)), draw.uniform(0.5, 1)
    v = ((draw.uniform(-3, -1), draw.uniform(-1, 3)), (draw.uniform(1, 3), draw.uniform(-1, 3)))
    rel, total = (v[1][0] - v[0][0], v[1][1] - v[0][1]), sum(m)
    apart = (0.1, 0.0)
    a, b, c = rel[0] ** 2 + rel[1] ** 2, apart[0] * rel[0], apart[0] ** 2 - length**2
    t = (-b + math.sqrt(b * b - a * c)) / a
    at = (apart[0] + rel[0] * t, rel[1] * t)
    omega, angle = (at[0] * rel[1] - at[1] * rel[0]) / length**2, math.atan2(at[1], at[0])
    until = t * draw.choice([0.6, draw.uniform(1.1, 6)])
    if until > t:
        angle += omega * (until - t)
        at = (length * math.cos(angle), length * math.sin(angle))
        rel = (-omega * at[1], omega * at[0])
    else:
        at = (apart[0] + rel[0] * until, rel[1] * until)
    centre = [
        m[1] / total * apart[i] + (m[0] * v[0][i] + m[1] * v[1][i]) / total * until - (0, G * until**2 / 2)[i]
        for i in range(2)
    ]
    drift = [(m[0] * v[0][i] + m[1] * v[1][i]) / total - (0, G * until)[i] for i in range(2)]
    shares = (-m[1] / total, m[0] / total)
    scene = Scene(
        (Body(m[0], (0.0, 0.0), v[0]), Body(m[1], apart, v[1])),
        (String((0, 1), length), Weight(G)),
        until=until,
    )
    truth = {
        V: tuple(drift[i] + s * rel[i] for s in shares for i in range(2)),
        X: tuple(centre[i] + s * at[i] for s in shares for i in range(2)),
    }
    return Case("thrown bola", scene, truth, (until,))


def train(draw: Random) -> Case:
    """An engine at constant speed would be dull: a wagon that is hit jerks the others along, one string after another."""
    m, v = [draw.uniform(0.5, 2) for _ in range(4)], draw.uniform(0.5, 3)
    gaps, t, x, until = [draw.uniform(0.05, 0.2) for _ in range(3)], 0.0, 0.0, draw.uniform(0.2, 2)
    moved = 1
    speed = v
    while moved < 4 and t + gaps[moved - 1] / speed < until:
        t += gaps[moved - 1] / speed
        x += gaps[moved - 1]
        speed *= sum(m[:moved]) / sum(m[: moved + 1])
        moved += 1
    x += speed * (until - t)
    places = [-0.3 * i for i in range(4)]
    strings = tuple(String((i, i + 1), 0.3 + gaps[i]) for i in range(3))
    scene = Scene(
        tuple(Body(m[i], (places[i],), (v if i == 0 else 0.0,)) for i in range(4)), strings, until=until
    )
    ends = tuple(x - sum(gaps[:i]) - 0.3 * i if i < moved else places[i] for i in range(4))
    return Case("train", scene, {V: tuple(speed if i < moved else 0.0 for i in range(4)), X: ends}, (until,))


def tethered(draw: Random) -> Case:
    """Two points on a string with restitution on a line fly through each other from jerk to jerk."""
    m, e, length = (draw.uniform(0.2, 2), draw.uniform(0.2, 2)), draw.uniform(0.4, 1), draw.uniform(0.5, 1)
    v, until = (draw.uniform(-2, 0), draw.uniform(0.5, 2)), draw.uniform(0.5, 4)
    rel, t, at = v[1] - v[0], 0.0, 0.2
    while True:
        left = (length - at) / rel if rel > 0 else (length + at) / -rel
        if t + left > until:
            at += rel * (until - t)
            break
        t, at, rel = t + left, math.copysign(length, rel), -e * rel
    total = sum(m)
    drift = (m[0] * v[0] + m[1] * v[1]) / total
    centre = m[1] / total * 0.2 + drift * until
    scene = Scene(
        (Body(m[0], (0.0,), (v[0],)), Body(m[1], (0.2,), (v[1],))), (String((0, 1), length, e),), until=until
    )
    shares = (-m[1] / total, m[0] / total)
    return Case(
        "tethered",
        scene,
        {V: tuple(drift + s * rel for s in shares), X: tuple(centre + s * at for s in shares)},
        (until,),
    )


def rod_at_a_wall(draw: Random) -> Case:
    """Two bodies on a rod on a line hit a wall, with the bow; a third one flies on."""
    m, v, e = (draw.uniform(0.2, 2), draw.uniform(0.2, 2)), draw.uniform(0.5, 3), draw.uniform(0.2, 1)
    t = 1 / v
    until = t * draw.uniform(1.1, 2)
    back = e * v * (until - t)
    scene = Scene(
        (Body(m[0], (-1.0,), (v,)), Body(m[1], (-1.7,), (v,)), Body(1.0, (-9.0,), (-1.0,))),
        (Rod((0, 1)), HardWall((-1.0,), 0.0, e)),
        until=until,
    )
    return Case(
        "rod at a wall", scene, {V: (-e * v, -e * v, -1), X: (-back, -back - 0.7, -9 - until)}, (until,)
    )


def coupled_pendula(draw: Random) -> Case:
    """Two pendula with a spring between their bobs."""
    m, a, k = (
        (draw.uniform(0.2, 1), draw.uniform(0.2, 1)),
        (draw.uniform(0.3, 0.6), draw.uniform(0.3, 0.6)),
        draw.uniform(5, 40),
    )
    start, until, far = (draw.uniform(-1, 1), draw.uniform(-1, 1)), draw.uniform(0.5, 3), 1.5

    def f(t: Any, y: Any, flags: Any) -> Any:
        s, c = np.sin(y[:2]), np.cos(y[:2])
        dx, dy = far + a[1] * s[1] - a[0] * s[0], a[0] * c[0] - a[1] * c[1]
        r = np.sqrt(dx * dx + dy * dy)
        px, py = k * (r - far) * dx / r, k * (r - far) * dy / r
        rates = [
            -G / a[i] * s[i] + sign * (px * c[i] + py * s[i]) / (m[i] * a[i])
            for i, sign in enumerate((1, -1))
        ]
        return *y[2:], *rates

    y = follow(f, (*start, 0, 0), until)
    places, speeds = [], []
    for i in range(2):
        place, speed = bob_state(y[i], y[2 + i], a[i])
        places += [place[0] + far * i, place[1]]
        speeds += speed
    bodies = [
        Body(m[i], (far * i + a[i] * math.sin(start[i]), -a[i] * math.cos(start[i])), (0.0, 0.0))
        for i in range(2)
    ]
    scene = Scene(
        (nail(0.0, 0.0), nail(far, 0.0), *bodies),
        (Rod((0, 2)), Rod((1, 3)), Spring((2, 3), k, far), Weight(G)),
        until=until,
    )
    return Case(
        "coupled pendula", scene, {V: floats(0, 0, 0, 0, *speeds), X: floats(0, 0, far, 0, *places)}, (until,)
    )


def moving_nail(draw: Random) -> Case:
    """A pendulum hangs from a nail that flies steadily; the bob is at rest at first."""
    length, start, u = draw.uniform(0.3, 1), draw.uniform(-1, 1), (draw.uniform(-2, 2), draw.uniform(-2, 2))
    until = draw.uniform(0.5, 3)
    # Only the speed across the rod may differ from that of the nail.
    across = -u[0] * math.cos(start) - u[1] * math.sin(start)
    y = follow(lambda t, y, flags: (y[1], -G / length * np.sin(y[0])), (start, across / length), until)
    place, speed = bob_state(*y, length)
    v = (u[0] + across * math.cos(start), u[1] + across * math.sin(start))
    scene = Scene(
        (nail(0.0, 0.0, velocity=u), Body(0.4, (length * math.sin(start), -length * math.cos(start)), v)),
        (Rod((0, 1)), Weight(G)),
        until=until,
    )
    at = (u[0] * until, u[1] * until)
    truth = {
        V: floats(*u, speed[0] + u[0], speed[1] + u[1]),
        X: floats(*at, place[0] + at[0], place[1] + at[1]),
    }
    return Case("moving nail", scene, truth, (until,))


def slack_after_a_wall(draw: Random) -> Case:
    """A bob on a string hits a wall beyond its lowest point, flies freely and is caught by the string again."""
    length, start, at = draw.uniform(0.5, 1), draw.uniform(0.6, 1.3), draw.uniform(0.1, 0.4)
    at, e = at * length, draw.uniform(0.3, 0.8)
    edge = np.arcsin(L(-at) / length)
    hits: list[Any] = []

    def bounce(t: Any, y: Any, flags: Any) -> Any:
        hits.append((t, y))
        return np.array([y[0], -y[1]]), flags

    events = [(lambda t, y, flags: y[0] - edge if y[1] < 0 else L(1), bounce)]
    follow(lambda t, y, flags: (y[1], -G / length * np.sin(y[0])), (start, 0), 1.5, events)
    t, y = hits[0]
    (x0, y0), (u, w) = bob_state(*y, length)
    u = -e * u
    # Free: is it within the string, and when is that taut again?
    until = float(t) + draw.uniform(0.05, 0.35)

    def spare(s: Any) -> Any:
        return length**2 - (x0 + u * s) ** 2 - (y0 + w * s - G / 2 * s * s) ** 2

    steps = np.linspace(L(0), L(until) - t, 4001)
    # A blow inwards leaves the string slack at first.
    caught = next((b for b in steps[1:] if spare(b) <= 0), None)
    if spare(steps[1]) <= 0:
        return slack_after_a_wall(draw)
    if caught is None:
        s = L(until) - t
        place, speed = [x0 + u * s, y0 + w * s - G / 2 * s * s], [u, w - G * s]
    else:
        low, high = caught - steps[1], caught
        for _ in range(70):
            middle = (low + high) / 2
            low, high = (middle, high) if spare(middle) > 0 else (low, middle)
        bx, by, bu, bw = x0 + u * high, y0 + w * high - G / 2 * high**2, u, w - G * high
        theta = np.arctan2(bx, -by)
        rate = (bu * np.cos(theta) + bw * np.sin(theta)) / length
        z = follow(lambda t, y, flags: (y[1], -G / length * np.sin(y[0])), (theta, rate), L(until) - t - high)
        if length * np.sin(z[0]) < -at:
            return slack_after_a_wall(draw)
        place, speed = bob_state(*z, length)
    scene = Scene(
        (nail(0.0, 0.0), Body(0.4, (length * math.sin(start), -length * math.cos(start)), (0.0, 0.0))),
        (String((0, 1), length), Weight(G), HardWall((1.0, 0.0), -at, e, only=(1,))),
        until=until,
    )
    return Case("slack after a wall", scene, {V: floats(0, 0, *speed), X: floats(0, 0, *place)}, (until,))


FAMILIES = (
    pendulum_at_a_wall,
    pendulum_in_a_fluid,
    three_in_a_chain,
    springy_pendulum,
    smooth_cart,
    rough_cart,
    ladder,
    thrown_bola,
    train,
    tethered,
    rod_at_a_wall,
    coupled_pendula,
    moving_nail,
    slack_after_a_wall,
)
