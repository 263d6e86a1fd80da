"""What ticks in a collision: the time, or the root of the overlap of one contact."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scene.force.contact import smoothing_power
from corollary.scene.line import Line
from corollary.scene.method.line_motion import closing_acceleration, closing_speed


@dataclass(frozen=True, slots=True)
class Clock:
    """The time (contact None), or w of one contact, with overlap = w^power.

    A power of one serves a gap that closes as well: the overlap then runs from below up to zero.
    """

    contact: int | None = None
    power: int = 1

    def overlap(self, w: float) -> float:
        """The overlap when the clock shows w."""
        return w**self.power

    def stretch(self, w: float, rates: Sequence[float]) -> float:
        """dt/dw, given the state's rates of change in time."""
        return 1.0 if self.contact is None else self.power * w ** (self.power - 1) / rates[1 + self.contact]


TIME = Clock()


def reading(clock: Clock, state: Sequence[float]) -> float:
    """What the clock shows."""
    if clock.contact is None:
        return state[0]
    overlap = state[1 + clock.contact]
    return overlap if clock.power == 1 else max(overlap, 0.0) ** (1.0 / clock.power)


def suited_clock(line: Line, state: Sequence[float], base: Sequence[float], touching: Sequence[bool], noise: float) -> Clock:
    """The overlap that is nearest in time to its beginning or end, if its speed will not turn soon; else the time."""
    best, nearest = TIME, math.inf
    for j, contact in enumerate(line.contacts):
        power = smoothing_power(contact)
        overlap, speed = state[1 + j], closing_speed(line, state, j)
        if not touching[j] or power == 1 or overlap < 0.0 or abs(speed) <= noise:
            continue
        if overlap * abs(closing_acceleration(line, base, j)) < 0.3 * speed**2 and overlap < nearest * abs(speed):
            best, nearest = Clock(j, power), overlap / abs(speed)
    return best


def landing_clock(line: Line, contact: int, touching: Sequence[bool]) -> Clock:
    """The clock that reaches zero exactly when a contact ends or begins (Henon's device)."""
    return Clock(contact, smoothing_power(line.contacts[contact]) if touching[contact] else 1)


def stride_for(line: Line, state: Sequence[float], clock: Clock, lasting: float) -> float:
    """The step on this clock that lasts about so long."""
    if clock.contact is None:
        return lasting
    ahead = state[1 + clock.contact] + closing_speed(line, state, clock.contact) * lasting
    return max(ahead, 0.0) ** (1.0 / clock.power) - reading(clock, state)
