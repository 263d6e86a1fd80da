"""Contacts with damping, in rows, with weight, against steps of twice a double's length in the plane."""

# pyright: reportUnknownArgumentType=false, reportUnknownVariableType=false, reportUnknownMemberType=false

from __future__ import annotations

import math
import random
from fractions import Fraction
from typing import Any

import mpmath as mp

from corollary.scenes.run import Run, components
from ready.family import Family, Reference, powers
from ready.integrals import spheres
from ready.momentum import long
from ready.motion import Followed, followed

STEPS = "steps of 31 digits"


def sides(followed: Followed) -> tuple[Any, Any]:
    """The largest overlap and force."""
    return long(followed.overlap), mp.sqrt(long(followed.force_square))


def accuracy(found: Run) -> float:
    """A bound is as narrow as a double: it asks for more than an estimate does."""
    return 1e-22 if found.error_is == "bound" else 1e-18


def of_row(given: dict[str, Any], found: Run, near: float | None = None) -> Reference:
    """The row along the first axis of a plane; a step is off by a part `near` of the scale."""
    count, q, k = int(given["N"]), given["q"], given["k"]
    masses, v0 = given["masses"], given["v0"]
    gaps = given["gaps"] if isinstance(given["gaps"], tuple) else (given["gaps"],) * (count - 1)
    deep = (max(masses) * v0 * v0 / k) ** (1.0 / (q + 1.0))
    # Larger than any overlap there can be, and a power of two.
    reach = 2.0 ** math.ceil(math.log2(100.0 * count * deep))
    places: list[Fraction | float] = [0.0, 0.0]
    for gap in gaps:
        places += [Fraction(places[-2]) + Fraction(reach) + Fraction(gap), 0.0]
    velocities = [v0 if i < given["balls_in"] and axis == 0 else 0.0 for i in range(count) for axis in (0, 1)]
    contacts = [(i, i + 1, reach, k, q, 0.0) for i in range(count - 1)]
    seen = followed(masses, places, velocities, contacts, (deep, v0), accuracy=near or accuracy(found))
    overlap, force = sides(seen)
    # Those that come in together may touch before, but do not push each other.
    first = Fraction(gaps[round(given["balls_in"]) - 1]) / Fraction(v0)
    return {
        "velocities": seen.velocities[::2],
        "duration": (seen.last - first,),
        "largest_overlap": (overlap,),
        "peak_force": (force,),
    }


def three(rng: random.Random) -> dict[str, Any]:
    masses = tuple(powers(rng, -2, 2) for _ in range(3))
    given = {"N": 3.0, "masses": masses, "q": rng.choice([1.0, 1.5, 2.0]), "gaps": rng.choice([0.0, 1e-4])}
    return given | {"k": 1e4, "v0": 1.0, "balls_in": 1.0}


def row(rng: random.Random) -> dict[str, Any]:
    """Two to six balls, stiffness and speed over many powers of ten, several coming in, gaps of their own."""
    count = rng.choice([2, 3, 4, 4, 5, 6])
    speed, k, q = powers(rng, -3, 3), powers(rng, 2, 10), rng.choice([1.0, 1.5, 2.0, 3.0])
    deep = (speed * speed / k) ** (1.0 / (q + 1.0))
    gaps = rng.choice([0.0, deep * powers(rng, -3, 2)])
    own = tuple(deep * powers(rng, -3, 1) for _ in range(count - 1))
    masses = tuple(powers(rng, -0.7, 0.7) for _ in range(count))
    return {
        "N": float(count),
        "masses": rng.choice([masses, (1.0,) * count]),
        "q": q,
        "k": k,
        "v0": speed,
        "gaps": rng.choice([gaps, own]),
        "balls_in": float(rng.randint(1, count - 1)),
    }


def springs(rng: random.Random) -> dict[str, Any]:
    """Three to sixteen unequal balls between springs, most with gaps: they strike each other again and again, and what is off grows."""
    count, speed, k = rng.randint(3, 16), powers(rng, -2, 2), powers(rng, 3, 7)
    deep = speed / math.sqrt(k)
    gaps = tuple(rng.choice([0.0, deep * powers(rng, -4, 2.5)]) for _ in range(count - 1))
    masses = tuple(powers(rng, -1.2, 1.2) for _ in range(count))
    given = {"N": float(count), "masses": masses, "q": 1.0, "k": k, "v0": speed}
    return given | {
        "gaps": rng.choice([gaps, deep * powers(rng, -3, 2)]),
        "balls_in": float(rng.randint(1, count - 1)),
    }


def light_last(rng: random.Random) -> dict[str, Any]:
    """Ever heavier balls between springs, and a light one at the end: its contact, too shallow to be seen beside the others, opens last or not."""
    count = rng.randint(3, 6)
    masses = sorted(powers(rng, -5, 0) for _ in range(count - 1))
    masses.append(masses[-1] * powers(rng, -7, -4.5))
    deep = math.sqrt(masses[-2])
    gaps = tuple(rng.choice([0.0, deep * powers(rng, -5, 0)]) for _ in range(count - 1))
    given = {"N": float(count), "masses": tuple(masses), "q": 1.0, "k": 1.0, "v0": 1.0}
    return given | {"gaps": rng.choice([0.0, gaps]), "balls_in": float(rng.randint(1, count - 1))}


def of_springs(given: dict[str, Any], found: Run) -> Reference:
    return of_row(given, found, 1e-22)


def damped_spheres(rng: random.Random) -> dict[str, Any]:
    given = spheres(rng) | {"mA": powers(rng, -2, 0), "mB": powers(rng, -2, 0), "k": 2e4}
    given["vA"] = (rng.uniform(0.1, 1.5), 0.0)
    return given | {"eta": powers(rng, -6, 0.5)}


def of_damped_spheres(given: dict[str, Any], found: Run) -> Reference:
    """Both spheres in the plane, from the start; spheres that stick are followed for as long as the press could matter."""
    ma, mb, q, k, speed = given["mA"], given["mB"], given["q"], given["k"], given["vA"][0]
    mass, reach = ma * mb / (ma + mb), 2.0 * given["R"]
    deep = (mass * speed * speed / k) ** (1.0 / (q + 1.0))
    sticks = found.outcome == "sticks"
    seen = followed(
        (ma, mb),
        (0.0, 0.0, given["dx"], given["dy"]),
        (speed, 0.0, 0.0, 0.0),
        [(0, 1, reach, k, q, given["eta"])],
        (deep, speed),
        until=2.0 * given["dx"] / speed + 3.0 * deep / speed if sticks else math.inf,
        pressed=components(found.observed.get("duration", math.inf))[0] / 24.0,
    )
    overlap, force = sides(seen)
    true: dict[str, tuple[Any, ...]] = {"largest_overlap": (overlap,), "peak_force": (force,)}
    if sticks:
        return true
    v = seen.velocities
    had = Fraction(ma) * Fraction(speed) ** 2
    has = Fraction(ma) * (v[0] ** 2 + v[1] ** 2) + Fraction(mb) * (v[2] ** 2 + v[3] ** 2)
    return true | {
        "velocities": v,
        "duration": (seen.last - seen.first,),
        "impulse": (Fraction(mb) * v[2], Fraction(mb) * v[3]),
        "energy_ratio": (has / had,),
    }


def damped_ball(rng: random.Random) -> dict[str, Any]:
    given = {"m": powers(rng, -2, 1), "k": powers(rng, 4, 8), "v0": -powers(rng, -1, 1), "R": 1.0, "y0": 1.0}
    return given | {
        "q": rng.choice([1.0, 1.5, 3.0]),
        "g": rng.choice([0.0, 9.8]),
        "eta": powers(rng, -4, 1.5),
    }


def of_damped_ball(given: dict[str, Any], found: Run) -> Reference:
    """A body above another that is held; one that never leaves it is followed until it has come as deep as it gets."""
    m, k, q, eta, g = (given[name] for name in ("m", "k", "q", "eta", "g"))
    speed = -given["v0"]
    deep = max((m * speed * speed / k) ** (1.0 / (q + 1.0)), (m * g / k) ** (1.0 / q))
    sticks = found.outcome == "sticks"
    seen = followed(
        (math.inf, m),
        (0.0, 0.0, 0.0, 1.0),
        (0.0, 0.0, 0.0, -speed),
        [(0, 1, 1.0, k, q, eta)],
        (deep, speed),
        gravity=g,
        until=30.0 * deep / speed if sticks else math.inf,
        accuracy=accuracy(found),
    )
    overlap, force = sides(seen)
    true: dict[str, tuple[Any, ...]] = {"largest_overlap": (overlap,), "peak_force": (force,)}
    if sticks:
        # It sinks to where the floor carries it, for ever, and is never deeper than there unless it has been.
        rest = (mp.mpf(m) * mp.mpf(g) / mp.mpf(k)) ** (1 / mp.mpf(q))
        true |= {"largest_overlap": (max(overlap, rest),), "peak_force": (max(force, mp.mpf(m) * mp.mpf(g)),)}
        return true | {"velocities": (0.0,), "rebound_speed": (0.0,)}
    (back,) = seen.velocities[3:]
    lasts = seen.last - seen.first
    return true | {
        "velocities": (back,),
        "rebound_speed": (back,),
        "duration": (lasts,),
        "impulse": (Fraction(m) * (back + Fraction(speed)) + Fraction(m) * Fraction(g) * lasts,),
        "energy_ratio": ((back / Fraction(speed)) ** 2,),
    }


def touching(rng: random.Random) -> dict[str, Any]:
    """Spheres thrown at each other with their weight, some from inside the contact, watched for longer than it lasts or not."""
    q = rng.choice([1.0, 1.5, 2.0])
    given = {"mA": powers(rng, -1.5, 0.5), "mB": powers(rng, -1.5, 0.5), "R": 0.05, "q": q}
    angle, distance = (
        rng.uniform(-3.1, 3.1),
        0.1 * rng.choice([1.0, rng.uniform(0.97, 1.0), rng.uniform(1.0, 1.1)]),
    )
    given |= {"k": 1.2e4 * 0.005 ** (1.0 - q), "eta": rng.choice([0.0, powers(rng, -3, 0.5)])}
    given |= {"dx": distance * math.cos(angle), "dy": distance * math.sin(angle)}
    closing, across = rng.uniform(0.5, 4.0), rng.uniform(-2.0, 2.0)
    c, s = math.cos(angle), math.sin(angle)
    given |= {
        "vA": (closing * c - across * s, closing * s + across * c),
        "vB": (rng.uniform(-1, 1), rng.uniform(-1, 1)),
    }
    return given | {"g": rng.choice([0.0, 9.8, 9.8]), "t": powers(rng, -3, -1)}


def of_touching(given: dict[str, Any], found: Run) -> Reference:
    ma, mb, q, k, t, g = (given[name] for name in ("mA", "mB", "q", "k", "t", "g"))
    va, vb = given["vA"], given["vB"]
    speed = math.dist(va, vb)
    deep = (ma * mb / (ma + mb) * speed * speed / k) ** (1.0 / (q + 1.0))
    law = (0, 1, 2.0 * given["R"], k, q, given["eta"])
    places = (0.0, 0.0, given["dx"], given["dy"])
    seen = followed((ma, mb), places, (*va, *vb), [law], (deep, speed), gravity=g, until=t)
    v, exact = seen.velocities, [Fraction(x) for x in (ma, mb, t, g)]
    a, b, t, g = exact
    started = Fraction(given["dx"]) ** 2 + Fraction(given["dy"]) ** 2 <= (2 * Fraction(given["R"])) ** 2
    begun = started or seen.changes > 0
    ended = seen.changes % 2 == (1 if started else 0)
    had = a * sum(Fraction(x) ** 2 for x in va) + b * sum(Fraction(x) ** 2 for x in vb)
    true: dict[str, tuple[Any, ...]] = {
        "velocities": v,
        "largest_overlap": (long(seen.overlap),),
        "energy_ratio": ((a * (v[0] ** 2 + v[1] ** 2) + b * (v[2] ** 2 + v[3] ** 2)) / had,),
        "momentum": (a * v[0] + b * v[2], a * v[1] + b * v[3]),
        "momentum_change": (Fraction(0), -(a + b) * g * t),
    }
    if begun:
        true["duration"] = ((seen.last if ended else seen.end) - seen.first,)
        true["mean_force"] = (a * (v[0] - Fraction(va[0])) / t, a * (v[1] - Fraction(va[1])) / t + a * g)
    return true


def dropped(rng: random.Random) -> dict[str, Any]:
    heavy = powers(rng, -2, 1)
    return {
        "mA": heavy,
        "mB": heavy * powers(rng, -2, 0.5),
        "h0": powers(rng, -1, 1),
        "g": 9.8,
        "k": powers(rng, 7, 12),
        "q": rng.choice([1.0, 1.5, 2.0]),
        "gap": rng.choice([0.0, 1e-3, powers(rng, -6, -2)]),
        "weighed": float(rng.random() < 0.6),
    }


def of_dropped(given: dict[str, Any], found: Run) -> Reference:
    """Floor and balls with their weight, from the touch of the lower one on: what is left out of a run without weight is in its error."""
    ma, mb, h0, g, k, q, gap = (given[name] for name in ("mA", "mB", "h0", "g", "k", "q", "gap"))
    fell = mp.sqrt(2 * mp.mpf(g) * mp.mpf(h0))
    down = Fraction(float(fell)) + Fraction(float(fell - float(fell)))
    deep = (ma * float(fell) ** 2 / k) ** (1.0 / (q + 1.0))
    start = Fraction(1), Fraction(2) + Fraction(gap)
    seen = followed(
        (math.inf, ma, mb),
        (0.0, 0.0, 0.0, start[0], 0.0, start[1]),
        (0.0, 0.0, 0.0, -down, 0.0, -down),
        [(0, 1, 1.0, k, q, 0.0), (1, 2, 1.0, k, q, 0.0)],
        (deep, float(fell)),
        gravity=g,
    )
    _, force = sides(seen)
    v = seen.velocities[3], seen.velocities[5]
    places = seen.places[3], seen.places[5]
    true: dict[str, tuple[Any, ...]] = {
        "velocities": v,
        "duration": (seen.last - seen.first,),
        "peak_force": (force,),
    }
    if given["weighed"] or min(v) > 0:
        true["heights"] = tuple(
            y - y0 + each * each / (2 * Fraction(g)) for y, y0, each in zip(places, start, v, strict=True)
        )
    return true


FAMILIES = (
    Family("two spheres, damped", "spheres", STEPS, damped_spheres, of_damped_spheres),
    Family("ball on a floor, damped", "ball_on_floor", STEPS, damped_ball, of_damped_ball, known=1e-18),
    Family("cradle of three, any masses", "cradle", STEPS, three, of_row),
    Family("cradle of two to six", "cradle", STEPS, row, of_row, known=1e-18),
    Family("long rows of springs, unequal", "cradle", STEPS, springs, of_springs),
    Family("springs, a light ball at the end", "cradle", STEPS, light_last, of_springs),
    Family("spheres that touch and fall", "touching_spheres", STEPS, touching, of_touching),
    Family("two balls dropped together", "super_ball", STEPS, dropped, of_dropped),
)
