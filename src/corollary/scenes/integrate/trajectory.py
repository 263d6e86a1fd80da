"""What stays the same while a line is followed: its clocks, its law on each of them, and how a step is taken."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from corollary.scenes.integrate import row_motion
from corollary.scenes.integrate.dop853 import DOP853
from corollary.scenes.integrate.time_variable import Clock, smoothing_powers
from corollary.scenes.integrate.written_out import Slope, StepFunction, written_out
from corollary.scenes.row import Row

# From here on arrays are faster than sums written out.
LONG = 14


@dataclass(frozen=True, slots=True)
class Course:
    """A line in natural units; `noise` is the speed that cannot be told from none."""

    line: Row
    tolerance: float
    noise: float
    damped: bool
    powers: tuple[int, ...]
    step: StepFunction
    written: Callable[[Row, Sequence[bool], Clock], Slope]
    laws: dict[tuple[int | None, int, tuple[bool, ...]], Slope] = field(default_factory=dict)

    def law(self, touching: Sequence[bool], clock: Clock) -> Slope:
        """The law of motion on a clock; made once for every set of contacts that touch."""
        key = clock.contact, clock.power, tuple(touching)
        found = self.laws.get(key)
        if found is None:
            found = self.laws[key] = self.written(self.line, touching, clock)
        return found


def course(line: Row, tolerance: float) -> Course:
    """How a line is followed with this error allowed to a step."""
    if len(line.masses) < LONG:
        step, law = written_out(DOP853, 2 * len(line.masses) - 1), row_motion.law_of_motion
    else:
        from corollary.scenes.integrate import (
            long_row,
        )  # here, since it brings numpy, which short rows never need

        step, law = long_row.step, long_row.law_of_motion
    return Course(
        line=line,
        tolerance=tolerance,
        # Speeds that a few steps' errors can make are not told from none.
        noise=max(1e-14, 3.0 * tolerance),
        damped=any(c.eta > 0.0 for c in line.contacts),
        powers=smoothing_powers(line),
        step=step,
        written=law,
    )
