"""Families on a line and on the floor: walls, bounces, friction, drag, belts; their references are closed forms."""

from __future__ import annotations

import math
from random import Random

from scipy.special import ellipj, ellipk

from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Scene

from .case import Case

V, X, S = Observable.VELOCITIES, Observable.TRAJECTORY, Observable.SPINS
NAIL = Body(math.inf, (0.0,), (0.0,))
G = 9.8
NAN = math.nan


def rest_and_fall(draw: Random) -> Case:
    """A block rests on the floor while a ball falls beside it."""
    m, h, u, t = draw.uniform(0.1, 5), draw.uniform(5, 20), draw.uniform(-3, 3), draw.uniform(0.1, 0.9)
    scene = Scene(
        (Body(m, (0.0, 0.5), (0.0, 0.0), 0.5), Body(1.0, (9.0, h), (u, 0.0), 0.1)),
        (Weight(G), HardWall((0.0, 1.0), restitution=draw.choice([0.0, 0.5, 1.0]))),
        until=t,
    )
    return Case(
        "rest and fall", scene, {V: (0, 0, u, -G * t), X: (0, 0.5, 9 + u * t, h - G * t * t / 2)}, (t,)
    )


def friction_swing(draw: Random) -> Case:
    """A block on a spring with friction, until it is held."""
    k, m, mu = draw.uniform(20, 300), draw.uniform(0.2, 3), draw.uniform(0.02, 0.3)
    static = mu * draw.uniform(1.0, 2.5)
    shift, holding = mu * m * G / k, static * m * G / k
    places = [holding * draw.uniform(1.05, 9.0)]
    while abs(places[-1]) > holding:
        places.append(-(abs(places[-1]) - 2 * shift) * math.copysign(1.0, places[-1]))
    until = math.pi * math.sqrt(m / k) * (len(places) + 0.3)
    length = 2.0 * places[0]
    scene = Scene(
        (NAIL, Body(m, (length + places[0],), (0.0,))),
        (Spring((0, 1), k, length), Friction(1, mu, G, static)),
        until=until,
    )
    return Case("friction swing", scene, {V: (0, 0), X: (0, length + places[-1])}, (until,))


def slide_to_rest(draw: Random) -> Case:
    """Blocks slide over a table, each to its own rest, while another flies on."""
    mus, vs = [draw.uniform(0.1, 0.6) for _ in range(3)], [draw.uniform(-4, 4) for _ in range(3)]
    until = draw.uniform(0.3, 4)
    bodies = (*(Body(1.0 + i, (10.0 * i,), (v,)) for i, v in enumerate(vs)), Body(1.0, (40.0,), (1.5,)))
    scene = Scene(bodies, tuple(Friction(i, mu) for i, mu in enumerate(mus)), until=until)
    v_end, x_end = [], []
    for i, (mu, v) in enumerate(zip(mus, vs, strict=True)):
        t = min(until, abs(v) / (mu * G))
        v_end.append(v - math.copysign(mu * G * t, v) if t == until else 0.0)
        x_end.append(10.0 * i + v * t - math.copysign(mu * G * t * t / 2, v))
    return Case("slide to rest", scene, {V: (*v_end, 1.5), X: (*x_end, 40 + 1.5 * until)}, (until,))


def oscillator_at_wall(draw: Random) -> Case:
    """An oscillator hits a wall, perhaps only just, once."""
    w, wall, e = draw.uniform(1, 5), draw.uniform(0.05, 0.3), draw.choice([1.0, draw.uniform(0.2, 1)])
    amplitude = wall * (1 + 10 ** draw.uniform(-7, 0.3))
    hit = math.acos(-wall / amplitude) / w
    until = hit + draw.uniform(0.05, 0.9) * math.pi / w * 0.5
    scene = Scene(
        (NAIL, Body(2.0, (1.0 - amplitude,), (0.0,))),
        (Spring((0, 1), 2 * w * w, 1.0), HardWall((-1.0,), -1.0 - wall, e)),
        until=until,
    )
    speed, left = e * amplitude * w * math.sin(w * hit), until - hit
    x = wall * math.cos(w * left) - speed / w * math.sin(w * left)
    v = -wall * w * math.sin(w * left) - speed * math.cos(w * left)
    return Case("oscillator at a wall", scene, {V: (0, v), X: (0, 1 + x)}, (until,))


def bounces(draw: Random) -> Case:
    """A ball bounces n times with a restitution, flying on sideways."""
    h, e, u = draw.uniform(0.3, 4), draw.uniform(0.3, 1), draw.uniform(-2, 2)
    t0 = math.sqrt(2 * h / G)
    n, speed, when = draw.randint(1, 6), G * t0, t0
    for _ in range(n - 1):
        speed *= e
        when += 2 * speed / G
    speed *= e
    left = draw.uniform(0.1, 0.9) * 2 * speed / G
    scene = Scene(
        (Body(0.7, (0.0, h), (u, 0.0)),), (Weight(G), HardWall((0.0, 1.0), 0.0, e)), until=when + left
    )
    truth = {V: (u, speed - G * left), X: (u * (when + left), speed * left - G * left * left / 2)}
    return Case("bounces", scene, truth, (when + left,))


def zeno_and_slide(draw: Random) -> Case:
    """Bounces without end on a smooth floor; the ball slides on."""
    h, e, u = draw.uniform(0.3, 4), draw.uniform(0.1, 0.8), draw.uniform(-2, 2)
    until = math.sqrt(2 * h / G) * (1 + e) / (1 - e) * draw.uniform(1.1, 2)
    scene = Scene((Body(0.7, (0.0, h), (u, 0.0)),), (Weight(G), HardWall((0.0, 1.0), 0.0, e)), until=until)
    return Case("Zeno", scene, {V: (u, 0), X: (u * until, 0)}, (until,))


def incline(draw: Random) -> Case:
    """A block on an incline: held, or sliding."""
    angle, mu = draw.uniform(0.05, 1.3), draw.uniform(0.05, 1.0)
    static, t = mu * draw.uniform(1, 1.6), draw.uniform(0.2, 2)
    c, s = math.cos(angle), math.sin(angle)
    held = math.tan(angle) <= static
    a = 0.0 if held else G * (s - mu * c)
    scene = Scene(
        (Body(2.0, (0.0, 0.0), (0.0, 0.0)),),
        (Weight(G), HardWall((s, c), 0.0, 0.0, mu, static)),
        until=t,
    )
    truth = {V: (a * t * c, -a * t * s), X: (a * t * t / 2 * c, -a * t * t / 2 * s)}
    return Case("incline", scene, truth, (t,))


def rolling(draw: Random) -> Case:
    """A sphere set down sliding, perhaps spinning: it slips until it rolls."""
    r, mu, v = draw.uniform(0.02, 0.3), draw.uniform(0.05, 0.5), draw.uniform(0.5, 4)
    spin = draw.choice([0.0, draw.uniform(-20, 20)])
    slip = v + spin * r
    stop = 2 * abs(slip) / (7 * mu * G)
    t = stop * draw.uniform(0.3, 3)
    slid, way = min(t, stop), math.copysign(1.0, slip)
    v1, spin1 = v - way * mu * G * slid, spin - way * 2.5 * mu * G * slid / r
    x = v * slid - way * mu * G * slid**2 / 2 + v1 * (t - slid)
    scene = Scene(
        (Body(0.5, (0.0, r), (v, 0.0), r, spin=spin),),
        (Weight(G), HardWall((0.0, 1.0), 0.0, 0.0, mu)),
        until=t,
    )
    return Case("rolling", scene, {V: (v1, 0), S: (spin1,), X: (x, r)}, (t,))


def rolling_down(draw: Random) -> Case:
    """A sphere on an incline: it rolls, or slips where friction is too weak."""
    r, angle, mu, t = (
        draw.uniform(0.02, 0.3),
        draw.uniform(0.1, 1.3),
        draw.uniform(0.02, 0.8),
        draw.uniform(0.2, 2),
    )
    c, s = math.cos(angle), math.sin(angle)
    rolls = mu >= 2 / 7 * math.tan(angle)
    a = 5 / 7 * G * s if rolls else G * (s - mu * c)
    turning = -a / r if rolls else -2.5 * mu * G * c / r
    scene = Scene(
        (Body(2.0, (r * s, r * c), (0.0, 0.0), r),), (Weight(G), HardWall((s, c), 0.0, 0.0, mu)), until=t
    )
    return Case("rolling down", scene, {V: (a * t * c, -a * t * s), S: (turning * t,)}, ())


def pulled_ever_harder(draw: Random) -> Case:
    """A block on a table under a force that grows: static friction holds it, then kinetic brakes it."""
    m, mu, rate = draw.uniform(0.3, 3), draw.uniform(0.1, 0.6), draw.uniform(1, 20)
    static = mu * draw.choice([1.0, draw.uniform(1, 2)])
    t0 = static * m * G / rate
    t = t0 * draw.uniform(0.5, 3)
    left = max(t - t0, 0.0)
    v = (rate * (t0 * left + left**2 / 2) - mu * m * G * left) / m
    x = (rate * (t0 * left**2 / 2 + left**3 / 6) - mu * m * G * left**2 / 2) / m
    scene = Scene(
        (Body(m, (1.0,), (0.0,)),),
        (ForceFunction(0, lambda t, x, v: (rate * t,)), Friction(0, mu, G, static)),
        until=t,
    )
    return Case("pulled ever harder", scene, {V: (v,), X: (1 + x,)}, (t,))


def linear_drag(draw: Random) -> Case:
    """A throw against linear drag."""
    m, c, t, u, v = (
        draw.uniform(0.1, 2),
        draw.uniform(0.05, 3),
        draw.uniform(0.3, 4),
        draw.uniform(-5, 5),
        draw.uniform(0, 9),
    )
    tau = m / c
    f = math.exp(-t / tau)
    scene = Scene((Body(m, (0.0, 0.0), (u, v)),), (Weight(G), Drag(0, linear=c)), until=t)
    truth = {
        V: (u * f, (v + G * tau) * f - G * tau),
        X: (u * tau * (1 - f), (v + G * tau) * tau * (1 - f) - G * tau * t),
    }
    return Case("linear drag", scene, truth, (t,))


def quadratic_drag(draw: Random) -> Case:
    """Thrown up against quadratic drag, and down again."""
    m, c, v = draw.uniform(0.1, 2), draw.uniform(0.01, 0.5), draw.uniform(2, 20)
    vt = math.sqrt(m * G / c)
    up = vt / G * math.atan(v / vt)
    top = vt * vt / (2 * G) * math.log1p((v / vt) ** 2)
    t = up + draw.uniform(0.2, 2)
    fall = t - up
    scene = Scene((Body(m, (0.0,), (v,)),), (Weight(G), Drag(0, quadratic=c)), until=t)
    truth = {
        V: (-vt * math.tanh(G * fall / vt),),
        X: (top - vt * vt / G * math.log(math.cosh(G * fall / vt)),),
    }
    return Case("quadratic drag", scene, truth, (t,))


def quartic(draw: Random) -> Case:
    """A force of one's own with its potential: x'' = -k x^3/m is a Jacobian elliptic cosine."""
    k, m, a, t = draw.uniform(1, 20), draw.uniform(0.2, 2), draw.uniform(0.3, 2), draw.uniform(0.5, 6)
    w = a * math.sqrt(k / m)
    sn, cn, dn, _ = ellipj(w * t % (4 * float(ellipk(0.5))), 0.5)
    force = ForceFunction(0, lambda t, x, v: (-k * x[0] ** 3,), lambda x: k * x[0] ** 4 / 4)
    scene = Scene((Body(m, (a,), (0.0,)),), (force,), until=t)
    return Case("own force", scene, {V: (-a * w * sn * dn,), X: (a * cn,)}, (t,))


def driven(draw: Random) -> Case:
    """A driven oscillator, off resonance."""
    m, k, f = draw.uniform(0.5, 2), draw.uniform(5, 50), draw.uniform(0.5, 5)
    w0 = math.sqrt(k / m)
    w, t = w0 * draw.choice([0.3, 0.7, 1.4, 2.2]), draw.uniform(1, 8)
    a = f / m / (w0 * w0 - w * w)
    force = ForceFunction(0, lambda t, x, v: (f * math.cos(w * t) - k * x[0],))
    scene = Scene((Body(m, (0.0,), (0.0,)),), (force,), until=t)
    truth = {
        V: (a * (w0 * math.sin(w0 * t) - w * math.sin(w * t)),),
        X: (a * (math.cos(w * t) - math.cos(w0 * t)),),
    }
    return Case("driven", scene, truth, (t,))


def contacts_by_pair(draw: Random) -> Case:
    """Three balls far apart with contacts of their own: one collision after the other, and the third pair passes."""
    m = [draw.uniform(0.1, 1) for _ in range(3)]
    v = draw.uniform(0.5, 3)
    v0, v1 = (m[0] - m[1]) / (m[0] + m[1]) * v, 2 * m[0] / (m[0] + m[1]) * v
    v1, v2 = (m[1] - m[2]) / (m[1] + m[2]) * v1, 2 * m[1] / (m[1] + m[2]) * v1
    if v0 > v1:
        return contacts_by_pair(draw)
    bodies = tuple(
        Body(mass, (x,), (v * (x == 0.0),), 0.05) for mass, x in zip(m, (0.0, 1.0, 2.0), strict=True)
    )
    forces = (
        Contact(10 ** draw.uniform(5, 8), 1.5, chosen=((0, 1),)),
        Contact(10 ** draw.uniform(4, 6), 1.0, chosen=((1, 2),)),
    )
    scene = Scene(bodies, forces)
    return Case("contacts by pair", scene, {V: (v0, v1, v2)}, ())


FAMILIES = (
    rest_and_fall, friction_swing, slide_to_rest, oscillator_at_wall, bounces, zeno_and_slide, incline, rolling,
    rolling_down,   pulled_ever_harder,   linear_drag,
    quadratic_drag, quartic, driven, contacts_by_pair,
)  # fmt: skip
