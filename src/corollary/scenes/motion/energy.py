"""The momentum and the energies of a scene, who conserves them, and whether its bodies will ever meet."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from corollary.scenes.constraint import State
from corollary.scenes.scene import Conserves, Scene, overlap, seen_from, spin, start_of, velocity

if TYPE_CHECKING:
    from corollary.scenes.motion.system import Mode


def masses_at(scene: Scene, time: float) -> list[float]:
    """The masses (kg) after what has been burnt and taken up."""
    masses = [body.mass for body in scene.bodies]
    for force in scene.forces:
        for i, rate in force.mass_rates:
            masses[i] += rate * time
    return masses


def momentum(scene: Scene, time: float, state: State) -> tuple[float, ...]:
    """The sum of mass times velocity (kg m/s) over all bodies that are no walls, by components."""
    loose = [(i, m) for i, m in enumerate(masses_at(scene, time)) if not math.isinf(m)]
    return tuple(
        math.fsum(m * velocity(scene, state, i)[axis] for i, m in loose) for axis in range(scene.axes)
    )


def impulses(scene: Scene, before: State, after: State) -> tuple[float, ...]:
    """The change of momentum (kg m/s) of each body that is no wall, body after body."""
    loose = [i for i, body in enumerate(scene.bodies) if not math.isinf(body.mass)]
    changes = (
        (i, u, v)
        for i in loose
        for u, v in zip(velocity(scene, before, i), velocity(scene, after, i), strict=True)
    )
    return tuple(scene.bodies[i].mass * (v - u) for i, u, v in changes)


def kinetic(scene: Scene, time: float, state: State) -> float:
    """Kinetic energy (J) of the bodies that are not walls, and of the spins of all that can be turned."""
    masses = masses_at(scene, time)
    loose = [(i, m) for i, m in enumerate(masses) if not math.isinf(m)]
    straight = sum(0.5 * m * math.hypot(*velocity(scene, state, i)) ** 2 for i, m in loose)
    turning = [
        0.5 * body.resists_spin * spin(scene, state, i) ** 2
        for i, body in enumerate(scene.bodies)
        if scene.spins and not math.isinf(body.resists_spin)
    ]
    return straight + sum(turning)


def energy(scene: Scene, time: float, state: State) -> float:
    """Kinetic energy and the potential energy (J) of all forces that have one."""
    moving = kinetic(scene, time, state)
    if any(force.mass_rates for force in scene.forces):
        masses = masses_at(scene, time)
        scene = replace(
            scene,
            bodies=tuple(replace(b, mass=m) for b, m in zip(scene.bodies, masses, strict=True)),
            until=None,  # or what is left now would have to last as long again
        )
    return moving + sum(force.potential(scene, state) for force in scene.forces)


def keeps_energy(scene: Scene, mode: Mode | None = None) -> bool:
    """Whether no force and no moving wall takes or gives energy: at any time, or in a mode, between its hits."""
    if not scene.walls_at_rest:
        return False
    if mode is None:
        return Conserves.ENERGY in scene.conserves and not any(f.rubs_surfaces for f in scene.forces)
    steady = all(isinstance(s, str) for s in mode.rubbed)
    return steady and all(Conserves.ENERGY in f.conserves or f.does_no_work_at_rest for f in scene.forces)


def never_meets(scene: Scene, state: State, slow: float = 0.0) -> bool:
    """Whether nothing touches and no straight line leads to a touch, but for bodies that come no faster than `slow` (m/s)."""
    for force in scene.contacts:
        for a, b in force.serves(scene):
            depth, growing = overlap(scene, state, a, b)
            if depth > 0.0 or (growing > slow and _on_course(scene, state, a, b)):
                return False
    return True


def used_up(scene: Scene, time: float, state: State, share: float, fast: float) -> bool:
    """Whether bodies touch, and of the speed `fast` (m/s) no more than a share is left, of the first energy its square."""
    pairs = [pair for force in scene.contacts for pair in force.serves(scene)]
    rates = [rate for depth, rate in (overlap(scene, state, a, b) for a, b in pairs) if depth > 0.0]
    if not rates or max(map(abs, rates)) >= share * fast:
        return False
    stored = energy(scene, time, state) - kinetic(scene, time, state)
    return stored <= share**2 * kinetic(scene, 0.0, start_of(scene))


def _on_course(scene: Scene, state: State, a: int, b: int) -> bool:
    apart, relative = seen_from(scene, state, a, b)
    speed = math.hypot(*relative)
    if speed == 0.0:
        return False
    along = sum(x * (v / speed) for x, v in zip(apart, relative, strict=True))
    after = max(-along / speed, 0.0)
    nearest = math.hypot(*(x + v * after for x, v in zip(apart, relative, strict=True)))
    return nearest < scene.bodies[a].radius + scene.bodies[b].radius
