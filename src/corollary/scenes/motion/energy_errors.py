"""Errors of energies: from places and velocities, from losses of a run, and from a potential that is not given."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from corollary.scenes.forces.function import ForceFunction
from corollary.scenes.motion.conserved import (
    energy,
    energy_terms,
    keeps_energy,
    kinetic,
    kinetic_off,
    potential_off,
    rounding_of_energy,
)
from corollary.scenes.motion.path import Stretch, Trajectory
from corollary.scenes.run import GuardFailed, Measurement, Observable
from corollary.scenes.scene import Scene, start_of, velocity

_PLACES, _WEIGHTS = np.polynomial.legendre.leggauss(8)
NODES, WEIGHTS = (1.0 + _PLACES) / 2.0, _WEIGHTS / 2.0
"""Of a Gauss quadrature over a step."""
MISSED = 1e-3
"""A potential that differs from the work of its function by a larger share is another function's."""
LITTLE = 1e-6
"""A part of the scene's energy too small to tell it from."""


def energy_off(
    scene: Scene,
    path: Trajectory,
    what: Observable,
    steps: float,
    rounded: float,
    sizes: Mapping[Observable, float],
) -> float:
    """What energies are off since the places and velocities at the end are: by parts of their sizes, and by what is not sure of velocities."""
    time, y = path.time, path.state
    if what is Observable.ENERGY_RATIO and path.dropped:
        return kinetic_off(scene, time, y, path.dropped) / kinetic(scene, 0.0, start_of(scene))
    if what is not Observable.ENERGY:
        return 0.0
    fast, long = sizes[Observable.VELOCITIES], sizes[Observable.TRAJECTORY]
    several = 3.0 if path.fades else 1.0  # places keep what velocities forget
    far = several * steps * min(long, 30.0 * path.deep) + rounded * long
    moving = kinetic_off(scene, time, y, (steps + rounded) * fast + path.dropped)
    return moving + potential_off(scene, time, y, far) + undecided(scene, path, sizes[what])


def hottest(scene: Scene, path: Trajectory) -> float:
    """The largest kinetic energy (J) at the end of any step."""
    return max(kinetic(scene, 0.0, y) for y in (start_of(scene), *(s.after for s in path.stretches)))


def energy_lost(scene: Scene, path: Trajectory, hot: float) -> float:
    """What a run has lost or gained of an energy (J) that is kept, as a share of velocities: so much of them is wrong, at least.

    Two runs may be off alike where a force is steep for a moment; what is kept does not depend on another run. What is at rest is known
    as well as rounding of its energy lets it be.
    """
    if not hot or not keeps_energy(scene):
        return 0.0
    start = start_of(scene)
    lost = abs(energy(scene, path.time, path.state) - energy(scene, 0.0, start))
    lost = max(lost - rounding_of_energy(scene, start) - rounding_of_energy(scene, path.state), 0.0)
    light = min(b.mass for b in scene.bodies if not math.isinf(b.mass)) if lost else 1.0
    return min(lost / (2.0 * hot), math.sqrt(2.0 * lost / light) / path.fast)


def conserved(scene: Scene, path: Trajectory, why: str) -> Measurement:
    """The energy that a scene keeps: that of its start, and off as far as the run was from it at the ends of steps, and that again between."""
    start = start_of(scene)
    begun = energy(scene, 0.0, start)
    off = max((abs(energy(scene, s.begin + s.lasts, s.after) - begun) for s in path.stretches), default=0.0)
    off = 2.0 * off + rounding_of_energy(scene, start)
    return Measurement(begun, off, "estimate", "integration", why, energy_terms(scene, 0.0, start))


def undecided(scene: Scene, path: Trajectory, size: float) -> float:
    """Twice what potential energies (J) of functions do not agree in with the work of these at the ends of steps.

    Raises GuardFailed where one is not that of its function; `size` is the scene's energy.
    """
    own = [f for f in scene.forces if isinstance(f, ForceFunction) and f.energy is not None]
    return 2.0 * sum(_work_missed(scene, path, force, size) for force in own)


def _work_missed(scene: Scene, path: Trajectory, force: ForceFunction, size: float) -> float:
    """By how much (J), at most on the way, the work of a function and the change of its potential do not make up for each other."""
    begun = force.potential(scene, start_of(scene))
    work, missed, most = 0.0, 0.0, 0.0
    for stretch in path.stretches:
        work += _work(scene, stretch, force)
        gained = force.potential(scene, stretch.after) - begun
        missed, most = max(missed, abs(gained + work)), max(most, abs(gained), abs(work))
    if missed > MISSED * most + LITTLE * (size + abs(begun)):
        raise GuardFailed(
            f"{scene.name}: the energy of ForceFunction on body {force.body} is not that of its function: on the way it differs by "
            f"{missed:.3g} J from what the function's work makes of it. Mend it, or leave it out."
        )
    return missed


def _work(scene: Scene, stretch: Stretch, force: ForceFunction) -> float:
    """What a force does (J) to its body in a step."""
    masses = [body.mass for body in scene.bodies]
    total = 0.0
    for state, part, weight in zip(stretch.states(NODES), NODES.tolist(), WEIGHTS.tolist(), strict=True):
        for i, newtons in force.act_at(
            scene, stretch.begin + part * stretch.lasts, state, masses, stretch.since
        ):
            total += weight * sum(f * v for f, v in zip(newtons, velocity(scene, state, i), strict=True))
    return total * stretch.lasts
