"""What collisions keep or share out: momentum, energy, impulse; and what of a scene follows from conservation alone."""

from __future__ import annotations

import math
from collections.abc import Collection

from corollary.scenes.motion.energy import energy, keeps_energy, kinetic, masses_at
from corollary.scenes.run import Observable, Observed
from corollary.scenes.scene import Conserves, Scene, State, overlap, pairs, start_of, velocity


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


def conserved(scene: Scene, observe: Collection[Observable]) -> dict[Observable, Observed]:
    """Those of the things asked for that the start already says: no motion has to be followed for them."""
    start = start_of(scene)
    known: dict[Observable, Observed] = {}
    if Observable.MOMENTUM in observe and _isolated(scene):
        known[Observable.MOMENTUM] = momentum(scene, 0.0, start)
    if Observable.ENERGY in observe and keeps_energy(scene):
        known[Observable.ENERGY] = energy(scene, 0.0, start)
    if Observable.ENERGY_RATIO in observe and parts_undamped(scene) and kinetic(scene, 0.0, start) > 0.0:
        known[Observable.ENERGY_RATIO] = 1.0
    return known


def parts_undamped(scene: Scene) -> bool:
    """Whether the scene is undamped contacts that begin at a touch: all they take up they have given back when the bodies part."""
    if scene.until is not None or not scene.forces or not scene.walls_at_rest:
        return False
    if scene.contacts != scene.forces or Conserves.ENERGY not in scene.conserves:
        return False
    return all(overlap(scene, start_of(scene), a, b)[0] <= 0.0 for a, b in pairs(scene))


def _isolated(scene: Scene) -> bool:
    """Whether bodies act on each other only, and none of them is a wall."""
    return Conserves.MOMENTUM in scene.conserves and not any(math.isinf(body.mass) for body in scene.bodies)
