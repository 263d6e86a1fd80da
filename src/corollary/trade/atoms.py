"""The atom in its well to race on (project 12.15): caught, for three swings of its distance, and getting away."""

from __future__ import annotations

import math

from corollary.derive.ready_scenes import run
from corollary.trade.raced_scene import (
    ATOM_BOUND,
    ATOM_ESCAPING,
    ONCE,
    MethodAnswer,
    MethodRoute,
    RacedScene,
    State,
    StepProgram,
)

PULL, BOTTOM, EDGE = 50.0, 1.0, 1.4
SLOW, FAST = 3.0, 5.0
# The radial period and the time of the escape, from the references.
PERIOD, ESCAPE = 0.76670266239329692, 0.22476141105416518


def _acceleration(x: State, v: State) -> list[float]:
    r = math.hypot(x[0], x[1])
    if r >= EDGE:
        return [0.0, 0.0]
    pull = -PULL * (r - BOTTOM) / r
    return [pull * x[0], pull * x[1]]


def program(speed: float, until: float) -> StepProgram:
    return StepProgram(
        x=(BOTTOM, 0.0),
        v=(0.0, speed),
        acceleration=_acceleration,
        until=until,
        switches=(lambda y: EDGE - math.hypot(y[0], y[1]),),
        read=lambda x, v: tuple(v),
    )


def _turned(_: float) -> MethodAnswer:
    """After each period the start is back, turned by the same angle."""
    found = run("atom", {"v0": SLOW})
    angle = found.observed["angle"]
    assert isinstance(angle, float)
    return MethodAnswer((-SLOW * math.sin(3.0 * angle), SLOW * math.cos(3.0 * angle)), found.evaluations)


def _left(_: float) -> MethodAnswer:
    found = run("atom", {"v0": FAST})
    velocities = found.observed["velocities"]
    assert isinstance(velocities, tuple)
    return MethodAnswer(velocities, found.evaluations)


def cases() -> tuple[RacedScene, ...]:
    return (
        RacedScene(
            name="atom bound",
            ready="atom",
            settings={"v0": SLOW},
            observable="velocity after three radial periods",
            reference=ATOM_BOUND,
            scales=(SLOW, SLOW),
            contact_time=PERIOD,
            program=program(SLOW, 3.0 * PERIOD),
            own={"quadrature": MethodRoute("tolerance", ONCE, _turned)},
        ),
        RacedScene(
            name="atom escaping",
            ready="atom",
            settings={"v0": FAST},
            observable="velocity far away",
            reference=ATOM_ESCAPING,
            scales=(FAST, FAST),
            contact_time=ESCAPE,
            program=program(FAST, 1.5 * ESCAPE),
            own={"quadrature": MethodRoute("tolerance", ONCE, _left)},
        ),
    )
