"""Every fixed-step method as a route through a program: the steps are whole parts of the time, each a little shorter."""

from __future__ import annotations

import math

from corollary.grading.programs.fixed_step import Method, march

from .case import Answer, Case, Route
from .methods import METHODS

RATIO = math.sqrt(2.0)


def routes(case: Case, most: int) -> dict[str, Route]:
    """From half a contact time to where a run would ask for the force `most` times; a shorter step costs 1.4 times as much."""
    fewest = max(4.0, 2.0 * case.program.until / case.contact_time)
    return {name: _route(case, method, fewest, most) for name, method in METHODS.items()}


def _route(case: Case, method: Method, fewest: float, most: int) -> Route:
    program = case.program

    def run(step: float) -> Answer:
        path = march(method, program.acceleration, program.x, program.v, step, round(program.until / step))
        return Answer(program.read(path.places[-1], path.velocities[-1]), path.evaluations)

    each = march(method, program.acceleration, program.x, program.v, 0.0, 8).evaluations / 8
    count = max(2, math.floor(math.log(most / each / fewest, RATIO)) + 1)
    steps = dict.fromkeys(program.until / round(fewest * RATIO**i) for i in range(count))
    return Route("step", tuple(steps), run)
