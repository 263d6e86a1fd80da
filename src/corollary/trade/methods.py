"""Methods of the race: fixed steps (Euler-Cromer, velocity Verlet, RK4, Yoshida of order 4, 6 and 8), and adaptive ones of scipy."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import importlib.util
import math
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Literal

from corollary.grading.programs.fixed_step import EULER_CROMER, RK4, Method, Splitting, march
from corollary.trade.raced_scene import TOLERANCES, MethodAnswer, MethodRoute, RacedScene, StepProgram

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


MOST_EVENTS = 100
WANTING = "scipy is not installed (pip install scipy)"


def solver_routes(case: RacedScene) -> dict[str, MethodRoute]:
    """DOP853 and LSODA with relative tolerance, and the same times the natural sizes as absolute one; none without scipy."""
    if importlib.util.find_spec("scipy") is None:
        return {}
    asked = [1e2 * tolerance for tolerance in TOLERANCES if tolerance > 2e-14]
    return {
        "scipy_dop853": MethodRoute("tolerance", tuple(asked), partial(_straight, case.program, "DOP853")),
        "scipy_lsoda": MethodRoute("tolerance", tuple(asked), partial(_straight, case.program, "LSODA")),
        "scipy_dop853_events": MethodRoute(
            "tolerance", tuple(asked), partial(_from_event_to_event, case.program)
        ),
    }


def _law(program: StepProgram) -> Callable[[float, Any], list[float]]:
    count = len(program.x)

    def law(_: float, y: Any) -> list[float]:
        state = y.tolist()
        return [*state[count:], *program.acceleration(state[:count], state[count:])]

    return law


def _sizes(program: StepProgram, tolerance: float) -> list[float]:
    """Absolute tolerances: of the way gone at the largest speed, and of that speed."""
    fast = max(map(abs, program.v))
    return [tolerance * fast * program.until] * len(program.x) + [tolerance * fast] * len(program.v)


def _straight(program: StepProgram, method: Literal["DOP853", "LSODA"], tolerance: float) -> MethodAnswer:
    from scipy.integrate import solve_ivp

    start, count = [*program.x, *program.v], len(program.x)
    sizes = _sizes(program, tolerance)
    found = solve_ivp(
        _law(program), (0.0, program.until), start, method, rtol=max(tolerance, 3e-14), atol=sizes
    )
    last = found.y[:, -1].tolist()
    return MethodAnswer(program.read(last[:count], last[count:]), found.nfev)


def _from_event_to_event(program: StepProgram, tolerance: float) -> MethodAnswer:
    """Stops at each switch and starts anew beyond it; a switch that is on is watched falling, one that is off rising."""
    from scipy.integrate import solve_ivp

    law, count, sizes = _law(program), len(program.x), _sizes(program, tolerance)
    time, state, spent = 0.0, [*program.x, *program.v], 0
    ahead = [y + 1e-9 * program.until * rate for y, rate in zip(state, [*program.v, *program.v], strict=True)]
    on = [
        switch(state) > 0.0 or (switch(state) == 0.0 and switch(ahead) >= 0.0) for switch in program.switches
    ]
    for _ in range(MOST_EVENTS):
        watched = [_watched(switch, on[i]) for i, switch in enumerate(program.switches)]
        found = solve_ivp(
            law,
            (time, program.until),
            state,
            "DOP853",
            rtol=max(tolerance, 3e-14),
            atol=sizes,
            events=watched,
        )
        time, state, spent = float(found.t[-1]), found.y[:, -1].tolist(), spent + found.nfev
        if found.status != 1:
            break
        fired = next(i for i, times in enumerate(found.t_events) if len(times))
        on[fired] = not on[fired]
    return MethodAnswer(program.read(state[:count], state[count:]), spent)


def _watched(switch: Callable[[Any], float], on: bool) -> Callable[[float, Any], float]:
    def event(_: float, y: Any) -> float:
        return switch(y)

    event.terminal = True  # pyright: ignore[reportFunctionMemberAccess]
    event.direction = -1.0 if on else 1.0  # pyright: ignore[reportFunctionMemberAccess]
    return event
