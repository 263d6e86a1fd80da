"""The ball that meets the floor to race on (example 12.3.1): where it is and how fast, 5.5 ms after the start."""

from __future__ import annotations

from corollary.derive.ready_scenes import run
from corollary.scenes.models.two_bodies import contact_time
from corollary.trade.raced_scene import BALL, ONCE, MethodAnswer, MethodRoute, RacedScene, State, StepProgram

MASS, STIFFNESS, RADIUS, WEIGHT = 0.1, 1e6, 0.02, 9.8
HEIGHT, SPEED, UNTIL = 0.021, -2.8, 5.5e-3


def _acceleration(x: State, v: State) -> list[float]:
    overlap = RADIUS - x[0]
    return [STIFFNESS * overlap**1.5 / MASS - WEIGHT if overlap > 0.0 else -WEIGHT]


def _from_integrals(_: float) -> MethodAnswer:
    found = run("ball_on_floor", {})
    rebound, duration = found.observed["rebound_speed"], found.observed["duration"]
    assert isinstance(rebound, float)
    assert isinstance(duration, float)
    free = UNTIL - (rebound + SPEED) / WEIGHT - duration
    return MethodAnswer(
        (RADIUS + rebound * free - 0.5 * WEIGHT * free**2, rebound - WEIGHT * free), found.evaluations
    )


def cases() -> tuple[RacedScene, ...]:
    contact = contact_time(MASS, STIFFNESS, 1.5, -SPEED)
    return (
        RacedScene(
            name="ball_on_floor",
            ready="ball_on_floor",
            settings={},
            observable="height and velocity after the bounce",
            reference=BALL,
            scales=(-SPEED * contact, -SPEED),
            contact_time=contact,
            program=StepProgram(
                x=(HEIGHT,),
                v=(SPEED,),
                acceleration=_acceleration,
                until=UNTIL,
                switches=(lambda y: RADIUS - y[0],),
                read=lambda x, v: (x[0], v[0]),
            ),
            own={"quadrature": MethodRoute("tolerance", ONCE, _from_integrals)},
        ),
    )
