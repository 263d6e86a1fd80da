"""Exact motion under the simplest forces: a spring, a dashpot between two bodies, a constant force."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Mover:
    """Where a body is on its line and how fast it goes."""

    x: float
    v: float


def under_spring(start: Mover, m: float, k: float, t: float) -> Mover:
    """A mass on a spring whose rest position is x = 0, a time t later: Newton's law m x'' = -k x solved."""
    w = math.sqrt(k / m)
    c, s = math.cos(w * t), math.sin(w * t)
    return Mover(start.x * c + start.v / w * s, start.v * c - start.x * w * s)


def under_force(start: Mover, m: float, force: float, t: float) -> Mover:
    """A mass under a constant force, a time t later."""
    a = force / m
    return Mover(start.x + start.v * t + 0.5 * a * t * t, start.v + a * t)


def under_dashpot(a: Mover, b: Mover, ma: float, mb: float, c: float, t: float) -> tuple[Mover, Mover]:
    """Two bodies that resist their relative motion with a force c times its speed, a time t later.

    The relative velocity fades as exp(-c t / mu), the centre of mass goes on.
    """
    mu = ma * mb / (ma + mb)
    u = a.v - b.v
    centre = (ma * a.v + mb * b.v) / (ma + mb)
    faded = -math.expm1(-c * t / mu)
    left, slid = u * (1.0 - faded), u * mu / c * faded
    share_a, share_b = mb / (ma + mb), ma / (ma + mb)
    return (
        Mover(a.x + centre * t + share_a * slid, centre + share_a * left),
        Mover(b.x + centre * t - share_b * slid, centre - share_b * left),
    )


def faded_time(ma: float, mb: float, c: float) -> float:
    """After how long nothing that a double can tell is left of the relative velocity of two bodies with a dashpot."""
    return 40.0 * ma * mb / (ma + mb) / c


def stopping(start: Mover, m: float, force: float) -> tuple[Mover, float]:
    """Where a body that a constant force opposes comes to rest, and after how long."""
    t = abs(m * start.v / force)
    end = under_force(start, m, -math.copysign(force, start.v), t)
    return Mover(end.x, 0.0), t
