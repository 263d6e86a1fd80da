"""Newton's second law for any scene: every force adds what it does to each body.

A state is (all places, all velocities), body after body.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import assert_never

from corollary.scenes.forces import absorption, contact, friction, inverse_square, spring, thrust, well
from corollary.scenes.forces.absorption import Absorption
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.inverse_square import InverseSquare
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.thrust import Thrust
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.forces.well import Well
from corollary.scenes.scene import Force, Scene

State = Sequence[float]


def start_of(scene: Scene) -> list[float]:
    """The state at time zero."""
    return [x for body in scene.bodies for x in body.place] + [
        v for body in scene.bodies for v in body.velocity
    ]


def place(scene: Scene, state: State, i: int) -> State:
    return state[scene.axes * i : scene.axes * (i + 1)]


def velocity(scene: Scene, state: State, i: int) -> State:
    start = scene.axes * (len(scene.bodies) + i)
    return state[start : start + scene.axes]


def seen_from(scene: Scene, state: State, a: int, b: int) -> tuple[list[float], list[float]]:
    """Place and velocity of body b seen from body a."""
    apart = [y - x for x, y in zip(place(scene, state, a), place(scene, state, b), strict=True)]
    relative = [y - x for x, y in zip(velocity(scene, state, a), velocity(scene, state, b), strict=True)]
    return apart, relative


def overlap(scene: Scene, state: State, a: int, b: int) -> tuple[float, float]:
    """How deep two bodies are in each other, and how fast that grows."""
    apart, relative = seen_from(scene, state, a, b)
    distance = math.hypot(*apart)
    growing = -sum(x * v for x, v in zip(apart, relative, strict=True)) / distance if distance else 0.0
    return scene.bodies[a].radius + scene.bodies[b].radius - distance, growing


def pairs(scene: Scene) -> Iterator[tuple[int, int]]:
    """Every two bodies that can touch."""
    for a, first in enumerate(scene.bodies):
        for b, second in enumerate(scene.bodies[a + 1 :], start=a + 1):
            if first.radius + second.radius > 0.0 and not (
                math.isinf(first.mass) and math.isinf(second.mass)
            ):
                yield a, b


def masses_at(scene: Scene, time: float) -> list[float]:
    """The masses (kg) after what has been burnt and taken up."""
    masses = [body.mass for body in scene.bodies]
    for force in scene.forces:
        if isinstance(force, Thrust):
            masses[force.body] -= force.burn * time
        elif isinstance(force, Absorption):
            masses[force.body] += force.rate * time
    return masses


def law_of_motion(scene: Scene, since: State) -> Callable[[float, State], list[float]]:
    """The rate of change of the state at a time, for a step that begins at `since`.

    A body that is inside the edge of a well then feels it to the end of the step: the stages of a step that ends at the edge
    reach over it, and a force that jumps within a step would cost the method its order.
    """
    count, axes = len(scene.bodies), scene.axes
    fixed = [math.isinf(body.mass) for body in scene.bodies]
    wells = [force for force in scene.forces if isinstance(force, Well)]
    held = [
        (force, i)
        for force in wells
        for i in range(count)
        if math.hypot(*place(scene, since, i)) < force.edge
    ]

    def slope(time: float, state: State) -> list[float]:
        masses = masses_at(scene, time)
        pulls = [[0.0] * axes for _ in range(count)]
        for force in scene.forces:
            _add(force, scene, state, masses, pulls)
        for force, i in held:
            _pull_on(pulls, i, well.pull(force, place(scene, state, i)))
        gained = [
            0.0 if still else f / m for pull, m, still in zip(pulls, masses, fixed, strict=True) for f in pull
        ]
        return [*state[count * axes :], *gained]

    return slope


def _add(force: Force, scene: Scene, state: State, masses: list[float], pulls: list[list[float]]) -> None:
    match force:
        case Weight(g=g):
            for pull, m in zip(pulls, masses, strict=True):
                pull[-1] -= m * g
        case Contact():
            for a, b in pairs(scene):
                _push_apart(pulls, a, b, contact_force(force, scene, state, a, b))
        case Spring(ends=(a, b)):
            _push_apart(pulls, b, a, spring.pull(force, *seen_from(scene, state, a, b)))
        case InverseSquare(ends=(a, b)):
            _push_apart(pulls, b, a, inverse_square.pull(force, seen_from(scene, state, a, b)[0]))
        case Friction(body=i):
            _pull_on(pulls, i, friction.drag(force, masses[i], velocity(scene, state, i)))
        case Thrust(body=i):
            _pull_on(pulls, i, thrust.push(force))
        case Absorption(body=i):
            _pull_on(pulls, i, absorption.drag(force, velocity(scene, state, i)))
        case Well():
            pass  # felt by the bodies that a step begins with inside its edge
        case HardWall():
            pass  # acts in no time at all: the step that meets it turns the velocity round
        case _:
            assert_never(force)


def contact_force(force: Contact, scene: Scene, state: State, a: int, b: int) -> list[float]:
    """The force on b of a contact with a: the push along the line of centres, the drag along the relative velocity."""
    depth, _ = overlap(scene, state, a, b)
    if depth <= 0.0:
        return [0.0] * scene.axes
    apart, relative = seen_from(scene, state, a, b)
    distance, push = math.hypot(*apart), contact.push(force, depth, 0.0)
    return [push * x / distance - force.eta * v for x, v in zip(apart, relative, strict=True)]


def _pull_on(pulls: list[list[float]], i: int, force: Sequence[float]) -> None:
    pulls[i] = [p + f for p, f in zip(pulls[i], force, strict=True)]


def _push_apart(pulls: list[list[float]], a: int, b: int, on_b: Sequence[float]) -> None:
    _pull_on(pulls, b, on_b)
    _pull_on(pulls, a, [-f for f in on_b])


def kinetic(scene: Scene, time: float, state: State) -> float:
    """Kinetic energy (J) of the bodies that are not walls."""
    masses = masses_at(scene, time)
    return sum(
        0.5 * m * math.hypot(*velocity(scene, state, i)) ** 2
        for i, m in enumerate(masses)
        if not math.isinf(m)
    )


def potential(scene: Scene, state: State) -> float | None:
    """Potential energy (J); none when a force of the scene takes or gives energy."""
    total = 0.0
    for force in scene.forces:
        match force:
            case Weight(g=g):
                loose = [(i, body.mass) for i, body in enumerate(scene.bodies) if not math.isinf(body.mass)]
                total += sum(m * g * place(scene, state, i)[-1] for i, m in loose)
            case Contact(eta=0.0):
                total += sum(contact.stored(force, overlap(scene, state, a, b)[0]) for a, b in pairs(scene))
            case Well():
                total += sum(well.stored(force, place(scene, state, i)) for i in range(len(scene.bodies)))
            case Spring(ends=(a, b), damping=0.0):
                total += spring.stored(force, seen_from(scene, state, a, b)[0])
            case InverseSquare(ends=(a, b)):
                total += inverse_square.stored(force, seen_from(scene, state, a, b)[0])
            case HardWall(restitution=1.0):
                pass
            case _:
                return None
    return total
