"""Scenes with a motion of one body: in a well, past another ion, falling with a growing mass, swinging."""

# pyright: reportUnknownArgumentType=false, reportUnknownVariableType=false, reportUnknownMemberType=false

from __future__ import annotations

import math
import random
from typing import Any

import mpmath as mp
import numpy as np
from composed.reference import numbers, stepped
from scipy.integrate import solve_ivp

from corollary.scenes.run import Run, components
from ready.family import Family, Reference, powers
from ready.momentum import fractions, long, longs
from ready.motion import followed

LOGARITHM = "exact fractions, and a logarithm"


def atom(rng: random.Random) -> dict[str, Any]:
    """From inside the well, from its edge, from outside; on a line and in a plane; slow and fast."""
    m, k, b = powers(rng, -3, 3), powers(rng, -1, 4), powers(rng, -2, 2)
    d = b * rng.uniform(0.05, 0.95)
    scale = d * math.sqrt(k / m)
    distance = rng.choice([rng.uniform(b - d, b + d), rng.uniform(b + d, 3.0 * (b + d))])
    distance = min(max(distance, math.nextafter(b - d, math.inf)), 3.0 * (b + d))
    speed = scale * rng.choice([rng.uniform(0.01, 1.2), rng.uniform(0.5, 5.0)])
    given = {"m": m, "k": k, "b": b, "d": d}
    if rng.random() < 0.3:
        return given | {"dimension": 1.0, "r0": distance, "v0": rng.choice([-speed, speed])}
    angle, way = rng.uniform(-3.1, 3.1), rng.uniform(-3.1, 3.1)
    place = distance * math.cos(angle), distance * math.sin(angle)
    if math.hypot(*place) < b - d:
        place = distance * 1.001, 0.0
    return given | {"dimension": 2.0, "r0": place, "v0": (speed * math.cos(way), speed * math.sin(way))}


def of_atom(given: dict[str, Any], found: Run) -> Reference:
    """Newton's second law in the plane, step by step."""
    m, k, b, d = (given[name] for name in ("m", "k", "b", "d"))
    plane = given["dimension"] == 2.0
    place = given["r0"] if plane else (given["r0"], 0.0)
    velocity = given["v0"] if plane else (given["v0"], 0.0)
    if found.outcome == "missed":
        return {"velocities": velocity if plane else velocity[:1], "escapes": (1.0,)}
    speed = max(math.hypot(*velocity), d * math.sqrt(k / m))
    law = (0, 1, b, k, 1.0, 0.0, b + d, b - d)
    seen = followed(
        (math.inf, m),
        (0.0, 0.0, *place),
        (0.0, 0.0, *velocity),
        [law],
        (d, speed),
        turns=3,
        accuracy=1e-22,
    )
    turns = [tuple(map(long, turn)) for turn in seen.turns if any(turn)]
    distances = [mp.hypot(x, y) for _, x, y in turns]
    if found.outcome == "bound":
        low, high = sorted(distances[:2])
        true: dict[str, tuple[Any, ...]] = {
            "period": (turns[2][0] - turns[0][0],),
            "turning_points": (low, high),
            "escapes": (0.0,),
        }
        if plane:
            (_, x, y), (_, u, w) = turns[0], turns[2]
            angle = mp.atan2(x * w - y * u, x * u + y * w)
            (stated,) = components(found.observed["angle"])
            true["angle"] = (angle + 2 * mp.pi * mp.nint((stated - angle) / (2 * mp.pi)),)
        return true
    v = seen.velocities[2:]
    return {
        "velocities": v if plane else (v[0],),
        "turning_points": tuple(distances[:1]),
        "duration": (seen.last,),
        "escapes": (1.0,),
    }


def ions(rng: random.Random) -> dict[str, Any]:
    given = {name: powers(rng, -20, 20) for name in ("C", "mA", "mB", "v", "r0")}
    return given | {"s": given["r0"] * rng.choice([0.0, rng.uniform(0.0, 0.999), powers(rng, -15, 0)])}


def of_ions(given: dict[str, Any], _: Run) -> Reference:
    """The hyperbola by its Runge-Lenz vector, drawn from the start; its far speed by its angular momentum and excentricity."""
    strength, a, b, v, r0, s = longs(given, "C", "mA", "mB", "v", "r0", "s")
    mass = a * b / (a + b)
    # At r0 the velocity crosses the radius with the arm s.
    across = v * s / r0
    inward, spin = v * mp.sqrt(1 - (s / r0) ** 2), mass * v * s
    # p x L / (mass C) + the radius' direction, its own direction turned away from the nearest point.
    along, sideways = 1 + spin * across / strength, spin * inward / strength
    excentric = mp.hypot(along, sideways)
    half = strength / (mass * v * v + 2 * strength / r0)
    nearest = half * (1 + excentric)
    far = (
        strength / spin * mp.sqrt(excentric**2 - 1)
        if s and excentric - 1 > 1e-30
        else v * mp.sqrt(1 + 2 * strength / (mass * v * v * r0))
    )
    return {"turning_points": (nearest,), "peak_force": (strength / nearest**2,), "far_speed": (far,)}


def growing(rng: random.Random) -> dict[str, Any]:
    given = {
        "m": powers(rng, -4, 4),
        "t": powers(rng, -2, 1.5),
        "v": rng.uniform(-30, 30),
        "u": rng.uniform(-30, 30),
    }
    return given | {
        "R": given["m"] / given["t"] * rng.choice([0.0, powers(rng, -4, 3)]),
        "g": rng.choice([0.0, 9.8, 1.6]),
    }


def of_growing(given: dict[str, Any], _: Run) -> Reference:
    """Momentum is what was there, what the vapour brought, and the weight's push; the way is its integral, with one logarithm."""
    m, v, rate, u, g, t = fractions(given, "m", "v", "R", "u", "g", "t")
    mass = m + rate * t
    velocity = (m * v + rate * t * u + g * (m * t + rate * t * t / 2)) / mass
    if not rate:
        return {"velocities": (velocity,), "way": (v * t + g * t * t / 2,), "mass": (mass,)}
    # v = u + g (m + R t)/(2 R) + c/(m + R t)
    c = m * (v - u) - g * m * m / (2 * rate)
    with mp.workdps(80):
        way = long(u * t + g * (mass * mass - m * m) / (4 * rate * rate)) + long(c / rate) * mp.log(
            long(mass / m)
        )
    return {"velocities": (velocity,), "way": (way,), "mass": (mass,)}


def hanging(rng: random.Random) -> dict[str, Any]:
    length, g = powers(rng, -2, 2), powers(rng, -1, 2)
    given = {"mA": powers(rng, -4, 2), "mB": powers(rng, -2, 3), "L": length, "g": g}
    common = math.sqrt(2.0 * g * length) * rng.choice([rng.uniform(0.01, 0.99), powers(rng, -5, 0) * 0.9])
    given["v"] = common * (given["mA"] + given["mB"]) / given["mA"]
    return given | {"dt": 0.1 * math.sqrt(length / g) * powers(rng, -6, -0.01)}


def of_hanging(given: dict[str, Any], _: Run) -> Reference:
    """The block's angle and the bullet's way in it by extrapolated midpoint steps in 64 binary digits; Lagrange's equations, solved by hand."""
    a, b, v, length, g, dt = (np.longdouble(given[name]) for name in ("mA", "mB", "v", "L", "g", "dt"))
    both, grip, unit = a + b, 40 * a * b / (a + b) / dt, a / (a + b) * v

    # In units of dt and of the common speed: angle over unit dt / L, its rate, the bullet's speed in the block over v.
    def f(t: Any, y: Any, _: Any) -> list[Any]:
        angle, rate, inside = y
        theta = angle * unit * dt / length
        s, c = np.sin(theta), np.cos(theta)
        curve = unit * unit * rate * rate / length
        braked = grip * v * inside
        # (mB + mA) x'' + mA w' cos = -(mA + mB) g sin along the arc; w' + x'' cos - x'^2/L sin = -braked/mA along the bullet's way.
        along = (c * braked - a * s * c * curve - both * g * s) / (both - a * c * c)
        return [rate, along * dt / unit, (s * curve - c * along - braked / a) * dt / v]

    y, steps = numbers(0, 0, 1), 48
    for i in range(steps):
        y, _ = stepped(f, np.longdouble(i) / steps, y, np.longdouble(1) / steps, None)
    angle = y[0] * unit * dt / length
    speed = y[1] * unit + a / both * np.cos(angle) * y[2] * v
    height = 2 * length * np.sin(angle / 2) ** 2 + speed**2 / (2 * g)
    lost = both * g * height - a * v**2 / 2
    true = {
        "velocities": (speed, speed),
        "height": (height,),
        "angle": (2 * np.arcsin(np.sqrt(height / (2 * length))),),
        "energy_change": (lost,),
    }
    return {
        name: tuple(mp.mpf(float(x)) + mp.mpf(float(x - float(x))) for x in row) for name, row in true.items()
    }


def swung(rng: random.Random) -> dict[str, Any]:
    given = {name: powers(rng, -1.5, 1.5) for name in ("m", "M", "L")}
    return given | {"g": powers(rng, 0, 1.5), "k": powers(rng, 5, 11)}


def of_swung(given: dict[str, Any], _: Run) -> Reference:
    """The sphere on its circle while it pushes the block, which the scene neglects: scipy's DOP853 in the angle."""
    m, block, length, g, k = (given[name] for name in ("m", "M", "L", "g", "k"))
    speed = math.sqrt(2.0 * g * length)
    deep = (speed**2 * m * block / (m + block) / k) ** 0.4
    unit = deep / speed

    # Times in `unit`, ways in `deep`: the sphere's arc, the overlap, and both rates.
    def f(_: float, y: Any) -> list[float]:
        arc, over, rate, opening = y
        theta = arc * deep / length
        force = k * (max(over, 0.0) * deep) ** 1.5
        gained = -g * math.sin(theta) - math.cos(theta) * force / m
        away = force / block
        curve = math.sin(theta) * (speed * rate) ** 2 / length
        return [
            rate,
            opening,
            gained * unit / speed,
            (math.cos(theta) * gained - curve - away) * unit / speed,
        ]

    def parts(_: float, y: Any) -> float:
        return y[1]

    parts.terminal, parts.direction = True, -1.0  # pyright: ignore[reportFunctionMemberAccess]
    tiny = [0.0, 0.0, 1.0, 1.0]
    solved = solve_ivp(f, (0.0, 30.0), tiny, "DOP853", rtol=2.3e-14, atol=1e-15, events=parts, max_step=0.05)
    arc, _, rate, opening = solved.y[:, -1]
    theta, after = arc * deep / length, rate * speed
    pushed = math.cos(theta) * after - opening * speed
    height = 2.0 * length * math.sin(0.5 * theta) ** 2 + after**2 / (2.0 * g)
    exact = mp.sqrt(2 * mp.mpf(g) * mp.mpf(length))
    lasts = float(solved.t[-1]) * unit
    return {
        "velocities": (after, pushed),
        "height": (height,),
        "duration": (lasts,),
        "speed_before": (exact,),
    }


FAMILIES = (
    Family("atom in a well", "atom", "steps of 31 digits", atom, of_atom, known=1e-19),
    Family("ions, all 1e±20", "ions", "Runge-Lenz vector, 100 digits", ions, of_ions, digits=100),
    Family(
        "bullet in a hanging block",
        "ballistic_pendulum",
        "extrapolated midpoint, 64 bits",
        hanging,
        of_hanging,
        known=1e-17,
    ),
    Family("pendulum and block", "pendulum_block", "DOP853 on the circle", swung, of_swung, known=1e-12),
    Family("growing drop", "growing_drop", LOGARITHM, growing, of_growing),
    Family("growing drop, in steps", "growing_drop", LOGARITHM, growing, of_growing, second_way=True),
)
