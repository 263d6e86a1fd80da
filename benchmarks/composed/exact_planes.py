"""Families in a plane whose outcome is a closed form: spin, wedges, orbits, fields of one's own, strings, walls that move."""

from __future__ import annotations

import math
from random import Random
from typing import Any

from mpmath import mp

from corollary.scenes.forces.bonds import Rod, Spring, String
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, InverseSquare, Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Force, Scene

from .case import Case

V, X, S = Observable.VELOCITIES, Observable.TRAJECTORY, Observable.SPINS
G = 9.8


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


def one(name: str, body: Body, forces: tuple[Force, ...], until: float, place: Any, velocity: Any) -> Case:
    """One body; its place and velocity at the end."""
    truth = {V: tuple(map(float, velocity)), X: tuple(map(float, place))}
    return Case(name, Scene((body,), forces, until=until), truth, (until,))


def slowed_in_a_field(draw: Random) -> Case:
    """A charge in a magnetic field with linear drag winds up: an exponential of a complex number."""
    m, turn, b, until = draw.uniform(0.5, 2), draw.uniform(1, 20), draw.uniform(0.05, 1), draw.uniform(2, 20)
    v = draw.uniform(1, 5), draw.uniform(-3, 3)
    rate = mp.mpc(-mp.mpf(b) / m, -mp.mpf(turn) / m)
    grown = mp.exp(rate * until)
    u = mp.mpc(*v) * grown
    z = mp.mpc(*v) * (grown - 1) / rate
    law = ForceFunction(0, lambda t, x, w: (turn * w[1], -turn * w[0]))
    body = Body(m, (0.0, 0.0), v)
    return one("slowed in a field", body, (law, Drag(0, linear=b)), until, (z.real, z.imag), (u.real, u.imag))


def on_a_carousel(draw: Random) -> Case:
    """What flies straight, seen from a turning frame: centrifugal and Coriolis forces."""
    m, w, until = draw.uniform(0.2, 2), draw.uniform(0.5, 4), draw.uniform(1, 8)
    x, v = (draw.uniform(0.5, 2), draw.uniform(-1, 1)), (draw.uniform(-2, 2), draw.uniform(-2, 2))

    def force(t: float, y: Any, u: Any) -> tuple[float, float]:
        return m * (w * w * y[0] + 2.0 * w * u[1]), m * (w * w * y[1] - 2.0 * w * u[0])

    turn = mp.expj(-mp.mpf(w) * until)
    start, speed = mp.mpc(*x), mp.mpc(*v) + mp.mpc(0, w) * mp.mpc(*x)
    z = (start + speed * until) * turn
    u = speed * turn - mp.mpc(0, w) * z
    body = Body(m, x, v)
    return one("on a carousel", body, (ForceFunction(0, force),), until, (z.real, z.imag), (u.real, u.imag))


def two_springs_and_a_wall(draw: Random) -> Case:
    """A force that is stiffer across than along, and a mirror through the middle: two swings, one folded."""
    m, k, stiff, until = draw.uniform(0.5, 2), draw.uniform(5, 50), draw.uniform(50, 500), draw.uniform(5, 25)
    x, y, v = draw.uniform(0.2, 1), draw.uniform(-1, 1), draw.uniform(-2, 2)
    with mp.workdps(30):
        p, q = mp.sqrt(mp.mpf(k) / m), mp.sqrt(mp.mpf(stiff) / m)
        across, rate = x * mp.cos(p * until), -x * p * mp.sin(p * until)
        if across < 0:
            across, rate = -across, -rate
        along = y * mp.cos(q * until) + v / q * mp.sin(q * until)
        speed = -y * q * mp.sin(q * until) + v * mp.cos(q * until)
    law = ForceFunction(
        0,
        lambda t, z, u: (-k * z[0], -stiff * z[1]),
        energy=lambda z: (k * z[0] ** 2 + stiff * z[1] ** 2) / 2,
    )
    body = Body(m, (x, y), (0.0, v))
    return one(
        "two springs and a wall", body, (law, HardWall((1.0, 0.0))), until, (across, along), (rate, speed)
    )


def court(draw: Random) -> Case:
    """A ball between two upright walls over a floor, all elastic: both motions go on by themselves."""
    wide, h, until = draw.uniform(0.5, 2), draw.uniform(0.3, 2), draw.uniform(5, 15)
    v, x = draw.uniform(1, 6), draw.uniform(0.1, 0.4)
    with mp.workdps(30):
        way = (mp.mpf(x) + mp.mpf(v) * until) % (2 * mp.mpf(wide))
        back = way > wide
        period = 2 * mp.sqrt(2 * mp.mpf(h) / G)
        t = (mp.mpf(until) + period / 2) % period
        rise = G * period / 2
        y, u = rise * t - G * t * t / 2, rise - G * t
    walls = HardWall((1.0, 0.0)), HardWall((-1.0, 0.0), -wide), HardWall((0.0, 1.0))
    place = (2 * wide - way if back else way), y
    return one(
        "court", Body(0.4, (x, h), (v, 0.0)), (*walls, Weight(G)), until, place, ((-v if back else v), u)
    )


def windy_landing(draw: Random) -> Case:
    """Thrown with linear drag in a wind onto a slope that gives back a share: two flights of exponentials."""
    m, b, wind = draw.uniform(0.2, 1), draw.uniform(0.05, 0.5), (draw.uniform(-3, 3), draw.uniform(-1, 1))
    v, tilt, e = (draw.uniform(2, 8), draw.uniform(3, 8)), draw.uniform(-0.3, 0.3), draw.uniform(0.4, 1)
    with mp.workdps(30):
        s, c, lag = mp.sin(tilt), mp.cos(tilt), mp.mpf(m) / b
        n = float(s), float(c)
        n = mp.mpf(n[0]), mp.mpf(n[1])
        drift = wind[0], wind[1] - lag * mp.mpf(G)

        def flown(x: Any, u: Any, t: Any) -> tuple[list[Any], list[Any]]:
            fade = mp.exp(-t / lag)
            return (
                [a + d * t + (w - d) * lag * (1 - fade) for a, w, d in zip(x, u, drift, strict=True)],
                [d + (w - d) * fade for w, d in zip(u, drift, strict=True)],
            )

        start = [mp.mpf(0), mp.mpf(1)]

        def gap(t: Any) -> Any:
            x, _ = flown(start, v, t)
            return x[0] * n[0] + x[1] * n[1]

        hit = met(gap, mp.mpf(0), mp.mpf(6))
        x, u = flown(start, v, hit)
        into = (u[0] * n[0] + u[1] * n[1]) / (n[0] ** 2 + n[1] ** 2)
        u = [w - (1 + mp.mpf(e)) * into * k for w, k in zip(u, n, strict=True)]
        until = float(hit) + 0.05 + 0.05 * float(-into) / G
        x, u = flown(x, u, mp.mpf(until) - hit)
    slope = HardWall((float(n[0]), float(n[1])), restitution=e)
    body = Body(m, (0.0, 1.0), v)
    return one("windy landing", body, (Weight(G), Drag(0, linear=b, wind=wind), slope), until, x, u)


def comet(draw: Random) -> Case:
    """A comet with an excentricity of nearly one, followed past its star several times; the star moves, too."""
    a, b, c = 10.0 ** draw.uniform(-1, 6), draw.uniform(0.5, 2), draw.uniform(1, 10)
    e = 1.0 - 10.0 ** draw.uniform(-3, -1)
    with mp.workdps(40):
        mass = mp.mpf(a) * b / (mp.mpf(a) + b)
        # Let go at its farthest, with the speed that this excentricity takes, rounded.
        far, v = mp.mpf(2), float(mp.sqrt(c / mass * (1 - mp.mpf(e)) / 2))
        energy = mass * mp.mpf(v) ** 2 / 2 - c / far
        axis = -c / (2 * energy)
        e = far / axis - 1
        beat = mp.sqrt(c / mass / axis**3)
        until = float(draw.uniform(0.2, 3.3) * 2 * mp.pi / beat)
        mean = beat * until + mp.pi
        whole = 2 * mp.pi * mp.floor(mean / (2 * mp.pi))
        u = mean - whole
        u = mp.findroot(
            lambda u: u - e * mp.sin(u) - (mean - whole), (mp.mpf(0), 2 * mp.pi), solver="anderson"
        )
        near, flat = axis * (1 - e * mp.cos(u)), mp.sqrt(1 - e * e)
        x, y = -axis * (mp.cos(u) - e), -axis * flat * mp.sin(u)
        rate = beat * axis / near
        w = rate * axis * mp.sin(u), -rate * axis * flat * mp.cos(u)
        star, small = -b / (mp.mpf(a) + b), a / (mp.mpf(a) + b)
        centre = small * 0 + b / (mp.mpf(a) + b) * far, b / (mp.mpf(a) + b) * mp.mpf(v)
        places = (
            centre[0] + star * x,
            centre[1] * until + star * y,
            centre[0] + small * x,
            centre[1] * until + small * y,
        )
        speeds = (star * w[0], centre[1] + star * w[1], small * w[0], centre[1] + small * w[1])
    bodies = Body(a, (0.0, 0.0), (0.0, 0.0)), Body(b, (2.0, 0.0), (0.0, v))
    scene = Scene(bodies, (InverseSquare((0, 1), c),), until=until)
    return Case("comet", scene, {V: tuple(map(float, speeds)), X: tuple(map(float, places))}, (until,))


def drawn_ball(draw: Random) -> Case:
    """A ball hit with so much backspin that it slides, stops, and rolls back: 5/7 v - 2/7 r w."""
    r, mu, v = draw.uniform(0.03, 0.1), draw.uniform(0.1, 0.5), draw.uniform(0.5, 3)
    w = v / r * draw.uniform(3, 6)  # counter-clockwise is backspin of what goes right
    end = 5 * v / 7 - 2 * r * w / 7
    lasts = (v - end) / (mu * G)
    until = lasts * draw.uniform(1.1, 2)
    x = v * lasts - mu * G * lasts**2 / 2 + end * (until - lasts)
    body = Body(0.3, (0.0, r), (v, 0.0), r, spin=w)
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=mu)
    truth = {V: (end, 0.0), X: (x, r), S: (-end / r,)}
    return Case("drawn ball", Scene((body,), (Weight(G), floor), until=until), truth, (until,))


def set_down_spinning(draw: Random) -> Case:
    """A hoop, a disc, a sphere set down spinning: what it rolls with depends on its inertia alone."""
    r, m, mu, w = draw.uniform(0.05, 0.3), draw.uniform(0.2, 2), draw.uniform(0.1, 0.5), draw.uniform(10, 60)
    share = draw.choice([1.0, 0.5, 0.4])
    end = share / (1 + share) * r * w
    lasts = end / (mu * G)
    until = lasts * draw.uniform(1.1, 2)
    x = end * lasts / 2 + end * (until - lasts)
    body = Body(m, (0.0, r), (0.0, 0.0), r, spin=-w, inertia=share * m * r * r)
    floor = HardWall((0.0, 1.0), restitution=0.0, mu=mu)
    truth = {V: (end, 0.0), X: (x, r), S: (-end / r,)}
    return Case("set down spinning", Scene((body,), (Weight(G), floor), until=until), truth, (until,))


def rolled_up_and_back(draw: Random) -> Case:
    """A sphere rolls up a slope and back without slipping, at 5/7 of what a block would lose."""
    tilt, r, v, m = draw.uniform(0.1, 0.4), draw.uniform(0.05, 0.2), draw.uniform(1, 4), draw.uniform(0.2, 2)
    s, c = math.sin(tilt), math.cos(tilt)
    lose = 5 * G * s / 7
    until = 2 * v / lose * draw.uniform(0.3, 1.3)
    way, speed = v * until - lose * until**2 / 2, v - lose * until
    # Uphill is (c, s); rolling so turns clockwise.
    slope = HardWall((-s, c), restitution=0.0, mu=math.tan(tilt))
    body = Body(m, (-s * r, c * r), (v * c, v * s), r, spin=-v / r)
    truth = {
        V: (speed * c, speed * s),
        X: (-s * r + way * c, c * r + way * s),
        S: (-speed / r,),
    }
    return Case("rolled up and back", Scene((body,), (Weight(G), slope), until=until), truth, (until,))


def nearly_upright(draw: Random) -> Case:
    """A pendulum let go hardly off its highest point, through its lowest and up again."""
    length, less, until = draw.uniform(0.3, 2), 10.0 ** draw.uniform(-4, -1), draw.uniform(2, 8)
    start = math.pi - less
    bob = length * math.sin(start), -length * math.cos(start)
    with mp.workdps(40):
        angle, length_ = mp.atan2(mp.mpf(bob[0]), -mp.mpf(bob[1])), mp.hypot(*map(mp.mpf, bob))
        k = mp.sin(angle / 2)
        beat = mp.sqrt(mp.mpf(G) / length_)
        u = mp.ellipk(k * k) - beat * until
        sn, cn = (mp.ellipfun(name, u, m=k * k) for name in ("sn", "cn"))
        swing, rate = 2 * mp.asin(k * sn), -2 * k * beat * cn
        place = length_ * mp.sin(swing), -length_ * mp.cos(swing)
        speed = length_ * rate * mp.cos(swing), length_ * rate * mp.sin(swing)
    nail = Body(math.inf, (0.0, 0.0), (0.0, 0.0))
    scene = Scene((nail, Body(0.3, bob, (0.0, 0.0))), (Rod((0, 1)), Weight(G)), until=until)
    truth = {V: (0.0, 0.0, *map(float, speed)), X: (0.0, 0.0, *map(float, place))}
    return Case("nearly upright", scene, truth, (until,))


def unequal_dumbbell(draw: Random) -> Case:
    """A rod with masses over six powers of ten, thrown spinning: a parabola and a steady turn."""
    a, b, length = 10.0 ** draw.uniform(-3, 3), 10.0 ** draw.uniform(-3, 3), draw.uniform(0.3, 2)
    w, v, until = draw.uniform(-10, 10), (draw.uniform(-3, 3), draw.uniform(0, 5)), draw.uniform(1, 10)
    share = mp.mpf(b) / (mp.mpf(a) + b)
    turn = mp.expj(mp.mpf(w) * until)
    centre = share * length + v[0] * mp.mpf(until), v[1] * mp.mpf(until) - G * mp.mpf(until) ** 2 / 2
    truth_x: list[float] = []
    truth_v: list[float] = []
    starts: list[tuple[float, float]] = []
    for arm in (-share * length, (1 - share) * length):
        starts.append((v[0], float(v[1] + arm * w)))
        truth_x += [float(centre[0] + arm * turn.real), float(centre[1] + arm * turn.imag)]
        truth_v += [float(v[0] - arm * w * turn.imag), float(v[1] - G * until + arm * w * turn.real)]
    bodies = Body(a, (0.0, 0.0), starts[0]), Body(b, (length, 0.0), starts[1])
    scene = Scene(bodies, (Rod((0, 1)), Weight(G)), until=until)
    return Case("unequal dumbbell", scene, {V: tuple(truth_v), X: tuple(truth_x)}, (until,))


def flung_on_a_string(draw: Random) -> Case:
    """A puck flung past another it is tied to: the string jerks taut, and they turn about each other."""
    a, b, length, aside = (
        draw.uniform(0.2, 2),
        draw.uniform(0.2, 2),
        draw.uniform(0.8, 1.5),
        draw.uniform(0.1, 0.5),
    )
    v = draw.uniform(1, 4)
    with mp.workdps(30):
        run = mp.sqrt(mp.mpf(length) ** 2 - mp.mpf(aside) ** 2)
        taut = (run + mp.mpf("0.2")) / v
        n = run / length, mp.mpf(aside) / length
        along = v * n[0]
        jerk = mp.mpf(a) * b / (mp.mpf(a) + b) * along
        va = [jerk / a * n[0], jerk / a * n[1]]
        vb = [v - jerk / b * n[0], -jerk / b * n[1]]
        share = mp.mpf(b) / (mp.mpf(a) + b)
        mean = [(1 - share) * p + share * q for p, q in zip(va, vb, strict=True)]
        w = (n[0] * (vb[1] - va[1]) - n[1] * (vb[0] - va[0])) / length
        until = float(taut) + draw.uniform(0.3, 4)
        left = until - taut
        turn = mp.mpc(*n) * mp.expj(w * left)
        at = [share * run + mean[0] * left, share * mp.mpf(aside) + mean[1] * left]
        truth_x: list[float] = []
        truth_v: list[float] = []
        for arm in (-share * length, (1 - share) * length):
            truth_x += [float(at[0] + arm * turn.real), float(at[1] + arm * turn.imag)]
            truth_v += [float(mean[0] - arm * w * turn.imag), float(mean[1] + arm * w * turn.real)]
    bodies = Body(a, (0.0, 0.0), (0.0, 0.0)), Body(b, (-0.2, aside), (v, 0.0))
    scene = Scene(bodies, (String((0, 1), length),), until=until)
    return Case("flung on a string", scene, {V: tuple(truth_v), X: tuple(truth_x)}, (until,))


def around_a_spring(draw: Random) -> Case:
    """A puck on a spring without length goes round an ellipse, a hundred times; the other end is a body, too."""
    a, b, k, until = draw.uniform(0.2, 5), draw.uniform(0.2, 5), draw.uniform(50, 500), draw.uniform(10, 40)
    x, v = (draw.uniform(0.5, 1), draw.uniform(-1, 1)), (draw.uniform(-3, 3), draw.uniform(-3, 3))
    with mp.workdps(30):
        total = mp.mpf(a) + b
        beat = mp.sqrt(k * total / (mp.mpf(a) * b))
        c, s = mp.cos(beat * until), mp.sin(beat * until)
        truth_x: list[float] = []
        truth_v: list[float] = []
        for share, sign in ((b / total, -1), (a / total, 1)):
            for p, u in zip(x, v, strict=True):
                centre, drift = b / total * mp.mpf(p), b / total * mp.mpf(u)
                apart, rate = p * c + u / beat * s, u * c - p * beat * s
                truth_x.append(float(centre + drift * until + sign * share * apart))
                truth_v.append(float(drift + sign * share * rate))
    bodies = Body(a, (0.0, 0.0), (0.0, 0.0)), Body(b, x, v)
    scene = Scene(bodies, (Spring((0, 1), k),), until=until)
    return Case("around a spring", scene, {V: tuple(truth_v), X: tuple(truth_x)}, (until,))


FAMILIES = (
    slowed_in_a_field,
    on_a_carousel,
    two_springs_and_a_wall,
    court,
    windy_landing,
    comet,
    drawn_ball,
    set_down_spinning,
    rolled_up_and_back,
    nearly_upright,
    unequal_dumbbell,
    flung_on_a_string,
    around_a_spring,
)
