"""One step of a method, tried: where it would lead, how far it is off, and any state on its way."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.runge_kutta import Slope, error_estimate, step
from corollary.scenes.integrate.time_variable import TIME, TimeVariable, in_time

EVALUATIONS = len(DOP853.rows) - 1
"""What a step costs when the slope at its start is known."""


def from_table(
    slope: Slope, x: float, h: float, y: Sequence[float], first: Sequence[float]
) -> tuple[list[float], list[Sequence[float]]]:
    """The state after a step of DOP853 and the slopes on the way, for any number of variables."""
    return step(DOP853, slope, x, y, h, first)


@dataclass(slots=True)
class IntegrationStep:
    """From `before` at x over h to `after`; `size` is the estimate of its error in units of the tolerance.

    `first` is the slope at the start. `lands` says that x ends at zero, where a contact begins or ends. In a row of bodies x is the
    `variable`; `before` and `first` are what it does not show, while `after` is a state of the row, its time included.
    """

    slope: Slope
    x: float
    h: float
    before: list[float]
    first: Sequence[float]
    after: list[float]
    size: float
    lands: bool = False
    variable: TimeVariable = TIME
    of_a_row: bool = False
    method: (
        Callable[..., tuple[Sequence[float], object]] | Callable[..., tuple[Sequence[float], float, float]]
    ) = from_table

    def part_way(self, part: float) -> list[float]:
        """The state after a part (0 to 1) of the step."""
        h = part * self.h
        y = self.method(self.slope, self.x, h, self.before, self.first)[0]
        return in_time(self.variable, self.x + h, y) if self.of_a_row else list(y)


def tried(
    slope: Slope, x: float, before: list[float], h: float, allowed: Sequence[float], lands: bool = False
) -> IntegrationStep:
    """A step of DOP853; `allowed` is the error allowed to each component. A step out of all range has an infinite size."""
    try:
        first = slope(x, before)
        after, slopes = from_table(slope, x, h, before, first)
        size = error_estimate(DOP853, slopes, h, allowed)
    except (OverflowError, ZeroDivisionError):
        return IntegrationStep(slope, x, h, before, before, list(before), math.inf, lands)
    return IntegrationStep(slope, x, h, before, first, after, size, lands)
