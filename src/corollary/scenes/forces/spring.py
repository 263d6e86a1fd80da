"""A spring between two bodies, pulling and pushing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.scene import Conserves, Force, Scene, State, opposite, seen_from


@dataclass(frozen=True, slots=True)
class Spring(Force):
    """k in N/m, `length` the one at rest (m); `ends` are two places in the list of bodies; `damping` in kg/s acts along it."""

    ends: tuple[int, int]
    k: float
    length: float = 0.0
    damping: float = 0.0

    def act(
        self, scene: Scene, state: State, masses: Sequence[float], since: State
    ) -> Sequence[tuple[int, Sequence[float]]]:
        apart, relative = seen_from(scene, state, *self.ends)
        long = math.hypot(*apart)
        if long == 0.0:
            return ()
        growing = sum(x * v for x, v in zip(apart, relative, strict=True)) / long
        force = self.k * (long - self.length) + self.damping * growing
        return opposite(self.ends[1], self.ends[0], [force * x / long for x in apart])

    def potential(self, scene: Scene, state: State) -> float:
        """Zero at the length at rest."""
        apart, _ = seen_from(scene, state, *self.ends)
        return 0.5 * self.k * (math.hypot(*apart) - self.length) ** 2

    @property
    def conserves(self) -> Conserves:
        return Conserves.MOMENTUM | (Conserves.NOTHING if self.damping else Conserves.ENERGY)

    @property
    def bodies(self) -> tuple[int, ...]:
        return self.ends
