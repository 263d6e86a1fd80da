"""What stays the same while a line is followed: its clocks, its law on each of them, and how a step is taken."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from corollary.scene.line import Line
from corollary.scene.method import line_motion
from corollary.scene.method.clock import Clock, smoothing_powers
from corollary.scene.method.dop853 import DOP853
from corollary.scene.method.written_out import Slope, Step, written_out

# From here on arrays are faster than sums written out.
LONG = 14


@dataclass(frozen=True, slots=True)
class Course:
    """A line in natural units; `noise` is the speed that cannot be told from none."""

    line: Line
    tolerance: float
    noise: float
    damped: bool
    powers: tuple[int, ...]
    step: Step
    written: Callable[[Line, Sequence[bool], Clock], Slope]
    laws: dict[tuple[int | None, int, tuple[bool, ...]], Slope] = field(default_factory=dict)

    def law(self, touching: Sequence[bool], clock: Clock) -> Slope:
        """The law of motion on a clock; made once for every set of contacts that touch."""
        key = clock.contact, clock.power, tuple(touching)
        found = self.laws.get(key)
        if found is None:
            found = self.laws[key] = self.written(self.line, touching, clock)
        return found


def course(line: Line, tolerance: float) -> Course:
    """How a line is followed with this error allowed to a step."""
    if len(line.masses) < LONG:
        step, law = written_out(DOP853, 2 * len(line.masses) - 1), line_motion.law_of_motion
    else:
        from corollary.scene.method import long_row  # here, since it brings numpy, which short rows never need

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
