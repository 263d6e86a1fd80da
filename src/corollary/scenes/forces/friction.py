"""Kinetic friction on a level table, against the velocity until the body stops."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.scene import Event, Force, Scene, State, velocity


@dataclass(frozen=True, slots=True)
class Friction(Force):
    """mu m g against the velocity of one body (by its place in the scene); none on a body at rest."""

    body: int
    mu: float
    g: float = 9.8

    def act(
        self, scene: Scene, state: State, masses: Sequence[float], since: State
    ) -> Iterator[tuple[int, list[float]]]:
        own, mass = velocity(scene, state, self.body), masses[self.body]
        speed = math.hypot(*own)
        yield self.body, [-self.mu * mass * self.g * v / speed if speed else 0.0 for v in own]

    def events(self, scene: Scene) -> Iterator[Event]:
        """It ends when the velocity has turned against the one the body set out with."""
        start = scene.bodies[self.body].velocity
        if not math.isinf(scene.bodies[self.body].mass):
            yield Event(
                lambda y: sum(a * b for a, b in zip(start, velocity(scene, y, self.body), strict=True)),
                self.body,
                lambda _: [0.0] * scene.axes,
            )

    @property
    def bodies(self) -> tuple[int, ...]:
        return (self.body,)
