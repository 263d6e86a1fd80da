"""The race: every route of a scene run with every setting, with its error, its evaluations and its seconds."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from dataclasses import dataclass

from corollary.derive.ready_scenes import run
from corollary.scenes.run import GuardFailed
from corollary.trade import atoms, colliding_spheres, cradles, falling_ball, methods, solvers
from corollary.trade.raced_scene import Knob, MethodRoute, RacedScene, error_of

MOST, MOST_QUICK = 8_000, 700
# Beyond this nothing can be learned from doubles.
ENOUGH = 4e-16
SHORT = 4e-3

PLANNED = {
    "conservation": "conservation",
    "quadrature": "quadrature",
    "integration": "regularised",
}
"""The planner's models by the names their routes have here."""


@dataclass(frozen=True, slots=True)
class Timing:
    """One run: `setting` is a step (s) or a tolerance; `error` is in natural sizes, `seconds` are the processor's."""

    method: str
    knob: Knob
    setting: float
    error: float
    evaluations: int
    seconds: float


@dataclass(frozen=True, slots=True)
class WorkPrecision:
    """All timings of a scene, which method the planner takes there, and what could not run, with the reason."""

    case: RacedScene
    timings: tuple[Timing, ...]
    planned: str
    missing: Mapping[str, str]


def cases() -> tuple[RacedScene, ...]:
    return (*cradles.cases(), *colliding_spheres.cases(), *falling_ball.cases(), *atoms.cases())


def race(case: RacedScene, quick: bool = False) -> WorkPrecision:
    """Every method on one scene; `quick` leaves out the longest runs and times each one once."""
    bought = solvers.routes(case)
    ways = {**case.own, **methods.routes(case, MOST_QUICK if quick else MOST), **bought}
    missing = {} if bought else {"scipy": solvers.WANTING}
    timings: list[Timing] = []
    for name, route in ways.items():
        try:
            timings += _timings(case, name, route, quick)
        except GuardFailed as refused:
            missing[name] = str(refused)
    return WorkPrecision(case, tuple(timings), PLANNED[run(case.ready, case.settings).model], missing)


def _timings(case: RacedScene, name: str, route: MethodRoute, quick: bool) -> list[Timing]:
    found: list[Timing] = []
    _timed(case, route, route.settings[0], 1)  # the first run pays for imports
    for setting in route.settings[:: 2 if quick and route.knob == "tolerance" else 1]:
        error, evaluations, seconds = _timed(case, route, setting, 1 if quick else 3)
        found.append(Timing(name, route.knob, setting, error, evaluations, seconds))
        if error < ENOUGH:
            break
    return found


def _timed(case: RacedScene, route: MethodRoute, setting: float, most: int) -> tuple[float, int, float]:
    """Error, evaluations, and the least time of a few runs; a run whose numbers leave all range has an infinite error."""
    seconds, error, evaluations = math.inf, math.inf, 0
    for _ in range(most):
        begin = (
            time.thread_time()
        )  # and not the time of day: what else the machine does is none of our business
        try:
            answer = route.run(setting)
            error, evaluations = error_of(case, answer), answer.evaluations
        except (OverflowError, ZeroDivisionError):
            error = math.inf
        seconds = min(seconds, time.thread_time() - begin)
        if seconds > SHORT:
            break
    return (error if math.isfinite(error) else math.inf), evaluations, seconds
