"""Fixed-step methods of the race (Euler-Cromer, velocity Verlet, RK4, Yoshida of order 4, 6 and 8) as routes through a program."""

from __future__ import annotations

import math
from collections.abc import Sequence

from corollary.grading.programs.fixed_step import EULER_CROMER, RK4, Method, Splitting, march
from corollary.trade.raced_scene import MethodAnswer, MethodRoute, RacedScene

RATIO = math.sqrt(2.0)


def composed(order: int, outer: Sequence[float]) -> Splitting:
    """Verlet steps of lengths w_k … w_1 w_0 w_1 … w_k (parts of dt, summing to one), neighbouring half kicks joined."""
    middle = 1.0 - 2.0 * sum(outer)
    parts = [*reversed(outer), middle, *outer]
    kicks = [0.5 * (a + b) for a, b in zip([0.0, *parts], [*parts, 0.0], strict=True)]
    return Splitting(order, tuple(kicks), (*parts, 0.0))


VELOCITY_VERLET = composed(2, ())

_CUBE_ROOT = 2.0 ** (1.0 / 3.0)

# Source: H. Yoshida, Construction of higher order symplectic integrators, Phys. Lett. A 150 (1990) 262; solutions A.
YOSHIDA_4 = composed(4, (1.0 / (2.0 - _CUBE_ROOT),))
YOSHIDA_6 = composed(6, (-1.17767998417887, 0.235573213359357, 0.784513610477560))
YOSHIDA_8 = composed(
    8,
    (
        -1.61582374150097,
        -2.44699182370524,
        -0.00716989419708120,
        2.44002732616735,
        0.157739928123617,
        1.82020630970714,
        1.04242620869991,
    ),
)

METHODS: dict[str, Method] = {
    "euler_cromer": EULER_CROMER,
    "velocity_verlet": VELOCITY_VERLET,
    "rk4": RK4,
    "yoshida4": YOSHIDA_4,
    "yoshida6": YOSHIDA_6,
    "yoshida8": YOSHIDA_8,
}


def routes(case: RacedScene, most: int) -> dict[str, MethodRoute]:
    """From half a contact time to where a run would ask for the force `most` times; a shorter step costs 1.4 times as much."""
    fewest = max(4.0, 2.0 * case.program.until / case.contact_time)
    return {name: _route(case, method, fewest, most) for name, method in METHODS.items()}


def _route(case: RacedScene, method: Method, fewest: float, most: int) -> MethodRoute:
    program = case.program

    def run(step: float) -> MethodAnswer:
        path = march(method, program.acceleration, program.x, program.v, step, round(program.until / step))
        return MethodAnswer(program.read(path.places[-1], path.velocities[-1]), path.evaluations)

    each = march(method, program.acceleration, program.x, program.v, 0.0, 8).evaluations / 8
    count = max(2, math.floor(math.log(most / each / fewest, RATIO)) + 1)
    steps = dict.fromkeys(program.until / round(fewest * RATIO**i) for i in range(count))
    return MethodRoute("step", tuple(steps), run)
