"""Where the law of motion changes: values whose sign says whether a contact, an edge or a wall has been reached."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.wall import HardWall, bounced, clearance
from corollary.scenes.forces.well import Well
from corollary.scenes.integrate.equations_of_motion import overlap, pairs, place, velocity
from corollary.scenes.scene import Scene

State = Sequence[float]


@dataclass(frozen=True, slots=True)
class Switch:
    """`value` changes its sign; `turn` then gives the new velocity of `body`, for what acts in no time."""

    value: Callable[[State], float]
    body: int = -1
    turn: Callable[[State], list[float]] | None = None


def switches_of(scene: Scene) -> list[Switch]:
    """Everything in a scene that begins or ends at a place or a velocity."""
    found: list[Switch] = []
    for force in scene.forces:
        if isinstance(force, Contact):
            found += [Switch(lambda y, a=a, b=b: overlap(scene, y, a, b)[0]) for a, b in pairs(scene)]
        for i, body in enumerate(scene.bodies):
            if math.isinf(body.mass):
                continue
            if isinstance(force, Well):
                found.append(Switch(lambda y, i=i, f=force: f.edge - math.hypot(*place(scene, y, i))))
                found.append(_core(scene, force, i))
            if isinstance(force, HardWall):
                found.append(_wall(scene, force, i))
            if isinstance(force, Friction) and force.body == i:
                found.append(_stop(scene, i))
    return found


def _wall(scene: Scene, wall: HardWall, i: int) -> Switch:
    radius = scene.bodies[i].radius
    return Switch(
        lambda y: clearance(wall, place(scene, y, i), radius),
        i,
        lambda y: bounced(wall, velocity(scene, y, i)),
    )


def _core(scene: Scene, well: Well, i: int) -> Switch:
    """The hard core of a well is a wall square to the radius."""

    def turn(y: State) -> list[float]:
        x = place(scene, y, i)
        r = math.hypot(*x)
        return bounced(HardWall(tuple(c / r for c in x)), velocity(scene, y, i))

    return Switch(lambda y: math.hypot(*place(scene, y, i)) - well.wall, i, turn)


def _stop(scene: Scene, i: int) -> Switch:
    """Friction ends when the velocity has turned against the one the body set out with."""
    start = scene.bodies[i].velocity
    return Switch(
        lambda y: sum(a * b for a, b in zip(start, velocity(scene, y, i), strict=True)),
        i,
        lambda _: [0.0] * scene.axes,
    )
