"""One step of a collision tried on a clock, with what it would lead to and how far it is off."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.row_motion import in_time, on_clock
from corollary.scenes.integrate.time_variable import Clock, reading
from corollary.scenes.integrate.written_out import Slope, StepFunction

EVALUATIONS = len(DOP853.rows) - 1
# Errors are averaged over the variables, but in a long row only about so many are at work at a time.
AT_WORK = 12


@dataclass(slots=True)
class Step:
    """`size` is the error of the step in units of the tolerance; `lands` says that the clock ends at zero.

    `before` and `first` are (overlaps, velocities) on the clock and their slope; `after` is a state.
    """

    clock: Clock
    step: StepFunction
    slope: Slope
    x: float
    h: float
    before: list[float]
    first: list[float]
    lands: bool
    after: list[float]
    size: float

    def part_way(self, part: float) -> list[float]:
        """The state after a part (0 to 1) of the step."""
        y = self.step(self.slope, self.x, part * self.h, self.before, self.first)[0]
        return in_time(self.clock, self.x + part * self.h, y)


def attempt(
    step: StepFunction,
    clock: Clock,
    slope: Slope,
    state: list[float],
    base: Sequence[float],
    stride: float,
    tolerance: float,
) -> Step:
    """Try a step of about `stride`; a step toward zero ends there at most. A step out of all range has an infinite size.

    `base` is the slope of (overlaps, velocities) in time.
    """
    x = reading(clock, state)
    lands = clock.contact is not None and x * stride < 0.0 and abs(stride) >= abs(x)
    h = -x if lands else stride
    before = on_clock(clock, state)
    try:
        stretch = clock.stretch(x, base)
        first = [stretch * rate for rate in base]
        if clock.contact is not None:
            first[clock.contact] = stretch
        y, fifth, third = step(slope, x, h, before, first)
        size = error_size(fifth, third, h, len(before)) / tolerance
    except ArithmeticError:
        return Step(clock, step, slope, x, h, before, [], lands, state, math.inf)
    return Step(
        clock, step, slope, x, h, before, first, lands, in_time(clock, 0.0 if lands else x + h, y), size
    )


def error_size(fifth: float, third: float, h: float, count: int) -> float:
    """The error of a step from the sums of squares of its two doubts (Hairer, Norsett and Wanner, II.10)."""
    if fifth == 0.0:
        return 0.0
    return abs(h) * fifth / math.sqrt((fifth + 0.01 * third) * min(count, AT_WORK))
