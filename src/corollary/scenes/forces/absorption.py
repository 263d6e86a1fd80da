"""A body that takes up mass at a steady rate (rocket equation 12.126)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.scene import ForceOnOne, Pushes, Scene, State, velocity
from corollary.scenes.validation import refuse_below_zero, refuse_components


@dataclass(frozen=True, slots=True)
class Absorption(ForceOnOne):
    """One body takes up mass that moves with `velocity`, at `rate` kg/s (not negative); its force is (u - v) dm/dt."""

    velocity: tuple[float, ...]
    rate: float

    def fits(self, scene: Scene) -> None:
        refuse_below_zero(scene.name, self, least=("rate",))
        refuse_components(scene.name, scene.axes, self, "velocity")

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        own = velocity(scene, state, self.body)
        yield self.body, [self.rate * (u - v) for u, v in zip(self.velocity, own, strict=True)]

    @property
    def mass_rates(self) -> tuple[tuple[int, float], ...]:
        return ((self.body, self.rate),)
