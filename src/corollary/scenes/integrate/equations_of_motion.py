"""Newton's second law for any scene: every force adds what it does to each body."""

from __future__ import annotations

import math
from collections.abc import Callable

from corollary.scenes.scene import Conserves, Scene, State, velocity


def masses_at(scene: Scene, time: float) -> list[float]:
    """The masses (kg) after what has been burnt and taken up."""
    masses = [body.mass for body in scene.bodies]
    for force in scene.forces:
        for i, rate in force.mass_rates:
            masses[i] += rate * time
    return masses


def law_of_motion(scene: Scene, since: State) -> Callable[[float, State], list[float]]:
    """The rate of change of the state at a time, for a step that begins at `since`."""
    count, axes = len(scene.bodies), scene.axes
    fixed = [math.isinf(body.mass) for body in scene.bodies]

    def rates(time: float, state: State) -> list[float]:
        masses = masses_at(scene, time)
        sums = [[0.0] * axes for _ in range(count)]
        for force in scene.forces:
            for i, newtons in force.act(scene, state, masses, since):
                sums[i] = [a + b for a, b in zip(sums[i], newtons, strict=True)]
        gained = [
            0.0 if still else f / m
            for total, m, still in zip(sums, masses, fixed, strict=True)
            for f in total
        ]
        return [*state[count * axes :], *gained]

    return rates


def kinetic(scene: Scene, time: float, state: State) -> float:
    """Kinetic energy (J) of the bodies that are not walls."""
    masses = masses_at(scene, time)
    return sum(
        0.5 * m * math.hypot(*velocity(scene, state, i)) ** 2
        for i, m in enumerate(masses)
        if not math.isinf(m)
    )


def energy(scene: Scene, time: float, state: State) -> float:
    """Kinetic energy and the potential energy (J) of all forces that have one."""
    stored = 0.0
    for force in scene.forces:
        stored += force.potential(scene, state)
    return kinetic(scene, time, state) + stored


def keeps_energy(scene: Scene) -> bool:
    """Whether no force and no moving wall takes or gives energy."""
    return Conserves.ENERGY in scene.conserves and scene.walls_at_rest
