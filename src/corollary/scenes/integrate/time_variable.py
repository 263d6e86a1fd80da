"""The independent variable of a collision: the time, or the root of the overlap of one contact (a time transformation).

Source: M. Henon, Physica D 5 (1982) 412, for a variable that ends a step exactly where it is wanted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from corollary.scenes.forces.contact import smoothing_power
from corollary.scenes.row import RowOfBodies


@dataclass(frozen=True, slots=True)
class TimeVariable:
    """The time (contact None), or w of one contact, with overlap = w^power.

    A power of one serves a gap that closes as well: the overlap then runs from below up to zero.
    """

    contact: int | None = None
    power: int = 1

    def overlap(self, w: float) -> float:
        """The overlap at w."""
        return w**self.power

    def stretch(self, w: float, rates: Sequence[float]) -> float:
        """dt/dw, given the rates of change of the overlaps in time."""
        return 1.0 if self.contact is None else self.power * w ** (self.power - 1) / rates[self.contact]


TIME = TimeVariable()


@lru_cache(maxsize=1024)
def variable_of(contact: int, power: int) -> TimeVariable:
    """The variable of a contact; one of each kind is enough."""
    return TimeVariable(contact, power)


def value_in(variable: TimeVariable, state: Sequence[float]) -> float:
    """The value of the variable in a state."""
    if variable.contact is None:
        return state[0]
    overlap = state[1 + variable.contact]
    return overlap if variable.power == 1 else max(overlap, 0.0) ** (1.0 / variable.power)


def smoothing_powers(line: RowOfBodies) -> tuple[int, ...]:
    """For each contact the power in which its force is smooth."""
    known = {contact: smoothing_power(contact) for contact in set(line.contacts)}
    return tuple(known[contact] for contact in line.contacts)


def suited_variable(
    powers: Sequence[int],
    state: Sequence[float],
    base: Sequence[float],
    touching: Sequence[bool],
    lasting: float,
    noise: float,
) -> TimeVariable:
    """The overlap that is nearest in time to its beginning or end, if its speed will not turn soon; else the time.

    Further off than two steps (`lasting` each) the beginning or end is not felt: the time does as well and costs less.
    `base` is the rate of change of (overlaps, velocities) in time.
    """
    best, nearest, count = TIME, 2.0 * lasting, len(powers)
    for j, power in enumerate(powers):
        if power == 1 or not touching[j]:
            continue
        overlap, speed = state[1 + j], base[j]
        if overlap < 0.0 or not (speed > noise or speed < -noise):
            continue
        if overlap * abs(
            base[count + j] - base[count + j + 1]
        ) < 0.3 * speed * speed and overlap < nearest * abs(speed):
            best, nearest = variable_of(j, power), overlap / abs(speed)
    return best


def landing_variable(powers: Sequence[int], contact: int, touching: Sequence[bool]) -> TimeVariable:
    """The variable that reaches zero exactly when a contact ends or begins (Henon's device)."""
    return variable_of(contact, powers[contact] if touching[contact] else 1)


def stride_for(
    state: Sequence[float], base: Sequence[float], variable: TimeVariable, lasting: float
) -> float:
    """The step on this variable that lasts about so long."""
    if variable.contact is None:
        return lasting
    ahead = state[1 + variable.contact] + base[variable.contact] * lasting
    return max(ahead, 0.0) ** (1.0 / variable.power) - value_in(variable, state)


def beside(variable: TimeVariable, state: Sequence[float]) -> list[float]:
    """The state beside the variable: (overlaps, velocities), the time in the place of the variable's own overlap."""
    y = list(state[1:])
    if variable.contact is not None:
        y[variable.contact] = state[0]
    return y


def in_time(variable: TimeVariable, w: float, y: Sequence[float]) -> list[float]:
    """The state of the row where the variable is w."""
    if variable.contact is None:
        return [w, *y]
    state = [y[variable.contact], *y]
    state[1 + variable.contact] = variable.overlap(w)
    return state
