"""The momentum and the energies of a scene, who conserves them, and whether its bodies will ever meet."""

from __future__ import annotations

import math
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from corollary.scenes.constraint import State
from corollary.scenes.motion.contact_forces import SLIPS
from corollary.scenes.run import ROUNDING, BadSetting
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
