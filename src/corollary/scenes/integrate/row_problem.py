"""A row of bodies made ready for integration: its law in every variable, and how a step is tried."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from corollary.scenes.integrate import written_out
from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.runge_kutta import Slope
from corollary.scenes.integrate.step import IntegrationStep
from corollary.scenes.integrate.time_variable import (
    TimeVariable,
    beside,
    in_time,
    smoothing_powers,
    value_in,
)
from corollary.scenes.integrate.written_out import StepFunction
from corollary.scenes.row import RowOfBodies

# From this many bodies on arrays are faster than sums written out (benchmarks/scenes.py).
LONG = 14
# Errors are averaged over the variables, but in a long row only about so many are at work at a time.
AT_WORK = 12


@dataclass(frozen=True, slots=True)
class RowProblem:
    """A line in natural units; `noise` is the speed that cannot be told from none."""

    line: RowOfBodies
    tolerance: float
    noise: float
    damped: bool
    powers: tuple[int, ...]
    step: StepFunction
    law_of_motion: Callable[[RowOfBodies, Sequence[bool], TimeVariable], Slope]
    laws: dict[tuple[int | None, int, tuple[bool, ...]], Slope] = field(
        default_factory=dict[tuple[int | None, int, tuple[bool, ...]], Slope]
    )

    def law(self, touching: Sequence[bool], variable: TimeVariable) -> Slope:
        """The law of motion in a variable; made once for every set of contacts that touch."""
        key = variable.contact, variable.power, tuple(touching)
        found = self.laws.get(key)
        if found is None:
            found = self.laws[key] = self.law_of_motion(self.line, touching, variable)
        return found


def row_problem(line: RowOfBodies, tolerance: float) -> RowProblem:
    """How a line is followed with this error allowed to a step."""
    if len(line.masses) < LONG:
        step, law = written_out.step(DOP853, 2 * len(line.masses) - 1), written_out.law_of_motion
    else:
        from corollary.scenes.integrate import (
            long_row,  # here, since it brings numpy, which short rows never need
        )

        step, law = long_row.step, long_row.law_of_motion
    return RowProblem(
        line=line,
        tolerance=tolerance,
        # Speeds that a few steps' errors can make are not told from none.
        noise=max(1e-14, 3.0 * tolerance),
        damped=any(c.eta > 0.0 for c in line.contacts),
        powers=smoothing_powers(line),
        step=step,
        law_of_motion=law,
    )


def attempt(
    problem: RowProblem,
    variable: TimeVariable,
    touching: Sequence[bool],
    state: list[float],
    base: Sequence[float],
    stride: float,
) -> IntegrationStep:
    """Try a step of about `stride`; a step toward zero ends there at most. A step out of all range has an infinite size.

    `base` is the slope of (overlaps, velocities) in time.
    """
    slope, x = problem.law(touching, variable), value_in(variable, state)
    lands = variable.contact is not None and x * stride < 0.0 and abs(stride) >= abs(x)
    h = -x if lands else stride
    before = beside(variable, state)
    try:
        stretch = variable.stretch(x, base)
        first = [stretch * rate for rate in base]
        if variable.contact is not None:
            first[variable.contact] = stretch
        y, fifth, third = problem.step(slope, x, h, before, first)
        size = error_size(fifth, third, h, len(before)) / problem.tolerance
        after = in_time(variable, 0.0 if lands else x + h, y)
    except ArithmeticError:
        first, after, size = [], state, math.inf
    return IntegrationStep(slope, x, h, before, first, after, size, lands, variable, True, problem.step)


def error_size(fifth: float, third: float, h: float, count: int) -> float:
    """The error of a step from the sums of squares of its two estimates (Hairer, Norsett and Wanner, II.10)."""
    if fifth == 0.0:
        return 0.0
    return abs(h) * fifth / math.sqrt((fifth + 0.01 * third) * min(count, AT_WORK))
