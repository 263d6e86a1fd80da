"""A hard wall that a body bounces off at once, with a coefficient of restitution (equation 12.60)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.scene import Conserves, Event, Force, Scene, State, bounced, place, velocity


@dataclass(frozen=True, slots=True)
class HardWall(Force):
    """The plane normal . place = offset; bodies stay on the side the unit vector `normal` points to."""

    normal: tuple[float, ...]
    offset: float = 0.0
    restitution: float = 1.0

    def act(
        self, scene: Scene, state: State, masses: Sequence[float], since: State
    ) -> tuple[tuple[int, Sequence[float]], ...]:
        """Nothing: it acts in no time at all, by its events."""
        return ()

    def events(self, scene: Scene) -> Iterator[Event]:
        """A body's surface reaches the plane, and its velocity is turned round."""
        for i, body in enumerate(scene.bodies):
            if not math.isinf(body.mass):
                yield Event(
                    lambda y, i=i, radius=body.radius: self.clearance(place(scene, y, i), radius),
                    i,
                    lambda y, i=i: bounced(self.normal, velocity(scene, y, i), self.restitution),
                )

    def clearance(self, place: Sequence[float], radius: float) -> float:
        """How far (m) the surface of a body is from the wall; negative behind it."""
        return sum(n * x for n, x in zip(self.normal, place, strict=True)) - self.offset - radius

    @property
    def conserves(self) -> Conserves:
        return Conserves.ENERGY if self.restitution == 1.0 else Conserves.NOTHING
