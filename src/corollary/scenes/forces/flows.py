"""Forces of what flows: drag of a fluid, mass thrown out, and mass taken up."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.body import State
from corollary.scenes.scene import Event, ForceOnOne, Pushes, Scene, velocity
from corollary.scenes.validation import refuse_below_zero, refuse_components

# Of the way to where an expansion ends, so much is a step at most.
NEAR = 0.2


@dataclass(frozen=True, slots=True)
class Drag(ForceOnOne):
    """-(linear + quadratic |v|) v on one body, in kg/s and kg/m, neither negative; v is relative to the `wind` (m/s).

    |v| v is not smooth where the body turns: a step that ran over it would lose its order and not know its error, so one ends there.
    """

    linear: float = 0.0
    quadratic: float = 0.0
    wind: tuple[float, ...] = ()

    def fits(self, scene: Scene) -> None:
        """A coefficient below zero would drive the body: that is a `ForceFunction`."""
        refuse_below_zero(scene.name, self, least=("linear", "quadratic"))
        if self.wind:
            refuse_components(scene.name, scene.axes, self, "wind")

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        relative = self._relative(scene, state)
        pull = self.linear + self.quadratic * math.hypot(*relative)
        yield self.body, [-pull * v for v in relative]

    def events(self, scene: Scene) -> Iterator[Event]:
        if self.quadratic:
            for axis in range(scene.axes):
                yield Event(lambda y, axis=axis: self._relative(scene, y)[axis], of_speed=True)

    def smooth_for(self, scene: Scene, state: State, slope: State) -> float:
        """How long (s) a step may be: in a plane a velocity may pass near the wind's, and |v| is expanded no farther than to where it would be gone.

        What drag alone slows down never gets there, nor does what falls as fast as it lets it.
        """
        if scene.axes == 1 or not self.quadratic:
            return math.inf
        relative, gained = self._relative(scene, state), velocity(scene, slope, self.body)
        speed = math.hypot(*relative)
        share = (self.linear + self.quadratic * speed) / scene.bodies[self.body].mass
        pushed = math.hypot(*(a + share * v for a, v in zip(gained, relative, strict=True)))
        turned = min(pushed, math.hypot(*gained))
        return NEAR * speed / turned if turned else math.inf

    def _relative(self, scene: Scene, state: State) -> list[float]:
        wind = self.wind or (0.0,) * scene.axes
        return [v - w for v, w in zip(velocity(scene, state, self.body), wind, strict=True)]


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
