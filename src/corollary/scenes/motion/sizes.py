"""The sizes of a scene: of its places, velocities and overlaps, which errors are a part of, and what is too small to see in it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from corollary.scenes.forces.contact import Contact
from corollary.scenes.motion.own_forces import pushed
from corollary.scenes.motion.system import System
from corollary.scenes.scene import ContactForce, Scene, start_of


@dataclass(frozen=True, slots=True)
class Sizes:
    """`long`, `deep` and `place` (m) are those of places, of overlaps, and that of which places may be off a part; `fast` is in m/s.

    Too small to see: gaps (m) of `gap` and speeds (m/s) of `speed`, bounces lower than `bounce` (m), slips in a plane slower than
    `rest` (m/s). Within `blur` (m) rounding decides on which side of a touch a place is. Touches happen `shift` (m) later.
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
    shift: float


def sizes_of(system: System, tolerance: float, shift: float = 0.0) -> Sizes:
    """The sizes of a scene at its start; `shift` (m) lets every touch happen that much later, or earlier where it is negative."""
    scene = system.scene
    y, count = start_of(scene), system.count
    long = max(max(map(abs, y[:count])), *(body.radius for body in scene.bodies)) or 1.0
    fast = max([abs(v) for v in y[count : 2 * count]] + [abs(b.spin) * b.radius for b in scene.bodies])
    fast = max([fast, *(math.hypot(*rub.driven) for rub in system.rubs)])
    gained = max((abs(a) for a in system.gains(0.0, y, y)[:count]), default=0.0)
    gained = max(gained, pushed(scene, y))
    reach = gained * scene.until if scene.until else math.inf
    fast = max(fast, min(math.sqrt(long * gained), reach)) or 1.0
    deep = min([long, *(_depth(scene, fast, force, a, b) for force, a, b in system.contacts)])
    return Sizes(
        long=long,
        fast=fast,
        deep=deep,
        place=min(long, 30.0 * deep),
        gap=1e-12 * long,
        speed=1e-12 * fast,
        bounce=max(0.1 * tolerance * long, 64.0 * math.ulp(long)),
        rest=max(tolerance, 1e-7) * fast,
        blur=16.0 * math.ulp(long),
        shift=shift,
    )


def _depth(scene: Scene, fast: float, force: ContactForce, a: int, b: int) -> float:
    """About how deep two bodies squeeze each other."""
    first, second = scene.bodies[a], scene.bodies[b]
    mass = 1.0 / (1.0 / first.mass + 1.0 / second.mass)
    if isinstance(force, Contact):
        return (mass * fast**2 / force.k) ** (1.0 / (force.q + 1.0))
    return 1e-2 * (first.radius + second.radius)
