"""Scenes whose references are exact fractions, sums over every part, or forty digits of another formula than the scene's own."""

# pyright: reportUnknownArgumentType=false, reportUnknownVariableType=false, reportUnknownMemberType=false

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

import mpmath as mp

from corollary.scenes.run import Run
from ready.family import Family, Reference, powers


def long(x: float | Fraction) -> Any:
    """A number of mpmath's that is exactly this."""
    exact = Fraction(x)
    return mp.mpf(exact.numerator) / exact.denominator


def fractions(given: dict[str, Any], *names: str) -> list[Fraction]:
    return [Fraction(given[name]) for name in names]


def longs(given: dict[str, Any], *names: str) -> list[Any]:
    return [mp.mpf(given[name]) for name in names]


def two_blocks(rng: random.Random) -> dict[str, Any]:
    v = powers(rng, -100, 100)
    return {
        "mA": powers(rng, -100, 100),
        "mB": powers(rng, -100, 100),
        "vA": v,
        "vB": rng.uniform(-3.0, 0.9999) * v,
        "r": rng.choice([0.0, 1.0, rng.random()]),
    }


def of_two_blocks(given: dict[str, Any], _: Run) -> Reference:
    a, b, u, v, r = fractions(given, "mA", "mB", "vA", "vB", "r")
    impulse = (1 + r) * (u - v) * a * b / (a + b)
    return {"velocities": (u - impulse / a, v + impulse / b), "impulse": (impulse,)}


def bullet(rng: random.Random) -> dict[str, Any]:
    return {name: powers(rng, -40, 40) for name in ("m", "M", "v", "mu", "g")}


def of_bullet(given: dict[str, Any], _: Run) -> Reference:
    m, block, v, mu, g = fractions(given, "m", "M", "v", "mu", "g")
    common = m * v / (m + block)
    lost = -m * block * v * v / (2 * (m + block))
    return {"velocities": (common, common), "energy_change": (lost,), "distance": (common**2 / (2 * mu * g),)}


def kick(rng: random.Random) -> dict[str, Any]:
    given = {name: powers(rng, -20, 20) for name in ("m", "dt")}
    force, v = powers(rng, -20, 20), powers(rng, -20, 20)
    return given | {
        "F": rng.choice([-force, force]),
        "v0": rng.choice([0.0, v, -v, -force * given["dt"] / given["m"]]),
        "pulse": float(rng.randint(0, 8)),
    }


def of_kick(given: dict[str, Any], _: Run) -> Reference:
    """The mean force gives the impulse whatever its shape; a pulse that is symmetric in time, the way; Wallis' product, the peak."""
    m, v0, force, dt = fractions(given, "m", "v0", "F", "dt")
    power = int(given["pulse"])
    mean = Fraction(1)
    for even in range(power, 1, -2):
        mean *= Fraction(even - 1, even)
    peak = long(abs(force) / mean) * (mp.pi / 2 if power % 2 else 1)
    return {
        "velocities": (v0 + force * dt / m,),
        "impulse": (force * dt,),
        "way": (v0 * dt + force * dt * dt / (2 * m),),
        "peak_force": (peak,),
    }


def car(rng: random.Random) -> dict[str, Any]:
    v = powers(rng, -20, 20)
    given = {"R": powers(rng, -20, 20), "t": powers(rng, -20, 20), "v": rng.choice([-v, v])}
    return given | {
        "ux": rng.choice([0.0, rng.uniform(-2, 2), 1.0, 1.0 - 1e-15]) * v,
        "N": float(rng.randint(1, 60)),
    }


def of_car(given: dict[str, Any], _: Run) -> Reference:
    """Shovel after shovel: what it lacks of the car's momentum the pull gives, and energy is what the pull did and the sand has not."""
    v, rate, u, t = fractions(given, "v", "R", "ux", "t")
    count = int(given["N"])
    shovel, impulse, work, lost = rate * t / count, Fraction(0), Fraction(0), Fraction(0)
    for _shovel in range(count):
        given_to_it = shovel * v - shovel * u
        impulse += given_to_it
        work += given_to_it * v
        lost += given_to_it * v - (shovel * v**2 / 2 - shovel * u**2 / 2)
    return {"mean_force": (impulse / t,), "impulse": (impulse,), "work": (work,), "energy_lost": (lost,)}


def chain(rng: random.Random) -> dict[str, Any]:
    given = {name: powers(rng, -15, 15) for name in ("m", "L", "v0", "g")} | {"N": float(rng.randint(1, 200))}
    # Where the force is looked at a whole link passes by.
    link = given["L"] / given["N"]
    return given | {"y": min(given["L"], rng.randint(1, int(given["N"])) * link)}


def of_chain(given: dict[str, Any], _: Run) -> Reference:
    """Link after link: each jerks the hand when it is half lifted, and weighs from then on."""
    m, length, v, g, y = fractions(given, "m", "L", "v0", "g", "y")
    count = int(given["N"])
    link, impulse = m / count, Fraction(0)
    for i in range(count):
        at = (i + Fraction(1, 2)) * length / count
        impulse += link * v + link * g * (length - at) / v
    work = impulse * v
    # Energy the chain has when all of it hangs: links at their mean heights, moving.
    risen = sum((length - (i + Fraction(1, 2)) * length / count) for i in range(count)) * link * g
    mean = m / length * v * v + m * g * y / length
    return {
        "impulse": (impulse,),
        "work": (work,),
        "energy_lost": (work - risen - m * v * v / 2,),
        "mean_force": (mean,),
    }


def rocket(rng: random.Random) -> dict[str, Any]:
    start = powers(rng, -15, 15)
    share = rng.choice([rng.uniform(0.02, 0.98), 1.0 - powers(rng, -9, -2), powers(rng, -6, -1)])
    speed = powers(rng, -15, 15)
    return {
        "m0": start,
        "m1": start * share,
        "v_rel": speed,
        "N": float(rng.randint(1, 120)),
        "v0": rng.choice([0.0, rng.uniform(-3.0, 3.0) * speed]),
    }


def of_rocket(given: dict[str, Any], _: Run) -> Reference:
    """Puff after puff, exhaust measured from the rocket before or after it; a steady burn is a logarithm."""
    full, empty, speed, v0 = longs(given, "m0", "m1", "v_rel", "v0")
    count = int(given["N"])
    puff = (full - empty) / count
    least = most = v0
    for i in range(count):
        least += speed * puff / (full - i * puff)
        most += speed * puff / (full - (i + 1) * puff)
    return {"bracket": (least, most), "velocities": (v0 + speed * mp.log(full / empty),)}


def snowball(rng: random.Random) -> dict[str, Any]:
    given = {name: powers(rng, -15, 15) for name in ("M", "Ms", "m", "v", "dt")}
    return given | {"theta": rng.choice([0.0, rng.uniform(0.0, 1.57), powers(rng, -20, 0)])}


def of_snowball(given: dict[str, Any], _: Run) -> Reference:
    """Momentum at the throw and at the catch; the dashpot that leaves e^-40 pulls hardest at the first touch."""
    you, son, ball, v, theta, dt = longs(given, "M", "Ms", "m", "v", "theta", "dt")
    turn = mp.expj(theta)
    level, up = ball * v * turn.real, ball * v * turn.imag
    fade = 40 / (dt * (1 / ball + 1 / son))
    return {
        "momentum": (level, up),
        "velocities_after_throw": (-level / you, mp.mpf(0)),
        "velocities": (-level / you, level / (ball + son)),
        "peak_force": (max(ball * v / dt, fade * v * turn.real),),
    }


def drop(rng: random.Random) -> dict[str, Any]:
    given = {name: powers(rng, -6, 6) for name in ("m", "dm", "t")}
    given |= {name: rng.uniform(-1.0, 1.0) * powers(rng, -6, 6) for name in ("v", "u", "F")}
    return given | {"dt": given["t"] * powers(rng, -3, 3)}


def of_drop(given: dict[str, Any], _: Run) -> Reference:
    """The exponential of the matrix of the linear equations of motion, constant force included."""
    m, dm, v, u, force, t, dt = longs(given, "m", "dm", "v", "u", "F", "t", "dt")
    grip = 40 / (dt * (1 / m + 1 / dm))
    # In the centre's and the relative velocity nothing of one is lost in the other.
    system = mp.matrix([[-grip * (1 / m + 1 / dm) * t, force * t / m], [0, 0]])
    grown = mp.expm(system)
    apart = grown[0, 0] * (v - u) + grown[0, 1]
    centre = (m * v + dm * u + force * t) / (m + dm)
    return {
        "velocities": (centre + dm * apart / (m + dm), centre - m * apart / (m + dm)),
        "momentum_change": (force * t,),
        "peak_force": (grip * max(abs(v - u), abs(apart)),),
    }


def wall(rng: random.Random) -> dict[str, Any]:
    given = {name: powers(rng, -40, 40) for name in ("m", "v0", "dt")}
    return given | {"theta": rng.choice([powers(rng, -20, 0), rng.uniform(0.01, 1.57)])}


def of_wall(given: dict[str, Any], _: Run) -> Reference:
    """A spring of half the period 2 dt: its motion at the end of the contact and in the middle, by the exponential of its matrix."""
    m, v0, theta, dt = longs(given, "m", "v0", "theta", "dt")
    turn = mp.expj(theta)
    into = -v0 * turn.imag
    beat = mp.pi / dt
    moved = mp.expm(mp.matrix([[0, 1], [-(mp.pi**2), 0]]))
    away = moved[1, 1] * into
    half = mp.expm(mp.matrix([[0, mp.mpf(1) / 2], [-(mp.pi**2) / 2, 0]]))
    deep = -half[0, 1] * into * dt
    change = m * (away - into)
    return {
        "velocities": (v0 * turn.real, away),
        "momentum_change": (mp.mpf(0), change),
        "impulse": (mp.mpf(0), -change),
        "mean_force": (mp.mpf(0), change / dt),
        "peak_force": (m * beat**2 * deep,),
        "largest_overlap": (deep,),
    }


def bouncing(rng: random.Random) -> dict[str, Any]:
    r = rng.choice([rng.random(), 1.0 - powers(rng, -12, -1), powers(rng, -9, 0), 1.0, 0.0])
    return {"h0": powers(rng, -30, 30), "g": powers(rng, -30, 30), "r": r, "n": float(rng.randint(1, 40))}


def of_bouncing(given: dict[str, Any], _: Run) -> Reference:
    """Flight after flight: up, down, and a share of the speed kept. The end of all bounces: what is left of the geometric series."""
    h, g, r = longs(given, "h0", "g", "r")
    speed = mp.sqrt(2 * g * h)
    clock, heights = speed / g, []
    for bounce in range(int(given["n"])):
        clock += 2 * speed / g if bounce else 0
        speed *= r
        heights.append(speed**2 / (2 * g))
    true = {"heights": tuple(heights), "rebound_speed": (speed,), "duration": (clock,)}
    if r < 1:
        true["rests_after"] = (clock + 2 * speed / g / (1 - r),)
    return true


FAMILIES = (
    Family("two blocks, masses 1e±100", "two_blocks", "exact fractions", two_blocks, of_two_blocks),
    Family("bullet in a block, all 1e±40", "bullet_block", "exact fractions", bullet, of_bullet),
    Family("kick, all 1e±20", "kick", "exact fractions; Wallis' product", kick, of_kick),
    Family("railway car, all 1e±20", "railway_car", "exact fractions, shovel by shovel", car, of_car),
    Family("chain, all 1e±15", "chain", "exact fractions, link by link", chain, of_chain),
    Family("rocket, all 1e±15", "rocket", "puff by puff, and a logarithm, 50 digits", rocket, of_rocket),
    Family("snowball, all 1e±15", "snowball", "momentum, 60 digits", snowball, of_snowball, digits=60),
    Family("absorbed drop", "absorbed_drop", "exponential of a matrix, 80 digits", drop, of_drop, digits=80),
    Family(
        "ball at a wall, all 1e±40",
        "wall",
        "exponential of a matrix, 60 digits",
        wall,
        of_wall,
        digits=60,
        known=1e-50,
    ),
    Family(
        "bouncing ball",
        "bouncing_ball",
        "flight by flight, 60 digits",
        bouncing,
        of_bouncing,
        digits=60,
        known=1e-50,
    ),
)
