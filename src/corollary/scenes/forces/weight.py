"""Weight: the same acceleration for every body, down along the last axis."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.scene import Conserves, Force, Pushes, Scene, State, place


@dataclass(frozen=True, slots=True)
class Weight(Force):
    """g in m/s^2."""

    g: float = 9.8

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        for i, mass in enumerate(masses):
            if not math.isinf(mass):
                yield i, [0.0] * (scene.axes - 1) + [-mass * self.g]

    def potential(self, scene: Scene, state: State) -> float:
        """Zero at the origin of the last axis."""
        loose = [(i, body.mass) for i, body in enumerate(scene.bodies) if not math.isinf(body.mass)]
        return sum(m * self.g * place(scene, state, i)[-1] for i, m in loose)

    @property
    def conserves(self) -> Conserves:
        return Conserves.ENERGY
