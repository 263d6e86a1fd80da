"""Natural sizes of a scene's places, velocities and overlaps, and what is too small to be seen in it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.forces.contact import Contact, Friction, HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.forces.flows import Drag
from corollary.scenes.motion.equations_of_motion import System
from corollary.scenes.motion.own_forces import pushed
from corollary.scenes.row import reduced_mass
from corollary.scenes.scene import ContactForce, Scene, overlap, start_of

# A touch that errors of so many steps decide grazes.
GRAZING = 100.0
# An overlap has to be so many roundings of a place deep.
FINEST_OVERLAP = 1e4
# Where nothing acts that has a size of its own, places that are such a part of the way that lies ahead are the origin.
NOWHERE, ANYWHERE = 1e-8, (Weight, HardWall, Friction, Drag)


@dataclass(frozen=True, slots=True)
class Sizes:
    """`long`, `deep` and `place` (m) are those of places, of overlaps, and that of which places may be off a part; `fast` is in m/s.

    Too small to see: gaps (m) of `gap` and speeds (m/s) of `speed`, bounces lower than `bounce` (m), turns of what is slower than `rest`
    (m/s). Within `blur` (m) rounding decides on which side of a touch a
    place is, within `doubt` (m) errors of some steps do.
    """

    long: float
    fast: float
    deep: float
    place: float
    gap: float
    speed: float
    bounce: float
    rest: float
    blur: float
    doubt: float


def sizes_of(system: System, tolerance: float) -> Sizes:
    """The sizes of a scene at its start."""
    scene = system.scene
    y, count = start_of(scene), system.count
    fast = max([abs(v) for v in y[count : 2 * count]] + [abs(b.spin) * b.radius for b in scene.bodies])
    gained = max((abs(a) for a in system.gains(0.0, y, y)[:count]), default=0.0)
    gained = max(gained, pushed(scene, y))
    long = max(max(map(abs, y[:count])), *(body.radius for body in scene.bodies))
    way = (fast + 0.5 * gained * scene.until) * scene.until if scene.until else 0.0
    if long < NOWHERE * way and all(isinstance(force, ANYWHERE) for force in scene.forces):
        long = min(way, 1.0)
    long = long or 1.0
    fast = max(fast, _gets(long, gained, scene.until)) or 1.0
    deep = _deep(system, long, fast)
    if deep < FINEST_OVERLAP * math.ulp(long) and scene.until:
        deep = _deep(system, long, fast, 10.0 * scene.until)
    place = min(long, 30.0 * deep)
    return Sizes(
        long=long,
        fast=fast,
        deep=deep,
        place=place,
        gap=1e-12 * long,
        speed=1e-12 * fast,
        bounce=max(0.1 * tolerance * long, 64.0 * math.ulp(long)),
        rest=max(tolerance, 1e-7) * fast,
        blur=16.0 * math.ulp(long),
        doubt=GRAZING * tolerance * place,
    )


def last_digit(values: Sequence[float]) -> float:
    """The rounding of the largest of places (m), or velocities (m/s): as bodies get far from where they began, it grows."""
    return math.ulp(max(map(abs, values)))


def _gets(long: float, gained: float, until: float | None) -> float:
    """About how fast (m/s) what is pushed by `gained` (m/s^2) gets on a way of `long` (m), if not before the end."""
    return min(math.sqrt(long * gained), gained * until if until else math.inf)


def _deep(system: System, long: float, fast: float, within: float = math.inf) -> float:
    """About how deep (m) those of the bodies squeeze each other least that may meet `within` a time (s); all of `long` for none."""
    scene, start = system.scene, start_of(system.scene)
    near = 2.0 * fast * within
    met = [each for each in system.contacts if overlap(scene, start, *each[1:])[0] >= -near]
    return min([long, *(_depth(scene, fast, *each) for each in met)])


def least_squeeze(system: System, fast: float) -> float:
    """How deep (m) two bodies squeeze each other at least where they meet as `fast` (m/s): spring or dashpot stops them; infinite for no contacts."""
    found = math.inf
    for force, a, b in system.contacts:
        found = min(found, _depth(system.scene, fast, force, a, b))
        if isinstance(force, Contact) and force.eta > 0.0:
            found = min(found, _reduced(system.scene, a, b) * fast / force.eta)
    return found


def _reduced(scene: Scene, a: int, b: int) -> float:
    return reduced_mass(scene.bodies[a].mass, scene.bodies[b].mass)


def _depth(scene: Scene, fast: float, force: ContactForce, a: int, b: int) -> float:
    """About how deep two bodies squeeze each other."""
    if isinstance(force, Contact):
        return (_reduced(scene, a, b) * fast**2 / force.k) ** (1.0 / (force.q + 1.0))
    return 1e-2 * (scene.bodies[a].radius + scene.bodies[b].radius)
