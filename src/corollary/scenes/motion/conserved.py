"""Energy and momentum along a motion, and errors of energies."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

import numpy as np

from corollary.scenes.body import State
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.motion.equations_of_motion import SLIPS
from corollary.scenes.motion.path import Stretch, Trajectory
from corollary.scenes.run import ROUNDING, BadSetting, GuardFailed, Measurement, Observable
from corollary.scenes.scene import Conserves, Force, Scene, overlap, seen_from, spin, start_of, velocity
from corollary.scenes.validation import OWN_FAILS

if TYPE_CHECKING:
    from corollary.scenes.motion.equations_of_motion import Mode


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


def momentum_at_start(scene: Scene) -> tuple[float, ...]:
    """The same at time zero, rounded once: terms may cancel."""
    loose = [body for body in scene.bodies if not math.isinf(body.mass)]
    return tuple(
        float(sum(Fraction(float(b.mass)) * Fraction(float(b.velocity[axis])) for b in loose))
        for axis in range(scene.axes)
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
    """Kinetic energy (J): of the bodies that are not walls, and of everything that turns and has a moment of inertia."""
    straight = sum(
        0.5 * m * math.hypot(*velocity(scene, state, i)) ** 2
        for i, m in enumerate(masses_at(scene, time))
        if not math.isinf(m)
    )
    return straight + sum(0.5 * inertia * spin(scene, state, i) ** 2 for i, inertia in _turning(scene))


def _turning(scene: Scene) -> list[tuple[int, float]]:
    """The bodies that may turn, with their moments of inertia (kg m^2): a disc on a nail is one of them."""
    found = [(i, body.resists_spin) for i, body in enumerate(scene.bodies)] if scene.spins else []
    return [(i, inertia) for i, inertia in found if not math.isinf(inertia)]


def refuse_rest(scene: Scene) -> None:
    """Raises BadSetting where nothing that can be pushed or turned moves at the start: there is no kinetic energy to compare with."""
    straight = any(any(body.velocity) for body in scene.bodies if not math.isinf(body.mass))
    if not straight and not any(scene.bodies[i].spin for i, _ in _turning(scene)):
        raise BadSetting(f"{scene.name}: nothing moves at the start; ask for the energy, not for its ratio.")


def potentials(scene: Scene, time: float, state: State) -> list[float]:
    """The potential energy (J) of each force, none of one that has none."""
    scene = _weighed(scene, time)
    return [force.potential(scene, state) for force in scene.forces]


def _weighed(scene: Scene, time: float) -> Scene:
    """The scene with the masses of that time."""
    if not any(force.mass_rates for force in scene.forces):
        return scene
    return replace(
        scene,
        bodies=tuple(replace(b, mass=m) for b, m in zip(scene.bodies, masses_at(scene, time), strict=True)),
        until=None,  # or what is left now would have to last as long again
    )


def energy(scene: Scene, time: float, state: State) -> float:
    """Kinetic energy and the potential energy (J) of all forces that have one."""
    return kinetic(scene, time, state) + sum(potentials(scene, time, state))


def energy_terms(scene: Scene, time: float, state: State) -> float:
    """The same with all terms counted as positive (J): what its rounding is a part of."""
    return kinetic(scene, time, state) + sum(map(abs, potentials(scene, time, state)))


def rounding_of_energy(scene: Scene, start: State) -> float:
    """How far the energy (J) at time zero is off by rounding: its terms may cancel."""
    return ROUNDING * energy_terms(scene, 0.0, start) + potential_off(scene, 0.0, start)


def kinetic_off(scene: Scene, time: float, state: State, speed: float) -> float:
    """How far kinetic energy (J) is off where velocities, those of surfaces too, are off by `speed` (m/s)."""
    straight = sum(
        m * speed * (math.hypot(*velocity(scene, state, i)) + 0.5 * speed)
        for i, m in enumerate(masses_at(scene, time))
        if not math.isinf(m)
    )
    spins = [
        (inertia, abs(spin(scene, state, i)), speed / scene.bodies[i].radius)
        for i, inertia in _turning(scene)
        if scene.bodies[i].radius > 0.0
    ]
    return straight + sum(inertia * off * (turns + 0.5 * off) for inertia, turns, off in spins)


def potential_off(scene: Scene, time: float, state: State, far: float = 0.0) -> float:
    """How far potential energy (J) is off where places of bodies that are no walls are off by `far` (m), and all by their rounding."""
    scene, total = _weighed(scene, time), 0.0
    for force in scene.forces:
        for i, body in enumerate(scene.bodies):
            for j in range(scene.axes * i, scene.axes * (i + 1)):
                off = 2.0 * math.ulp(abs(state[j]) + body.radius)
                total += _moved_by(force, scene, state, j, off if math.isinf(body.mass) else max(off, far))
    return total


def _moved_by(force: Force, scene: Scene, state: State, j: int, off: float) -> float:
    """By how much (J) its potential changes where one coordinate is off; one of somebody's own may end on one side."""
    here, changes = force.potential(scene, state), [0.0]
    for x in (state[j] - off, state[j] + off):
        try:
            change = abs(force.potential(scene, [*state[:j], x, *state[j + 1 :]]) - here)
        except OWN_FAILS:
            continue
        changes += [change] if math.isfinite(change) else []
    return max(changes)


def keeps_energy(scene: Scene, mode: Mode | None = None) -> bool:
    """Whether no force and no moving wall takes or gives energy: at any time, or in a mode, between its hits."""
    if not scene.walls_at_rest:
        return False
    if mode is None:
        return Conserves.ENERGY in scene.conserves and not any(f.rubs_surfaces for f in scene.forces)
    steady = SLIPS.keys().isdisjoint(mode.rubbed)
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
    """Whether bodies touch, and of the speed `fast` (m/s) no more than a share is left, of the first energy its square.

    None that comes faster than that is on its way to another.
    """
    pairs = {(a, b): overlap(scene, state, a, b) for force in scene.contacts for a, b in force.serves(scene)}
    rates = [rate for depth, rate in pairs.values() if depth > 0.0]
    if not rates or max(map(abs, rates)) >= share * fast:
        return False
    apart = [pair for pair, (depth, rate) in pairs.items() if depth <= 0.0 and rate > share * fast]
    if any(_on_course(scene, state, a, b) for a, b in apart):
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
