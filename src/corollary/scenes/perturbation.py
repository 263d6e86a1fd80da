"""The same scene with slightly other data: how far it gets from the first says how strongly values hang on what they are made of."""

from __future__ import annotations

import math
from dataclasses import replace

from corollary.scenes.body import starts_across
from corollary.scenes.motion.system import System
from corollary.scenes.scene import Body, Scene, overlap, pairs, start_of

CHANGED = 1e-7
"""The relative change of the data with which the condition is found."""


def perturbed(scene: Scene) -> Scene:
    """The same with masses, velocities and spins changed by about CHANGED of themselves, each in its own way.

    What nothing touches starts from another place, too, by CHANGED of the size of the scene: neither the fall of a ball from rest nor
    the way of one that flies along an axis would feel any of the others. What starts from rest stays at rest, and
    a first body that starts across the way to the origin starts across it: its distance turns there.
    """

    def share(i: int) -> float:
        return CHANGED * math.cos(1.0 + 2.4 * i)

    long = max(abs(x) for body in scene.bodies for x in (*body.place, body.radius))
    touched = _touched(scene, 4.0 * CHANGED * long)
    bodies: list[Body] = []
    for i, body in enumerate(scene.bodies):
        if math.isinf(body.mass):
            turned = 0.0 if math.isinf(body.resists_spin) else share(3 * i + 2)
            bodies.append(replace(body, spin=body.spin * (1.0 + turned)))
            continue
        place = body.place
        if i not in touched:
            place = tuple(x + share(3 * i + j) * long for j, x in enumerate(place))
        velocity = tuple(v * (1.0 + share(3 * i + j)) for j, v in enumerate(body.velocity))
        if i == 0 and any(body.place) and starts_across(body):
            along = sum(x * v for x, v in zip(place, velocity, strict=True)) / math.fsum(x * x for x in place)
            velocity = tuple(v - along * x for x, v in zip(place, velocity, strict=True))
        bodies.append(
            replace(
                body,
                place=place,
                velocity=velocity,
                spin=body.spin * (1.0 + share(3 * i + 2)),
                mass=body.mass * (1.0 + share(i + 7)),
            )
        )
    return replace(scene, bodies=tuple(bodies))


def _touched(scene: Scene, within: float) -> set[int]:
    """The bodies that others, walls, strings or rods touch or hold at the start, or come as near (m) to."""
    start = start_of(scene)
    found: set[int] = set()
    for constraint in System(scene).constraints:
        if constraint.two_sided or constraint.gap(0.0, start) <= within:
            found.update(constraint.bodies)
    for a, b in pairs(scene):
        if overlap(scene, start, a, b)[0] >= -within:
            found.update((a, b))
    return found
