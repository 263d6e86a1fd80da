"""Drag of a fluid, linear and quadratic in the velocity relative to it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.constraint import State
from corollary.scenes.scene import Force, Scene, velocity


@dataclass(frozen=True, slots=True)
class Drag(Force):
    """-(linear + quadratic |v|) v on one body, in kg/s and kg/m; v is relative to the `wind` (m/s)."""

    body: int
    linear: float = 0.0
    quadratic: float = 0.0
    wind: tuple[float, ...] = ()

    def act(
        self, scene: Scene, state: State, masses: Sequence[float], since: State
    ) -> Iterator[tuple[int, list[float]]]:
        own = velocity(scene, state, self.body)
        wind = self.wind or (0.0,) * scene.axes
        relative = [v - w for v, w in zip(own, wind, strict=True)]
        pull = self.linear + self.quadratic * math.hypot(*relative)
        yield self.body, [-pull * v for v in relative]

    @property
    def bodies(self) -> tuple[int, ...]:
        return (self.body,)
