"""The ready-made scenes that are motions, put on film with the numbers they were played with."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from corollary.scenes.catalogue import SCENES
from corollary.scenes.definition import Settings, numbers, one, row, settle, vector
from corollary.scenes.film import BLOCK, NAIL, Act, Film, film
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.forces.inverse_square import InverseSquare
from corollary.scenes.forces.rod import Rod
from corollary.scenes.forces.spring import catching
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.scene import Body, Scene

QUARTER = 1.8540746773013719  # a swing from the horizontal to the bottom, in sqrt(L/g): the complete elliptic integral K(1/2)
AGAIN = 1.1  # how much longer the time after a hit is watched than the time before


def film_of(scene: str | Scene, settings: Mapping[str, object]) -> Film | None:
    """A run of a ready-made scene by its name, or of a composed one that names its end; none for what is no motion, or has no end.

    Raises BadSetting and GuardFailed as playing it does.
    """
    if isinstance(scene, Scene):
        return film(scene.bodies, [(scene.forces, scene.until)]) if scene.until is not None else None
    if scene not in FILMS:
        return None
    settled = settle(scene, SCENES[scene].settings, settings)
    # Who did not ask for friction does not see any.
    smooth = {"mu": 0.0} if "mu" in settled and "mu" not in settings else {}
    return FILMS[scene]({**settled, **smooth})


def spheres(settings: Settings) -> Film | None:
    ma, mb, reach, k, q, eta, dx, dy = numbers(settings, "mA", "mB", "R", "k", "q", "eta", "dx", "dy")
    va, vb, apart = vector(settings, "vA"), vector(settings, "vB"), (dx, dy)
    relative = vb[0] - va[0], vb[1] - va[1]
    speed = math.hypot(*relative)
    nearest = -(apart[0] * relative[0] + apart[1] * relative[1]) / speed**2 if speed else 0.0
    if nearest <= 0.0:
        return None
    a, b = Body(ma, (0.0, 0.0), va, reach, "A"), Body(mb, apart, vb, reach, "B")
    return film((a, b), [((Contact(k, q, eta),), (1.0 + AGAIN) * nearest)])


def cradle(settings: Settings) -> Film:
    count, coming = round(one(settings, "N")), round(one(settings, "balls_in"))
    q, k, v0 = numbers(settings, "q", "k", "v0")
    masses = row(settings, "masses", count, "balls") if settings["masses"] else (one(settings, "m"),) * count
    gaps = row(settings, "gaps", count - 1, "gaps")
    soft = (max(masses) * v0 / k * v0) ** (1.0 / (q + 1.0))
    radius = max(0.02, 10.0 * soft)
    way, bodies = 6.0 * radius, list[Body]()
    place = 0.0
    for i, mass in enumerate(masses):
        place += (2.0 * radius + (max(gaps[i - 1], way) if i == coming else gaps[i - 1])) if i else 0.0
        bodies.append(Body(mass, (place,), (v0 if i < coming else 0.0,), radius, chr(ord("A") + i)))
    long = (way + math.fsum(gaps[coming:])) / v0
    return film(bodies, [((Contact(k, q),), (1.0 + AGAIN) * long)])


def kick(settings: Settings) -> Film:
    m, v0, force, dt, pulse = numbers(settings, "m", "v0", "F", "dt", "pulse")
    power = round(pulse)
    peak = force * math.sqrt(math.pi) * math.gamma(power / 2 + 1) / math.gamma((power + 1) / 2)
    push = ForceFunction(0, lambda t, x, v: (peak * math.sin(math.pi * min(t / dt, 1.0)) ** power,))
    fastest = max(abs(v0), abs(v0 + force * dt / m))
    free = 2.0 * dt
    ball = Body(m, (0.0,), (v0,), name="A")
    return film((ball,), [((), free), ((push,), dt), ((), free)], radii=(0.2 * fastest * dt,))


def wall(settings: Settings) -> Film:
    m, v0, theta, dt = numbers(settings, "m", "v0", "theta", "dt")
    k, free, radius = m * (math.pi / dt) ** 2, 4.0 * dt, 0.3 * v0 * dt
    along, into = v0 * math.cos(theta), v0 * math.sin(theta)
    spring = ForceFunction(0, lambda t, x, v: (0.0, -k * x[1]))
    ball = Body(m, (-along * free, into * free), (along, -into), name="A")
    edge = 1.5 * (along * free + radius)
    floor = ((-edge, -radius), (edge, -radius))
    return film((ball,), [((), free), ((spring,), dt), ((), free)], radii=(radius,), lines=(floor,))


def bullet_block(settings: Settings) -> Film:
    m, block, v, mu, g, dt = numbers(settings, "m", "M", "v", "mu", "g", "dt")
    common = m * v / (m + block)
    slides = common / (mu * g) if mu else 1.0
    way = common * slides
    bodies = Body(m, (-way,), (v,), name="A"), Body(block, (0.0,), (0.0,), name=BLOCK)
    stops: Act = ((Friction(0, mu, g), Friction(1, mu, g)) if mu else (), 1.05 * slides)
    acts: list[Act] = [((), way / v), ((catching(m, block, dt),), dt), stops]
    return film(bodies, acts, radii=(0.04 * way, 0.16 * way))


def absorbed_drop(settings: Settings) -> Film | None:
    m, drop, v, u = numbers(settings, "m", "dm", "v", "u")
    if v <= u:
        return None
    dt = 0.01
    bodies = Body(m, (0.0,), (v,), name="A"), Body(drop, (v - u,), (u,), name="B")
    radii = (0.12 * (v - u), 0.07 * (v - u))
    touch = 1.0 - (radii[0] + radii[1]) / (v - u)
    return film(bodies, [((), touch), ((catching(m, drop, dt),), dt), ((), AGAIN)], radii=radii)


def snowball(settings: Settings) -> Film:
    you, son, ball, v, theta, dt = numbers(settings, "M", "Ms", "m", "v", "theta", "dt")
    level = v * math.cos(theta)
    push = ball * level / dt
    way = 10.0 * level * dt
    bodies = (
        Body(ball, (0.0,), (0.0,), name="C"),
        Body(son, (way,), (0.0,), name="B"),
        Body(you, (-0.06 * way,), (0.0,), name="A"),
    )
    thrown = ForceFunction(0, lambda t, x, w: (push,)), ForceFunction(2, lambda t, x, w: (-push,))
    flight = 0.92 * way / level
    catch = (catching(ball, son, dt),)
    acts: list[Act] = [((), dt), (thrown, dt), ((), flight), (catch, dt), ((), flight)]
    return film(bodies, acts, radii=(0.02 * way, 0.05 * way, 0.06 * way))


def ball_on_floor(settings: Settings) -> Film | None:
    m, k, q, radius, y0, v0, g, eta = numbers(settings, "m", "k", "q", "R", "y0", "v0", "g", "eta")
    meets = math.sqrt(max(v0 * v0 + 2.0 * g * (y0 - radius), 0.0))
    if v0 > 0.0 or meets == 0.0:
        return None
    # It comes from four radii above at least, with what it then had.
    fallen = min(max(y0 - radius, 4.0 * radius), meets * meets / (2.0 * g) if g else math.inf)
    begins = math.sqrt(max(meets * meets - 2.0 * g * fallen, 0.0))
    takes = (meets - begins) / g if g else fallen / meets
    ball = Body(m, (radius + fallen,), (-begins,), radius, "A")
    floor = Body(math.inf, (0.0,), (0.0,), name=NAIL)
    forces = Contact(k, q, eta), *((Weight(g),) if g else ())
    edge = 2.0 * fallen
    ground = ((-edge, 0.0), (edge, 0.0))
    return film((ball, floor), [(forces, 2.0 * takes)], upright=True, lines=(ground,))


def bouncing_ball(settings: Settings) -> Film:
    h0, r, g = numbers(settings, "h0", "r", "g")
    fall = math.sqrt(2.0 * h0 / g)
    until = fall * (1.0 + 2.0 * math.fsum(r**i for i in range(1, round(one(settings, "n")) + 1)))
    forces = Weight(g), HardWall((1.0,), restitution=r)
    ball, radius = Body(1.0, (h0,), (0.0,), name="A"), 0.04 * h0
    ground = ((-h0, -radius), (h0, -radius))
    return film((ball,), [(forces, until)], radii=(radius,), upright=True, lines=(ground,))


def pendulum_block(settings: Settings) -> Film:
    m, block, length, g, k = numbers(settings, "m", "M", "L", "g", "k")
    radius = 0.08 * length
    bodies = (
        Body(math.inf, (0.0, 0.0), (0.0, 0.0), name=NAIL),
        Body(m, (-length, 0.0), (0.0, 0.0), 0.9 * radius, "A"),
        Body(block, (1.9 * radius, -length), (0.0, 0.0), radius, "B"),
    )
    floor = HardWall((0.0, 1.0), -length - radius, restitution=0.0, only=(2,))
    forces = Rod((0, 1)), Weight(g), Contact(k, chosen=((1, 2),)), floor
    edge = 2.0 * length
    ground = ((-edge, -length - radius), (edge, -length - radius))
    swing = QUARTER * math.sqrt(length / g)
    return film(bodies, [(forces, 1.7 * swing)], lines=(ground,), ropes=((0, 1),))


def ballistic_pendulum(settings: Settings) -> Film:
    bullet, block, v, length, g, dt = numbers(settings, "mA", "mB", "v", "L", "g", "dt")
    start = 0.6 * length
    bodies = (
        Body(bullet, (-start, 0.0), (v, 0.0), name="A"),
        Body(block, (0.0, 0.0), (0.0, 0.0), name=BLOCK),
        Body(math.inf, (0.0, length), (0.0, 0.0), name=NAIL),
    )
    entry = 0.9 * start
    swing = math.pi * math.sqrt(length / g)
    acts: list[Act] = [
        ((), entry / v),
        ((catching(bullet, block, dt),), dt),
        ((Rod((2, 0)), Rod((2, 1)), Weight(g)), swing),
    ]
    return film(bodies, acts, radii=(0.02 * length, 0.1 * length, 0.0), ropes=((2, 1),))


def super_ball(settings: Settings) -> Film:
    a, b, h0, g, k, q = numbers(settings, "mA", "mB", "h0", "g", "k", "q")
    big, small, apart = 0.06 * h0, 0.03 * h0, 1e-3 * h0
    bodies = (
        Body(a, (big + h0,), (0.0,), big, "A"),
        Body(b, (2.0 * big + small + h0 + apart,), (0.0,), small, "B"),
        Body(math.inf, (0.0,), (0.0,), name=NAIL),
    )
    forces = Contact(k, q, chosen=((0, 2), (0, 1))), Weight(g)
    fall = math.sqrt(2.0 * h0 / g)
    rise = (3.0 * a - b) / (a + b)
    ground = ((-2.0 * h0, 0.0), (2.0 * h0, 0.0))
    until = fall * (1.0 + max(1.0, 0.8 * rise))
    return film(bodies, [(forces, until)], upright=True, lines=(ground,))


def ions(settings: Settings) -> Film:
    strength, ma, mb, v, r0, s = numbers(settings, "C", "mA", "mB", "v", "r0", "s")
    away, total = math.sqrt((r0 - s) * (r0 + s)), ma + mb
    a = Body(ma, (-mb / total * away, -mb / total * s), (mb / total * v, 0.0), name="A")
    b = Body(mb, (ma / total * away, ma / total * s), (-ma / total * v, 0.0), name="B")
    return film((a, b), [((InverseSquare((0, 1), -strength),), 2.4 * r0 / v)], radii=(0.05 * r0, 0.05 * r0))


FILMS: dict[str, Callable[[Settings], Film | None]] = {
    each.__name__: each
    for each in (
        absorbed_drop,
        ball_on_floor,
        ballistic_pendulum,
        bouncing_ball,
        bullet_block,
        cradle,
        ions,
        kick,
        pendulum_block,
        snowball,
        spheres,
        super_ball,
        wall,
    )
}
"""By scene. The others are no motion of bodies that keep their mass, or are known at one moment only."""
