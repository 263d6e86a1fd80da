"""Attraction or repulsion that falls with the square of the distance (section 12.6, two ions)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.run import BadSetting
from corollary.scenes.scene import Conserves, ForceBetween, Pushes, Scene, State, opposite, seen_from


@dataclass(frozen=True, slots=True)
class InverseSquare(ForceBetween):
    """Two bodies (places in the scene) attract each other with strength/r^2, in N m^2; they repel when it is negative."""

    strength: float

    def fits(self, scene: Scene) -> None:
        a, b = (scene.bodies[i].place for i in self.ends)
        if a == b:
            raise BadSetting(
                f"{scene.name}: bodies {self.ends[0]} and {self.ends[1]} start in the same place, where an inverse square has no limit; "
                "move them apart."
            )

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        apart, _ = seen_from(scene, state, *self.ends)
        r = math.hypot(*apart)
        return opposite(self.ends[1], self.ends[0], [self.strength * x / r**3 for x in apart])

    def potential(self, scene: Scene, state: State) -> float:
        """Zero far apart."""
        apart, _ = seen_from(scene, state, *self.ends)
        return -self.strength / math.hypot(*apart)

    @property
    def conserves(self) -> Conserves:
        return Conserves.MOMENTUM | Conserves.ENERGY
