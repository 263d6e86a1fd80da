"""The race: every route of a scene with every setting, its error, evaluations and seconds; orders of convergence, frontier, cheapest method."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from corollary.derive.ready_scenes import run
from corollary.scenes.run import GuardFailed
from corollary.trade import atoms, colliding_spheres, cradles, falling_ball, methods
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
    bought = methods.solver_routes(case)
    ways = {**case.own, **methods.routes(case, MOST_QUICK if quick else MOST), **bought}
    missing = {} if bought else {"scipy": methods.WANTING}
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


WANTED = (1e-3, 1e-6, 1e-9, 1e-12)
# Errors above are not yet in the range where a power law holds, errors below are rounding.
COARSE, FINE = 3e-2, 3e-13
LIE = 1e-2
# So many points, and so many standard errors of the bend, before a bent line is believed rather than a straight one.
POINTS_ENOUGH, SURE = 6, 4.0


@dataclass(frozen=True, slots=True)
class Order:
    """The slope of log error against log step, and two standard errors on both sides of it."""

    value: float
    low: float
    high: float


def orders(raced: WorkPrecision) -> dict[str, Order]:
    """For each method in steps that met the power law in four runs at least."""
    found: dict[str, Order] = {}
    for method in dict.fromkeys(timing.method for timing in raced.timings if timing.knob == "step"):
        points = [(timing.setting, timing.error) for timing in raced.timings if timing.method == method]
        inside = _asymptotic(points)
        if len(inside) >= 4:
            found[method] = at_the_fine_end(inside)
    return found


def _asymptotic(points: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """The shorter half of the steps, and four at least, among those whose error is neither coarse nor rounding."""
    inside: list[tuple[float, float]] = []
    for step, error in points:
        if error < FINE:
            break
        if error < COARSE:
            inside.append((step, error))
        else:
            inside.clear()
    return inside[-max(4, (len(inside) + 1) // 2) :]


def fitted(points: Sequence[tuple[float, float]]) -> Order:
    """The straight line through the logarithms, by least squares."""
    return _slope([math.log(step) for step, _ in points], [math.log(error) for _, error in points], 2)[0]


def at_the_fine_end(points: Sequence[tuple[float, float]]) -> Order:
    """The slope that steps of no length would show: of log error = log C + order log step + bend step, where the points bend.

    An error C h^p (1 + a h) has local slopes p + a h: a straight line through it is off by what the coarse steps add. Where the
    bend is not clearly more than the points' own scatter, the straight line stands.
    """
    steps = [step for step, _ in points]
    xs, ys = [math.log(step) for step in steps], [math.log(error) for _, error in points]
    straight, left = _slope(xs, ys, 2)
    if len(points) < POINTS_ENOUGH:
        return straight
    bent, still = _slope(_beside(xs, steps), _beside(ys, steps), 3)
    return bent if left - still > SURE**2 * still / (len(points) - 3) else straight


def _slope(xs: Sequence[float], ys: Sequence[float], fitted_numbers: int) -> tuple[Order, float]:
    """The slope, and the sum of the squares of what is left."""
    n, x, y = len(xs), math.fsum(xs) / len(xs), math.fsum(ys) / len(ys)
    spread = math.fsum((a - x) ** 2 for a in xs)
    slope = math.fsum((a - x) * (b - y) for a, b in zip(xs, ys, strict=True)) / spread
    left = math.fsum((b - y - slope * (a - x)) ** 2 for a, b in zip(xs, ys, strict=True))
    error = 2.0 * math.sqrt(left / (n - fitted_numbers) / spread)
    return Order(slope, slope - error, slope + error), left


def _beside(values: Sequence[float], by: Sequence[float]) -> list[float]:
    """What of some values a straight line in others does not explain."""
    along = _slope(by, values, 2)[0].value
    return [value - along * other for value, other in zip(values, by, strict=True)]


def reaching(raced: WorkPrecision, wanted: float) -> dict[str, Timing]:
    """For each method its cheapest run that is as exact as wanted; so must be every finer run, a lucky hit does not count."""
    found: dict[str, Timing] = {}
    for method in dict.fromkeys(timing.method for timing in raced.timings):
        timings = [timing for timing in raced.timings if timing.method == method]
        for timing in reversed(timings):
            # Rounding may lift the finest runs a little above the error of coarser ones.
            if timing.error > max(wanted, 1e-13):
                break
            if timing.error <= wanted:
                found[method] = timing
    return found


def cheapest(raced: WorkPrecision, wanted: float) -> Timing | None:
    """The run that takes the least time among those as exact as wanted."""
    return min(reaching(raced, wanted).values(), key=lambda timing: timing.seconds, default=None)


def frontier(raced: WorkPrecision) -> list[Timing]:
    """The runs that no other one beats in both error and time, the quickest first."""
    best, found = math.inf, list[Timing]()
    for timing in sorted(raced.timings, key=lambda timing: (timing.seconds, timing.error)):
        if timing.error < best:
            best = timing.error
            found.append(timing)
    return found


def lies_beyond(raced: WorkPrecision, method: str = "euler_cromer") -> float | None:
    """The longest step, as a part of the contact time, up to which every run stays within one per cent."""
    honest = None
    for timing in reversed([timing for timing in raced.timings if timing.method == method]):
        if timing.error > LIE:
            break
        honest = timing.setting / raced.case.contact_time
    return honest


def record(raced: WorkPrecision) -> dict[str, Any]:
    """Reference, runs, orders, frontier, the cheapest method for each accuracy, and the planner's choice."""
    case, measured = raced.case, orders(raced)
    best = {label(wanted): cheapest(raced, wanted) for wanted in WANTED}
    honest = lies_beyond(raced)
    return {
        "scene": case.name,
        "ready": case.ready,
        "settings": dict(case.settings),
        "observable": case.observable,
        "reference": {
            "value": list(case.reference.values),
            "digits": case.reference.digits,
            "source": case.reference.source,
        },
        "contact_time": case.contact_time,
        "runs": [timing_record(timing) for timing in raced.timings],
        "order": {method: round(order.value, 3) for method, order in measured.items()},
        "order_bounds": {
            method: [round(order.low, 3), round(order.high, 3)] for method, order in measured.items()
        },
        "cheapest": {wanted: timing.method if timing else None for wanted, timing in best.items()},
        "cheapest_runs": {
            wanted: timing_record(timing) if timing else None for wanted, timing in best.items()
        },
        "frontier": [timing_record(timing) for timing in frontier(raced)],
        "lies_beyond": {"euler_cromer": honest},
        "planned": raced.planned,
        "missing": dict(raced.missing),
    }


def label(wanted: float) -> str:
    """1e-3, as the contract writes it."""
    return f"1e{round(math.log10(wanted))}"


def timing_record(timing: Timing) -> dict[str, Any]:
    error = timing.error if math.isfinite(timing.error) else "inf"
    return {
        "method": timing.method,
        timing.knob: timing.setting,
        "error": error,
        "evaluations": timing.evaluations,
        "seconds": timing.seconds,
    }
