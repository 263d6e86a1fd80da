"""Families in fields and with forces of one's own: magnets, rotating tables, orbits, a rocket; closed forms or `follow`."""

from __future__ import annotations

import cmath
import math
from random import Random
from typing import Any

import numpy as np

from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, InverseSquare, Weight
from corollary.scenes.forces.flows import Absorption, Drag
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .case import Case
from .reference import follow

V, X = Observable.VELOCITIES, Observable.TRAJECTORY
G = 9.8


def floats(*values: Any) -> tuple[float, ...]:
    return tuple(float(v) for v in values)


def skipping_orbit(draw: Random) -> Case:
    """A charge in a magnetic field skips along a wall on arcs of circles."""
    w, v, angle, until = draw.uniform(1, 5), draw.uniform(0.5, 2), draw.uniform(0.4, 2.7), draw.uniform(1, 6)
    # It turns clockwise: velocity v exp(i (angle - w t)); up again with the same angle after 2 angle / w.
    period = 2 * angle / w
    n, left = divmod(until, period)
    along = n * 2 * v / w * math.sin(angle)
    vel = v * cmath.exp(1j * (angle - w * left))
    at = along + 1j * v / w * (cmath.exp(1j * (angle - w * left)) - cmath.exp(1j * angle))
    m = 0.3
    field = ForceFunction(0, lambda t, x, u: (m * w * u[1], -m * w * u[0]))
    start = v * cmath.exp(1j * angle)
    scene = Scene(
        (Body(m, (0.0, 0.0), (start.real, start.imag)),), (field, HardWall((0.0, 1.0))), until=until
    )
    return Case("skipping orbit", scene, {V: (vel.real, vel.imag), X: (at.real, at.imag)}, (until,))


def crossed_fields(draw: Random) -> Case:
    """Crossed fields and a drag: a spiral into a drift."""
    m, w, e, c, until = (
        draw.uniform(0.2, 1),
        draw.uniform(2, 8),
        draw.uniform(1, 5),
        draw.uniform(0, 1),
        draw.uniform(1, 6),
    )
    v0 = complex(draw.uniform(-2, 2), draw.uniform(-2, 2))
    rate = -1j * w - c / m
    drift = -(e / m) / rate
    vel = drift + (v0 - drift) * cmath.exp(rate * until)
    at = drift * until + (v0 - drift) * (cmath.exp(rate * until) - 1) / rate
    field = ForceFunction(0, lambda t, x, u: (e + m * w * u[1], -m * w * u[0]))
    scene = Scene((Body(m, (0.0, 0.0), (v0.real, v0.imag)),), (field, Drag(0, c)), until=until)
    return Case("crossed fields", scene, {V: (vel.real, vel.imag), X: (at.real, at.imag)}, (until,))


def foucault(draw: Random) -> Case:
    """An isotropic swing seen from a turntable."""
    m, w, turn, until = draw.uniform(0.2, 1), draw.uniform(2, 6), draw.uniform(0.1, 1.5), draw.uniform(2, 9)
    z0, v0 = complex(draw.uniform(0.2, 1), 0), complex(draw.uniform(-1, 1), draw.uniform(-1, 1))
    start = v0 + 1j * turn * z0  # seen from outside
    z, v = (
        z0 * math.cos(w * until) + start / w * math.sin(w * until),
        start * math.cos(w * until) - z0 * w * math.sin(w * until),
    )
    back = cmath.exp(-1j * turn * until)
    vel, at = (v - 1j * turn * z) * back, z * back

    def force(t: float, x: Any, u: Any) -> tuple[float, float]:
        pull = m * (turn**2 - w**2)
        return pull * x[0] + 2 * m * turn * u[1], pull * x[1] - 2 * m * turn * u[0]

    scene = Scene((Body(m, (z0.real, z0.imag), (v0.real, v0.imag)),), (ForceFunction(0, force),), until=until)
    return Case("Foucault", scene, {V: (vel.real, vel.imag), X: (at.real, at.imag)}, (until,))


def rutherford(draw: Random) -> Case:
    """A light particle is turned back by a heavier one that is free to move."""
    m, k, b, v = (
        (draw.uniform(0.1, 1), draw.uniform(1, 4)),
        draw.uniform(0.2, 2),
        draw.uniform(0.01, 0.5),
        draw.uniform(2, 4),
    )
    until, far = draw.uniform(0.5, 3), 2.0

    def f(t: Any, y: Any, flags: Any) -> Any:
        apart = y[2:4] - y[:2]
        push = k * apart / np.sqrt(apart @ apart) ** 3
        return [*y[4:], *(-push / m[0]), *(push / m[1])]

    y = follow(f, (-far, b, 0, 0, v, 0, 0, 0), until, h=0.002)
    scene = Scene(
        (Body(m[0], (-far, b), (v, 0.0)), Body(m[1], (0.0, 0.0), (0.0, 0.0))),
        (InverseSquare((0, 1), -k),),
        until=until,
    )
    return Case("Rutherford", scene, {V: floats(*y[4:]), X: floats(*y[:4])}, (until,))


def decaying_orbit(draw: Random) -> Case:
    """A satellite in thin air spirals inwards; its planet is held."""
    m, gm, until = draw.uniform(0.2, 1), draw.uniform(0.5, 2), draw.uniform(2, 8)
    c = m * draw.uniform(0.002, 0.02)
    v = math.sqrt(gm) * draw.uniform(0.8, 1.2)

    def f(t: Any, y: Any, flags: Any) -> Any:
        pull = -gm * y[:2] / np.sqrt(y[:2] @ y[:2]) ** 3
        return [*y[2:], *(pull - c / m * np.sqrt(y[2:] @ y[2:]) * y[2:])]

    y = follow(f, (1, 0, 0, v), until, h=0.01)
    scene = Scene(
        (Body(math.inf, (0.0, 0.0), (0.0, 0.0)), Body(m, (1.0, 0.0), (0.0, v))),
        (InverseSquare((0, 1), gm * m), Drag(1, quadratic=c)),
        until=until,
    )
    return Case("decaying orbit", scene, {V: floats(0, 0, *y[2:]), X: floats(0, 0, *y[:2])}, (until,))


def figure_eight(draw: Random) -> Case:
    """Three equal bodies chase each other along an eight (Moore; Chenciner and Montgomery), a little disturbed."""
    a, until = [draw.uniform(-0.01, 0.01) for _ in range(4)], draw.uniform(1, 7)
    x, u = (0.97000436 + a[0], -0.24308753 + a[1]), (0.466203685 + a[2], 0.43236573 + a[3])
    places = (*x, -x[0], -x[1], 0.0, 0.0)
    speeds = (*u, *u, -2 * u[0], -2 * u[1])

    def f(t: Any, y: Any, flags: Any) -> Any:
        p, rates = y[:6].reshape(3, 2), np.zeros((3, 2), np.longdouble)
        for i, j in ((0, 1), (0, 2), (1, 2)):
            d = p[j] - p[i]
            d = d / np.sqrt(d @ d) ** 3
            rates[i] += d
            rates[j] -= d
        return [*y[6:], *rates.ravel()]

    y = follow(f, (*places, *speeds), until)
    bodies = tuple(Body(1.0, places[2 * i : 2 * i + 2], speeds[2 * i : 2 * i + 2]) for i in range(3))
    scene = Scene(bodies, tuple(InverseSquare(p, 1.0) for p in ((0, 1), (0, 2), (1, 2))), until=until)
    return Case("figure of eight", scene, {V: floats(*y[6:]), X: floats(*y[:6])}, (until,))


def orbit_on_a_mirror(draw: Random) -> Case:
    """A planet bounces off a plane through its sun: its orbit, folded."""
    gm, e, until = draw.uniform(0.5, 2), draw.uniform(0.1, 0.7), draw.uniform(3, 15)
    turn = draw.uniform(0.3, 2.8)
    n = math.sqrt(gm)
    mean, ecc = n * until, n * until
    for _ in range(100):
        ecc -= (ecc - e * math.sin(ecc) - mean) / (1 - e * math.cos(ecc))
    root = math.sqrt(1 - e * e)

    def at(ecc: float) -> tuple[complex, complex]:
        c, s = math.cos(ecc), math.sin(ecc)
        rate = n / (1 - e * c)
        return (
            complex(c - e, root * s) * cmath.exp(1j * turn),
            complex(-s, root * c) * rate * cmath.exp(1j * turn),
        )

    (z0, v0), (z, v) = at(0.0), at(ecc)
    sign = 1 if z.imag > 0 else -1
    scene = Scene(
        (Body(math.inf, (0.0, 0.0), (0.0, 0.0)), Body(0.3, (z0.real, z0.imag), (v0.real, v0.imag))),
        (InverseSquare((0, 1), gm * 0.3), HardWall((0.0, 1.0), only=(1,))),
        until=until,
    )
    truth = {V: (0, 0, v.real, sign * v.imag), X: (0, 0, z.real, sign * z.imag)}
    return Case("orbit on a mirror", scene, truth, (until,))


def swing_on_a_mirror(draw: Random) -> Case:
    """A swing in a plane bounces off a slanted wall through its middle."""
    w, tilt, until = draw.uniform(1, 4), draw.uniform(-1, 1), draw.uniform(2, 8)
    z0, v0 = (
        complex(draw.uniform(-1, 1), draw.uniform(0.2, 1)),
        complex(draw.uniform(-2, 2), draw.uniform(-2, 2)),
    )
    c, s = math.cos(w * until), math.sin(w * until)
    z, v = z0 * c + v0 / w * s, v0 * c - z0 * w * s
    if z.imag < 0:
        z, v = z.conjugate(), v.conjugate()
    spin = cmath.exp(1j * tilt)
    z0, v0, z, v = (each * spin for each in (z0, v0, z, v))
    force = ForceFunction(
        0,
        lambda t, x, u: (-w * w * x[0], -w * w * x[1]),
        energy=lambda x: w * w * (x[0] ** 2 + x[1] ** 2) / 2,
    )
    scene = Scene(
        (Body(1.0, (z0.real, z0.imag), (v0.real, v0.imag)),),
        (force, HardWall((-math.sin(tilt), math.cos(tilt)))),
        until=until,
    )
    return Case("swing on a mirror", scene, {V: (v.real, v.imag), X: (z.real, z.imag)}, (until,))


def fading_push(draw: Random) -> Case:
    """A push that swings and fades, in a fluid."""
    m, c, a, w, b = (
        draw.uniform(0.2, 2),
        draw.uniform(0.1, 1),
        draw.uniform(1, 9),
        draw.uniform(1, 9),
        draw.uniform(0.1, 1),
    )
    until, v0 = draw.uniform(1, 8), draw.uniform(-2, 2)
    rate, decay = complex(-b, w), -c / m
    if abs(b - c / m) < 0.05:
        b += 0.2
        rate = complex(-b, w)
    amp = a / m / (rate - decay)
    v = (v0 - amp.real) * math.exp(decay * until) + (amp * cmath.exp(rate * until)).real
    x = (v0 - amp.real) * math.expm1(decay * until) / decay + (
        amp * (cmath.exp(rate * until) - 1) / rate
    ).real
    push = ForceFunction(0, lambda t, x, u: (a * math.exp(-b * t) * math.cos(w * t),))
    scene = Scene((Body(m, (0.0,), (v0,)),), (push, Drag(0, c)), until=until)
    return Case("fading push", scene, {V: (v,), X: (x,)}, (until,))


def coal_wagon(draw: Random) -> Case:
    """A wagon on a spring takes up coal that falls into it."""
    m, k, rate, x0, until = (
        draw.uniform(1, 3),
        draw.uniform(5, 40),
        draw.uniform(0.1, 2),
        draw.uniform(0.2, 1),
        draw.uniform(1, 5),
    )

    def f(t: Any, y: Any, flags: Any) -> Any:
        return y[1], (-k * (y[0] - 1) - rate * y[1]) / (m + rate * t)

    y = follow(f, (1 + x0, 0), until)
    scene = Scene(
        (Body(math.inf, (0.0,), (0.0,)), Body(m, (1 + x0,), (0.0,))),
        (Spring((0, 1), k, 1.0), Absorption(1, (0.0,), rate)),
        until=until,
    )
    return Case("coal wagon", scene, {V: floats(0, y[1]), X: floats(0, y[0])}, (until,))


def van_der_pol(draw: Random) -> Case:
    """A swing that feeds itself."""
    mu, until, x0 = draw.uniform(0.1, 4), draw.uniform(2, 12), draw.uniform(0.1, 3)
    y = follow(lambda t, y, flags: (y[1], mu * (1 - y[0] ** 2) * y[1] - y[0]), (x0, 0), until, h=0.01)
    force = ForceFunction(0, lambda t, x, u: (mu * (1 - x[0] ** 2) * u[0] - x[0],))
    scene = Scene((Body(1.0, (x0,), (0.0,)),), (force,), until=until)
    return Case("van der Pol", scene, {V: floats(y[1]), X: floats(y[0])}, (until,))


def duffing_at_a_wall(draw: Random) -> Case:
    """A driven, damped swing with two wells bounces off a wall."""
    push, w, c, e = (
        draw.uniform(0.1, 0.3),
        draw.uniform(0.8, 1.4),
        draw.uniform(0.1, 0.4),
        draw.uniform(0.5, 1),
    )
    until, wall = draw.uniform(3, 10), draw.uniform(-0.5, 0.2)

    def f(t: Any, y: Any, flags: Any) -> Any:
        return y[1], y[0] - y[0] ** 3 - c * y[1] + push * np.cos(w * t)

    hits: list[Any] = []

    def bounce(t: Any, y: Any, flags: Any) -> Any:
        hits.append(t)
        if len(hits) > 8 or abs(y[1]) < 0.05:
            raise OverflowError
        return np.array([y[0], -e * y[1]]), flags

    try:
        y = follow(
            f, (1.2, -1.5), until, [(lambda t, y, g: y[0] - wall if y[1] < 0 else np.longdouble(1), bounce)]
        )
    except OverflowError:
        return duffing_at_a_wall(draw)
    force = ForceFunction(0, lambda t, x, u: (x[0] - x[0] ** 3 - c * u[0] + push * math.cos(w * t),))
    scene = Scene((Body(1.0, (1.2,), (-1.5,)),), (force, HardWall((1.0,), wall, e)), until=until)
    return Case("Duffing at a wall", scene, {V: floats(y[1]), X: floats(y[0])}, (until,))


def parachute(draw: Random) -> Case:
    """Two falling bodies on a spring, one of them with a parachute."""
    m, c, k = (draw.uniform(0.2, 1), draw.uniform(0.5, 2)), draw.uniform(0.1, 1), draw.uniform(50, 300)
    wind, until = draw.uniform(-4, 4), draw.uniform(0.5, 3)

    def f(t: Any, y: Any, flags: Any) -> Any:
        apart = y[2:4] - y[:2]
        r = np.sqrt(apart @ apart)
        pull = k * (r - 1) * apart / r
        air = np.array([y[4] - wind, y[5]])
        down = np.array([0, -G])
        return [*y[4:], *((pull - c * np.sqrt(air @ air) * air) / m[0] + down), *(-pull / m[1] + down)]

    y = follow(f, (0, 1, 0, 0, 0, 0, 0, 0), until, h=0.01)
    scene = Scene(
        (Body(m[0], (0.0, 1.0), (0.0, 0.0)), Body(m[1], (0.0, 0.0), (0.0, 0.0))),
        (Spring((0, 1), k, 1.0), Weight(G), Drag(0, quadratic=c, wind=(wind, 0.0))),
        until=until,
    )
    return Case("parachute", scene, {V: floats(*y[4:]), X: floats(*y[:4])}, (until,))


def thrown_steeply(draw: Random) -> Case:
    """In wind a body all but stops in the air at the top of its throw: quadratic drag bends there."""
    m, c, until = draw.uniform(0.1, 1), draw.uniform(0.02, 0.3), draw.uniform(0.5, 2)
    wind = draw.uniform(-1, 1), draw.uniform(-1, 1)
    start = wind[0] + 10 ** draw.uniform(-4, 0), wind[1] + draw.uniform(1, 8)

    def f(t: Any, y: Any, flags: Any) -> Any:
        across, up = y[2] - wind[0], y[3] - wind[1]
        pull = c / m * np.sqrt(across**2 + up**2)
        return [y[2], y[3], -pull * across, -pull * up - G]

    y = follow(f, (0, 0, *start), until)
    forces = Weight(G), Drag(0, quadratic=c, wind=wind)
    scene = Scene((Body(m, (0.0, 0.0), start),), forces, until=until)
    return Case("thrown steeply", scene, {V: floats(*y[2:]), X: floats(*y[:2])}, (until,))


FAMILIES = (
    skipping_orbit,
    crossed_fields,
    foucault,
    rutherford,
    decaying_orbit,
    figure_eight,
    orbit_on_a_mirror,
    swing_on_a_mirror,
    fading_push,
    coal_wagon,
    van_der_pol,
    duffing_at_a_wall,
    parachute,
    thrown_steeply,
)
