"""A force of one's own: a Python function of time, place and velocity, with its potential if it has one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from corollary.scenes.constraint import State
from corollary.scenes.scene import Conserves, ForceOnOne, Pushes, Scene, place, velocity

Field = Callable[[float, Sequence[float], Sequence[float]], Sequence[float]]
Potential = Callable[[Sequence[float]], float]


@dataclass(frozen=True, slots=True)
class ForceFunction(ForceOnOne):
    """`function(t, place, velocity)` is the force (N, by components) on one body; SI throughout.

    With `energy`, the potential energy (J) at a place, the force conserves energy, and every run is watched for it: a potential that
    is not the function's is found out. The function is to be smooth; where it jumps, write a `Force` with `events`.
    """

    function: Field
    energy: Potential | None = None

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """At time zero; `act_at` knows the time."""
        return self.act_at(scene, 0.0, state, masses, since)

    def act_at(
        self, scene: Scene, time: float, state: State, masses: Sequence[float], since: State
    ) -> Pushes:
        yield (
            self.body,
            self.function(time, place(scene, state, self.body), velocity(scene, state, self.body)),
        )

    def potential(self, scene: Scene, state: State) -> float:
        """The function's own, none without one."""
        return self.energy(place(scene, state, self.body)) if self.energy else 0.0

    @property
    def may_be_brief(self) -> bool:
        return True

    @property
    def conserves(self) -> Conserves:
        return Conserves.ENERGY if self.energy else Conserves.NOTHING
