"""A body that throws out mass at a steady rate (rocket equation 12.129)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from corollary.scenes.scene import ForceOnOne, Pushes, Scene, State
from corollary.scenes.validation import refuse_below_zero, refuse_components


@dataclass(frozen=True, slots=True)
class Thrust(ForceOnOne):
    """Exhaust leaves one body with velocity `relative` to it, at the rate of `burn` kg/s (> 0).

    Its force is v_rel dm/dt, and dm/dt is negative.
    """

    relative: tuple[float, ...]
    burn: float

    def fits(self, scene: Scene) -> None:
        refuse_below_zero(scene.name, self, above=("burn",))
        refuse_components(scene.name, scene.axes, self, "relative")

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        yield self.body, [-self.burn * v for v in self.relative]

    @property
    def mass_rates(self) -> tuple[tuple[int, float], ...]:
        return ((self.body, -self.burn),)
