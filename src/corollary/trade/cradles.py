"""Newton's cradle to race on: the chapter's balls, three and five of them, with springs, Hertz contacts and stiffer ones."""

from __future__ import annotations

import importlib.util

from corollary.scenes.forces.contact import Contact
from corollary.scenes.integrate import regularised
from corollary.scenes.models.two_bodies import contact_time
from corollary.scenes.row import RowOfBodies, RowResult
from corollary.trade.raced_scene import (
    CRADLE_3_CUBIC,
    CRADLE_3_HERTZ,
    CRADLE_3_SPRINGS,
    CRADLE_5_HERTZ,
    TOLERANCES,
    MethodAnswer,
    MethodRoute,
    RacedScene,
    Reference,
    State,
    StepProgram,
)

MASS, STIFFNESS, SPEED = 0.1, 1e4, 1.0


def line(count: int, q: float) -> RowOfBodies:
    """The chapter's balls in a row, all touching; the first comes in."""
    velocities = (SPEED,) + (0.0,) * (count - 1)
    return RowOfBodies(
        (MASS,) * count, velocities, (0.0,) * (count - 1), (Contact(STIFFNESS, q),) * (count - 1)
    )


def program(count: int, q: float, until: float) -> StepProgram:
    """As in project 12.14: displacements from the places where the balls just touch."""

    def acceleration(x: State, v: State) -> list[float]:
        gained, left = list[float](), 0.0
        for i in range(count - 1):
            overlap = x[i] - x[i + 1]
            right = STIFFNESS * overlap**q if overlap > 0.0 else 0.0
            gained.append((left - right) / MASS)
            left = right
        return [*gained, left / MASS]

    return StepProgram(
        x=(0.0,) * count,
        v=(SPEED,) + (0.0,) * (count - 1),
        acceleration=acceleration,
        until=until,
        switches=tuple(lambda y, i=i: y[i] - y[i + 1] for i in range(count - 1)),
        read=lambda x, v: tuple(v),
    )


def case(count: int, q: float, reference: Reference) -> RacedScene:
    row = line(count, q)
    own = {
        "regularised": MethodRoute(
            "tolerance", TOLERANCES, lambda tolerance: _answer(regularised.collide(row, tolerance))
        )
    }
    if importlib.util.find_spec("numba") is not None:
        own["regularised_compiled"] = MethodRoute(
            "tolerance", TOLERANCES, lambda tolerance: _compiled(row, tolerance)
        )
    # All balls are apart well before this: the wave has passed every contact.
    pair = contact_time(0.5 * MASS, STIFFNESS, q, SPEED)
    return RacedScene(
        name=f"cradle N={count} q={q:g}",
        ready="cradle",
        settings={"N": float(count), "q": q},
        observable="velocities",
        reference=reference,
        scales=(SPEED,) * count,
        contact_time=pair,
        program=program(count, q, 1.1 * regularised.collide(row, 1e-8).duration),
        own=own,
    )


def _answer(passage: RowResult) -> MethodAnswer:
    return MethodAnswer(passage.velocities, passage.evaluations)


def _compiled(row: RowOfBodies, tolerance: float) -> MethodAnswer:
    return _answer(regularised.collide(row, tolerance, compiled=True))


def cases() -> tuple[RacedScene, ...]:
    return (
        case(3, 1.0, CRADLE_3_SPRINGS),
        case(3, 1.5, CRADLE_3_HERTZ),
        case(3, 3.0, CRADLE_3_CUBIC),
        case(5, 1.5, CRADLE_5_HERTZ),
    )
