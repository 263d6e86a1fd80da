"""Families on a line whose outcome is a closed form: long times, extreme mass ratios, bounces by the hundred, forces of one's own."""

from __future__ import annotations

import math
from random import Random
from typing import Any

from mpmath import mp

from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import ForceFunction, InverseSquare, Weight
from corollary.scenes.forces.flows import Absorption, Drag, Thrust
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Force, Scene

from .case import Case

V, X = Observable.VELOCITIES, Observable.TRAJECTORY
G = 9.8


def one(name: str, m: float, x: float, v: float, forces: tuple[Force, ...], until: float, true: Any) -> Case:
    """One body on a line; `true` are its place and velocity at the end."""
    place, velocity = true
    scene = Scene((Body(m, (x,), (v,)),), forces, until=until)
    return Case(name, scene, {V: (float(velocity),), X: (float(place),)}, (until,))


def to_and_fro(draw: Random) -> Case:
    """A ball between two elastic walls, hundreds of times."""
    wide, v, x, until = (
        draw.uniform(0.5, 2),
        draw.uniform(5, 30),
        draw.uniform(0.1, 0.4),
        draw.uniform(10, 40),
    )
    way = (mp.mpf(x) + mp.mpf(v) * until) % (2 * mp.mpf(wide))
    back = way > wide
    true = (2 * wide - way if back else way), (-v if back else v)
    return one("to and fro", 1.0, x, v, (HardWall((1.0,), 0.0), HardWall((-1.0,), -wide)), until, true)


def tired_between_walls(draw: Random) -> Case:
    """Between two walls that take a share of the speed each time, over a rough table, until it stops."""
    wide, e, mu, v = (
        draw.uniform(0.5, 2),
        draw.uniform(0.5, 0.95),
        draw.uniform(0.02, 0.2),
        draw.uniform(2, 8),
    )
    x, speed, way = mp.mpf(wide) / 3, mp.mpf(v), 1
    start = float(x)
    x = mp.mpf(start)
    while True:
        room = (wide - x) if way > 0 else x
        left = speed**2 - 2 * mu * mp.mpf(G) * room
        if left <= 0:
            x += way * speed**2 / (2 * mu * mp.mpf(G))
            break
        speed, x, way = e * mp.sqrt(left), mp.mpf(wide) if way > 0 else mp.mpf(0), -way
    walls = HardWall((1.0,), 0.0, restitution=e), HardWall((-1.0,), -wide, restitution=e)
    return one(
        "tired between walls", 1.3, start, v, (*walls, Friction(0, mu, G)), v / (mu * G) + 1.0, (x, 0.0)
    )


def nearly_zeno(draw: Random) -> Case:
    """A ball that bounces ever lower, looked at when it has bounced dozens of times and never rests."""
    e, h = draw.uniform(0.9, 0.97), draw.uniform(0.5, 2)
    bounces = draw.randint(20, 45)
    g = mp.mpf(G)
    u = mp.sqrt(2 * g * h)
    t = u / g
    for _ in range(bounces):
        u *= e
        t += 2 * u / g
    u *= e
    part = draw.uniform(0.2, 0.8)
    until = float(t + part * 2 * u / g)
    flown = mp.mpf(until) - t
    true = u * flown - g * flown**2 / 2, u - g * flown
    return one("nearly Zeno", 0.7, h, 0.0, (Weight(G), HardWall((1.0,), restitution=e)), until, true)


def heavy_meets_light(draw: Random) -> Case:
    """Three balls far apart, masses over nine powers of ten: one elastic collision after another."""
    m = [10.0 ** draw.uniform(-6, 3) for _ in range(3)]
    v = draw.uniform(1, 3)
    u = [mp.mpf(v), mp.mpf(0), mp.mpf(0)]
    x = [mp.mpf(0), mp.mpf(1), mp.mpf(2)]
    while True:
        times = [
            ((x[i + 1] - x[i]) / (u[i] - u[i + 1]), i)
            for i in range(2)
            if u[i] > u[i + 1] and x[i + 1] > x[i]
        ]
        if not times:
            break
        dt, i = min(times)
        x = [a + b * dt for a, b in zip(x, u, strict=True)]
        x[i + 1] = x[i]
        common = (m[i] * u[i] + m[i + 1] * u[i + 1]) / (mp.mpf(m[i]) + m[i + 1])
        u[i], u[i + 1] = 2 * common - u[i], 2 * common - u[i + 1]
        x[i + 1] += mp.mpf(10) ** -25
    bodies = tuple(Body(m[i], (float(i),), (v if i == 0 else 0.0,), 0.0078125) for i in range(3))
    stiff = 1e9 * max(m) * 100
    scene = Scene(bodies, (Contact(stiff, 1.0),))
    return Case("heavy meets light", scene, {V: tuple(map(float, u))})


def relay(draw: Random) -> Case:
    """Six equal balls far apart, each pair with a contact of its own: the velocity is handed on to the last."""
    v, m, n = draw.uniform(0.5, 3), draw.uniform(0.05, 1), 6
    bodies = tuple(Body(m, (0.3 * i,), (v if i == 0 else 0.0,), 0.05) for i in range(n))
    contacts = tuple(
        Contact(10.0 ** draw.uniform(5, 7), draw.choice([1.0, 1.5, 2.0]), chosen=((i, i + 1),))
        for i in range(n - 1)
    )
    return Case("relay", Scene(bodies, contacts), {V: (*(0.0,) * (n - 1), v)})


def rocket_in_syrup(draw: Random) -> Case:
    """A rocket with linear drag: m v' = burn u - b v is a power of the mass."""
    m, burn, u, b = draw.uniform(5, 10), draw.uniform(0.5, 2), draw.uniform(100, 500), draw.uniform(0.2, 3)
    until = draw.uniform(0.3, 0.9) * m / burn
    share = 1 - mp.mpf(burn) * until / m
    v = mp.mpf(burn) * u / b * (1 - share ** (mp.mpf(b) / burn))
    # The way: the integral of that power.
    p = mp.mpf(b) / burn + 1
    x = mp.mpf(burn) * u / b * (until - m / mp.mpf(burn) * (1 - share**p) / p)
    return one("rocket in syrup", m, 0.0, 0.0, (Thrust(0, (-u,), burn), Drag(0, linear=b)), until, (x, v))


def rain_in_a_cart(draw: Random) -> Case:
    """A cart in rain that falls straight down, with linear drag: a power of the mass."""
    m, rate, v, b, until = (draw.uniform(*r) for r in ((1, 3), (0.1, 2), (2, 8), (0.1, 2), (1, 5)))
    grown, p = 1 + mp.mpf(rate) * until / m, 1 + mp.mpf(b) / rate
    x = v * m / mp.mpf(rate) * (1 - grown ** (1 - p)) / (p - 1)
    true = x, v * grown**-p
    return one("rain in a cart", m, 0.0, v, (Absorption(0, (0.0,), rate), Drag(0, linear=b)), until, true)


def parachutist(draw: Random) -> Case:
    """Quadratic drag for far longer than the speed takes to become steady."""
    m, c, until = draw.uniform(0.5, 80), draw.uniform(0.02, 0.5), draw.uniform(5, 60)
    vt = mp.sqrt(m * mp.mpf(G) / c)
    true = -(vt**2) / mp.mpf(G) * mp.log(mp.cosh(G * until / vt)), -vt * mp.tanh(G * until / vt)
    return one("parachutist", m, 0.0, 0.0, (Weight(G), Drag(0, quadratic=c)), until, true)


def up_and_down_in_air(draw: Random) -> Case:
    """Thrown up with quadratic drag and back: an angle's tangent, then a hyperbolic one."""
    m, c, v = draw.uniform(0.1, 1), draw.uniform(0.005, 0.1), draw.uniform(5, 30)
    g = mp.mpf(G)
    vt = mp.sqrt(m * g / c)
    rise, top = vt / g * mp.atan(v / vt), vt**2 / (2 * g) * mp.log1p((v / vt) ** 2)
    until = float(rise) * draw.uniform(1.1, 2.5)
    fall = until - rise
    true = top - vt**2 / g * mp.log(mp.cosh(g * fall / vt)), -vt * mp.tanh(g * fall / vt)
    return one("up and down in air", m, 0.0, v, (Weight(G), Drag(0, quadratic=c)), until, true)


def morse(draw: Random) -> Case:
    """A vibrating molecule in Morse's potential, many times."""
    depth, a, m, share = (
        draw.uniform(1, 5),
        draw.uniform(0.5, 2),
        draw.uniform(0.2, 2),
        draw.uniform(0.05, 0.7),
    )

    def force(t: float, x: Any, v: Any) -> tuple[float]:
        e = math.exp(-a * x[0])
        return (-2.0 * depth * a * e * (1.0 - e),)

    # Started at the outer turn, e^(a x) = (1 + sqrt(E/D) cos w t)/(1 - E/D).
    root = mp.sqrt(share)
    start = float(mp.log((1 + root) / (1 - mp.mpf(share))) / a)
    energy = (1 - mp.exp(-a * mp.mpf(start))) ** 2
    root = mp.sqrt(energy)
    w = a * mp.sqrt(2 * depth * (1 - energy) / mp.mpf(m))
    until = draw.uniform(5, 30)
    grown = (1 + root * mp.cos(w * until)) / (1 - energy)
    true = mp.log(grown) / a, -root * w * mp.sin(w * until) / (1 - energy) / grown / a
    law = ForceFunction(0, force, energy=lambda x: depth * (1.0 - math.exp(-a * x[0])) ** 2)
    return one("Morse", m, start, 0.0, (law,), until, true)


def quartic(draw: Random) -> Case:
    """A force with the cube of the way, dozens of swings: Jacobi's elliptic cosine."""
    k, m, a, until = draw.uniform(2, 20), draw.uniform(0.2, 2), draw.uniform(0.3, 1.5), draw.uniform(5, 40)
    w = math.sqrt(k / m) * a
    with mp.workdps(30):
        u = mp.mpf(a) * mp.sqrt(mp.mpf(k) / m) * until
        sn, cn, dn = (mp.ellipfun(name, u, m=mp.mpf(1) / 2) for name in ("sn", "cn", "dn"))
        true = a * cn, -a * mp.mpf(w) * sn * dn
    law = ForceFunction(0, lambda t, x, v: (-k * x[0] ** 3,), energy=lambda x: k * x[0] ** 4 / 4)
    return one("quartic", m, a, 0.0, (law,), until, true)


def resonance(draw: Random) -> Case:
    """A spring driven at its own frequency grows without end."""
    m, k, f, until = draw.uniform(0.5, 2), draw.uniform(5, 50), draw.uniform(0.2, 2), draw.uniform(10, 40)
    beat = math.sqrt(k / m)
    with mp.workdps(50):
        # Off by the rounding of the frequency, and what is left of it is divided by.
        w, own = mp.mpf(beat), mp.sqrt(mp.mpf(k) / m)
        a = mp.mpf(f) / m / (own**2 - w**2)
        place = a * (mp.cos(w * until) - mp.cos(own * until))
        true = place, a * (own * mp.sin(own * until) - w * mp.sin(w * until))
    law = ForceFunction(0, lambda t, x, v: (-k * x[0] + f * math.cos(beat * t),))
    return one("resonance", m, 0.0, 0.0, (law,), until, true)


def stiff_and_slack(draw: Random) -> Case:
    """Two masses on springs whose ratio is a million: exponential of the matrix."""
    heavy, light = draw.uniform(1, 5), draw.uniform(1, 5) * 10.0 ** draw.uniform(-4, -2)
    k, between, x, y = (
        draw.uniform(5, 50),
        draw.uniform(20, 200),
        draw.uniform(-0.3, 0.3),
        draw.uniform(-0.3, 0.3),
    )
    until = draw.uniform(0.5, 3)
    with mp.workdps(40):
        law = mp.matrix(
            [
                [0, 0, 1, 0],
                [0, 0, 0, 1],
                [-(mp.mpf(k) + between) / heavy, mp.mpf(between) / heavy, 0, 0],
                [mp.mpf(between) / light, -mp.mpf(between) / light, 0, 0],
            ]
        )
        end = mp.expm(law * until) * mp.matrix([mp.mpf(1) + x - 1, mp.mpf(2) + y - 2, 0, 0])
    bodies = Body(math.inf, (0.0,), (0.0,)), Body(heavy, (1.0 + x,), (0.0,)), Body(light, (2.0 + y,), (0.0,))
    scene = Scene(bodies, (Spring((0, 1), k, length=1.0), Spring((1, 2), between, length=1.0)), until=until)
    truth = {V: (0.0, float(end[2]), float(end[3])), X: (0.0, float(1 + end[0]), float(2 + end[1]))}
    return Case("stiff and slack", scene, truth, (until,))


def creeping(draw: Random) -> Case:
    """A spring with a damper far above the critical one: two exponentials, one a thousand times slower."""
    m, k = draw.uniform(0.2, 2), draw.uniform(5, 50)
    eta = 2 * math.sqrt(k * m) * draw.uniform(2, 40)
    until, a = draw.uniform(0.5, 5), draw.uniform(0.2, 0.8)
    with mp.workdps(30):
        x = mp.mpf(1.0 + a) - 1
        half, room = mp.mpf(eta) / (2 * m), mp.sqrt((mp.mpf(eta) / (2 * m)) ** 2 - mp.mpf(k) / m)
        slow, fast = -half + room, -half - room
        p, q = x * fast / (fast - slow), -x * slow / (fast - slow)
        place = p * mp.exp(slow * until) + q * mp.exp(fast * until)
        speed = p * slow * mp.exp(slow * until) + q * fast * mp.exp(fast * until)
    bodies = Body(math.inf, (0.0,), (0.0,)), Body(m, (1.0 + a,), (0.0,))
    scene = Scene(bodies, (Spring((0, 1), k, length=1.0, damping=eta),), until=until)
    return Case("creeping", scene, {V: (0.0, float(speed)), X: (0.0, float(1 + place))}, (until,))


def plunge(draw: Random) -> Case:
    """Two bodies let go far apart fall toward each other: a cycloid; masses over six powers of ten."""
    a, b, c, r = (
        10.0 ** draw.uniform(-3, 3),
        10.0 ** draw.uniform(-3, 3),
        draw.uniform(1, 10),
        draw.uniform(1, 3),
    )
    mass = mp.mpf(a) * b / (mp.mpf(a) + b)
    turn = mp.mpf(draw.uniform(0.5, 2.4))
    unit = mp.sqrt(mass * mp.mpf(r) ** 3 / (8 * mp.mpf(c)))
    until = float(unit * (turn + mp.sin(turn)))
    turn = mp.findroot(lambda u: unit * (u + mp.sin(u)) - until, turn)
    near = r * (1 + mp.cos(turn)) / 2
    speed = mp.sqrt(2 * mp.mpf(c) / mass * (1 / near - 1 / mp.mpf(r)))
    va, vb = b / (mp.mpf(a) + b) * speed, -a / (mp.mpf(a) + b) * speed
    centre = b * mp.mpf(r) / (mp.mpf(a) + b)
    places = centre - b * near / (mp.mpf(a) + b), centre + a * near / (mp.mpf(a) + b)
    scene = Scene((Body(a, (0.0,), (0.0,)), Body(b, (r,), (0.0,))), (InverseSquare((0, 1), c),), until=until)
    return Case("plunge", scene, {V: (float(va), float(vb)), X: tuple(map(float, places))}, (until,))


def rubbed_home(draw: Random) -> Case:
    """A block on a spring up an incline's line with weight, rubbed by the table's friction, dozens of half swings until it sticks."""
    k, m, mu, a = (
        draw.uniform(50, 200),
        draw.uniform(0.5, 2),
        draw.uniform(0.01, 0.05),
        draw.uniform(0.4, 0.9),
    )
    down = draw.uniform(0.5, 4)
    with mp.workdps(30):
        shift, rub = mp.mpf(m) * down / k, mp.mpf(mu) * m * mp.mpf(G) / k
        x, way = mp.mpf(1.0 + a) - 1 + shift, -1  # about where the spring carries the weight
        turns = 0
        while abs(x) > rub:
            x, way, turns = -x + (2 * rub if x > 0 else -2 * rub), -way, turns + 1
        place = 1 + x - shift
    until = float((turns + 1) * mp.pi * mp.sqrt(mp.mpf(m) / k))
    bodies = Body(math.inf, (0.0,), (0.0,)), Body(m, (1.0 + a,), (0.0,))
    push = ForceFunction(1, lambda t, x, v: (-m * down,))
    scene = Scene(bodies, (Spring((0, 1), k, length=1.0), push, Friction(1, mu, G)), until=until)
    return Case("rubbed home", scene, {V: (0.0, 0.0), X: (0.0, float(place))}, (until,))


def stopped_by_two(draw: Random) -> Case:
    """Friction and linear drag bring a block to rest at a time that is a logarithm."""
    m, mu, b, v = draw.uniform(0.2, 3), draw.uniform(0.05, 0.5), draw.uniform(0.1, 5), draw.uniform(1, 10)
    rub = mp.mpf(mu) * m * mp.mpf(G)
    lasts = m / mp.mpf(b) * mp.log1p(b * mp.mpf(v) / rub)
    x = m / mp.mpf(b) * v - rub / b * lasts
    until = float(lasts) * draw.uniform(1.2, 2)
    return one("stopped by two", m, 0.0, v, (Friction(0, mu, G), Drag(0, linear=b)), until, (x, 0.0))


def separatrix(draw: Random) -> Case:
    """A particle on a periodic hill, with hardly enough to come over it: the amplitude of Jacobi's functions."""
    c, until, less = draw.uniform(1, 5), draw.uniform(3, 12), 10.0 ** draw.uniform(-5, -1)
    # x'' = -c sin x, let go at rest below the top by so little.
    start = math.pi - less
    with mp.workdps(40):
        k = mp.sin(mp.mpf(start) / 2)
        u = mp.ellipk(k * k) - mp.sqrt(mp.mpf(c)) * until
        sn, cn = (mp.ellipfun(name, u, m=k * k) for name in ("sn", "cn"))
        place, speed = 2 * mp.asin(k * sn), -2 * k * mp.sqrt(mp.mpf(c)) * cn
    law = ForceFunction(0, lambda t, x, v: (-c * math.sin(x[0]),), energy=lambda x: c * (1 - math.cos(x[0])))
    return one("separatrix", 1.0, start, 0.0, (law,), until, (place, speed))


FAMILIES = (
    to_and_fro,
    tired_between_walls,
    nearly_zeno,
    heavy_meets_light,
    relay,
    rocket_in_syrup,
    rain_in_a_cart,
    parachutist,
    up_and_down_in_air,
    morse,
    quartic,
    resonance,
    stiff_and_slack,
    creeping,
    plunge,
    rubbed_home,
    stopped_by_two,
    separatrix,
)
