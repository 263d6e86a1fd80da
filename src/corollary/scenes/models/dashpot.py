"""One contact of a spring and a dashpot in closed form, and one that its dashpot decides."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Damped:
    """`restitution` is the speed of parting over that of meeting, zero for bodies that stick.

    `overlap` (m) and `force` (N) are the largest, `duration` (s) is infinite for bodies that stick.
    """

    restitution: float
    duration: float
    overlap: float
    force: float

    @property
    def sticks(self) -> bool:
        return math.isinf(self.duration)


def damped_spring(m: float, k: float, eta: float, v: float) -> Damped:
    """A (reduced) mass m that meets a spring k and a dashpot eta at speed v, until the spring is at rest length again.

    m x'' = -k x - eta x' from x = 0. Below critical damping x = v/w exp(-fade t) sin(w t); from there on x never returns to zero.
    In both cases its top is v/w0 exp(-fade t), at the time where its rate is zero.
    """
    w0 = math.sqrt(k / m)
    share, fade = 0.5 * eta / math.sqrt(k * m), 0.5 * eta / m
    if share >= 1.0:
        s = w0 * math.sqrt((share - 1.0) * (share + 1.0))
        top = math.asinh(s / w0) / s if s else 1.0 / w0
        return Damped(0.0, math.inf, v / w0 * math.exp(-fade * top), eta * v)
    w = w0 * math.sqrt((1.0 - share) * (1.0 + share))
    top = math.atan2(w, fade) / w
    force = eta * v
    # The force k x + eta x' swings a quarter ahead, and more with damping: from share = 1/2 on it is largest at the touch.
    latest = 0.5 * math.pi - 3.0 * math.asin(share)
    if latest > 0.0:
        faded = v * math.exp(-fade * latest / w)
        place, rate = faded / w * math.sin(latest), faded * (math.cos(latest) - fade / w * math.sin(latest))
        force = max(force, k * place + eta * rate)
    return Damped(math.exp(-fade * math.pi / w), math.pi / w, v / w0 * math.exp(-fade * top), force)
