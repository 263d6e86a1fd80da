"""Contacts without damping against references of their own: the energy's integral by the tanh-sinh rule in 450 binary digits."""

# pyright: reportUnknownArgumentType=false, reportUnknownVariableType=false, reportUnknownMemberType=false

from __future__ import annotations

import random
from functools import cache
from typing import Any

import flint
import mpmath as mp
from flint import arb

from corollary.scenes.run import Run, components
from ready.family import Family, Reference, powers


def ball(rng: random.Random) -> dict[str, Any]:
    span = rng.choice([2, 30])
    given = {
        "m": powers(rng, -span, span),
        "k": powers(rng, -span, span),
        "v0": -powers(rng, -span / 2, span / 2),
    }
    # Weight from nothing to what decides the contact.
    return given | {"q": rng.choice([1.0, 1.5, 2.0, 3.0]), "g": powers(rng, -8, 3), "R": 1.0, "y0": 1.0}


@cache
def double_exponential(steps: int) -> tuple[tuple[arb, arb, arb], ...]:
    """Places y in (0, 1), 1 - y and weights of the tanh-sinh rule with so many nodes for a unit of its variable."""
    found: list[tuple[arb, arb, arb]] = []
    for i in range(-6 * steps, 6 * steps + 1):
        t = arb(i) / steps
        u = arb.pi() * t.sinh()
        y, left = 1 / (1 + (-u).exp()), 1 / (1 + u.exp())
        weight = arb.pi() * t.cosh() * y * left / steps
        if weight > 1e-130:
            found.append((y.mid(), left.mid(), weight.mid()))
    return tuple(found)


def of_ball(given: dict[str, Any], found: Run, steps: int = 128) -> Reference:
    """Energy's integral by the tanh-sinh rule in 450 binary digits, with x = top (1 - y^2) where the ball turns back."""
    with flint.ctx.workprec(450):
        m, k, v, q, g = (arb(given[name]) for name in ("m", "k", "v0", "q", "g"))
        v, p = -v, q + 1
        stiff = 2 * k / (p * m)
        one, two = (v**2 / stiff) ** (1 / p), (2 * g / stiff) ** (1 / q)
        top = 2 * (one if one > two else two)
        for _ in range(200):
            top = (top - (v**2 + 2 * g * top - stiff * top**p) / (2 * g - stiff * p * top**q)).mid()
        if given["q"] == 1:
            turning = (k / m).sqrt()  # a swing about the place where the spring carries the ball
            lasts = 2 / turning * (arb.pi() - (turning * v / g).atan())
        else:
            lasts = arb(0)
            for y, z, weight in double_exponential(steps):
                e = y * y
                fallen = -((-e).log1p() * p).expm1() if e < 0.5 else 1 - (z * (1 + y)) ** p
                lasts += weight * y / (stiff * top**p * fallen - 2 * g * top * e).sqrt()
            lasts *= 4 * top
        true = {
            "duration": lasts,
            "impulse": 2 * m * v + m * g * lasts,
            "largest_overlap": top,
            "peak_force": k * top**q,
        }
        return {name: (mp.mpf(x.str(110, radius=False)),) for name, x in true.items()}


def spheres(rng: random.Random) -> dict[str, Any]:
    share = rng.choice([rng.random(), 1.0 - powers(rng, -12, -3)])
    speed = powers(rng, -3, 3)
    return {
        "mA": powers(rng, -6, 6),
        "mB": powers(rng, -6, 6),
        "R": 0.02,
        "q": rng.choice([1.0, 1.5, 2.0]),
        "k": 1e9,
        "eta": 0.0,
        "dx": 0.1,
        "dy": 0.04 * share,
        "vA": (speed, 0.0),
    }


def of_spheres(given: dict[str, Any], found: Run, steps: int = 64) -> Reference:
    """Energy's integrals by the tanh-sinh rule in 450 binary digits, with x = top (1 - y^2) where the spheres turn back.

    Differences are written out so that none cancels; with twice the nodes forty digits stay (a test holds it to mpmath's rule).
    """
    with flint.ctx.workprec(450):
        d, k, ma, mb = (arb(x) for x in (2 * given["R"], given["k"], given["mA"], given["mB"]))
        v, q = arb(given["vA"][0]), arb(given["q"])
        p, mu, spin = q + 1, ma * mb / (ma + mb), v * arb(given["dy"])
        root = ((d * v) ** 2 - spin**2).sqrt()
        inward, stiff = root / d, 2 * k / (p * mu)
        top = arb(components(found.observed["largest_overlap"])[0])
        for _ in range(7):
            left = inward**2 - stiff * top**p - spin**2 * (1 / (d - top) ** 2 - 1 / d**2)
            top = (top + left / (stiff * p * top**q + 2 * spin**2 / (d - top) ** 3)).mid()
        near, force = d - top, stiff * top**p
        lasts = turned = arb(0)
        for y, z, weight in double_exponential(steps):
            e, r = y * y, near + top * y * y
            # 1 - (1 - e)^p, and 1 / near^2 - 1 / r^2
            fallen = -((-e).log1p() * p).expm1() if e < 0.5 else 1 - (z * (1 + y)) ** p
            square = force * fallen + spin**2 * top * e * (r + near) / (near * r) ** 2
            pace = weight * y / square.sqrt()
            lasts, turned = lasts + pace, turned + pace * spin / r**2
        lasts, turned = 4 * top * lasts, 4 * top * turned
        angle, across = turned + arb.atan2(spin, root), spin / d
        jx = mu * (inward * angle.cos() - across * angle.sin() + v)
        jy = mu * (inward * angle.sin() + across * angle.cos())
        true = {
            "velocities": (v - jx / ma, -jy / ma, jx / mb, jy / mb),
            "impulse": (jx, jy),
            "duration": (lasts,),
            "largest_overlap": (top,),
        }
        return {
            name: tuple(mp.mpf(x.str(110, radius=False)) for x in values) for name, values in true.items()
        }


FAMILIES = (
    Family("ball on a floor with weight", "ball_on_floor", "tanh-sinh, 120 digits", ball, of_ball),
    # A graze changes the velocity along the line of flight by so little that sixty digits of it cancel.
    Family(
        "two spheres, half of them grazing",
        "spheres",
        "tanh-sinh, 120 digits",
        spheres,
        of_spheres,
        digits=120,
    ),
)
