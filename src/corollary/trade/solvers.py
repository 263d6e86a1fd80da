"""Adaptive solvers of scipy as routes through a program: as they come, and started anew at every event."""

# pyright: reportUnknownArgumentType=false, reportUnknownMemberType=false, reportUnknownVariableType=false

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from functools import partial
from typing import Any, Literal

from corollary.trade.raced_scene import TOLERANCES, MethodAnswer, MethodRoute, RacedScene, StepProgram

MOST_EVENTS = 100
WANTING = "scipy is not installed (pip install scipy)"


def routes(case: RacedScene) -> dict[str, MethodRoute]:
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
