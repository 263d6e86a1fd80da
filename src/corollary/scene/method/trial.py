"""One step of a collision tried on a clock, with what it would lead to and how far it is off."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scene.line import Line
from corollary.scene.method.clock import Clock, reading
from corollary.scene.method.dop853 import DOP853
from corollary.scene.method.line_motion import Law
from corollary.scene.method.runge_kutta import Slope, doubt, step


@dataclass(frozen=True, slots=True)
class Trial:
    """`size` is the error of the step in units of the tolerance; `lands` says that the clock ends at zero."""

    clock: Clock
    slope: Slope
    before: list[float]
    first: list[float]
    x: float
    h: float
    lands: bool
    after: list[float]
    size: float
    evaluations: int = len(DOP853.rows) - 1

    def part_way(self, part: float) -> list[float]:
        """The state after a part (0 to 1) of the step."""
        return step(DOP853, self.slope, self.x, self.before, part * self.h, self.first)[0]


def on_clock(clock: Clock, in_time: Law) -> Slope:
    """The law of motion with another independent variable: d/dw = (dt/dw) d/dt."""
    if clock.contact is None:
        return lambda _, state: in_time(state)
    place = 1 + clock.contact

    def slope(w: float, state: Sequence[float]) -> list[float]:
        placed = list(state)
        placed[place] = clock.overlap(w)
        rates = in_time(placed)
        stretch = clock.stretch(w, rates)
        return [stretch * rate for rate in rates]

    return slope


def attempt(
    line: Line, clock: Clock, in_time: Law, state: list[float], base: list[float], stride: float, tolerance: float
) -> Trial:
    """Try a step of about `stride`; a step toward zero ends there at most. A step out of all range has an infinite size."""
    x = reading(clock, state)
    lands = clock.contact is not None and x * stride < 0.0 and abs(stride) >= abs(x)
    h = -x if lands else stride
    slope = on_clock(clock, in_time)
    try:
        stretch = clock.stretch(x, base)
        first = [stretch * rate for rate in base]
        after, slopes = step(DOP853, slope, x, state, h, first)
        size = doubt(DOP853, slopes, h, [tolerance] * len(state))
    except (OverflowError, ZeroDivisionError):
        return Trial(clock, slope, state, base, x, h, lands, state, math.inf)
    if clock.contact is not None:
        after[1 + clock.contact] = clock.overlap(0.0 if lands else x + h)
    return Trial(clock, slope, state, first, x, h, lands, after, size)
