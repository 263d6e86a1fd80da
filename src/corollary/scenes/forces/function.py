"""A force of one's own: a Python function of time, place and velocity, with its potential if it has one."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from corollary.scenes.constraint import State
from corollary.scenes.run import GuardFailed, NoForce
from corollary.scenes.scene import Conserves, ForceOnOne, Pushes, Scene, place, start_of, velocity
from corollary.scenes.validation import WRITTEN_WRONG, failing, refuse_own, size_of

Field = Callable[[float, Sequence[float], Sequence[float]], Sequence[float]]
Potential = Callable[[Sequence[float]], float]


@dataclass(frozen=True, slots=True)
class ForceFunction(ForceOnOne):
    """`function(t, place, velocity)` is the force (N, by components) on one body; SI throughout.

    With `energy`, the potential energy (J) at a place, the force conserves energy, and a run is watched for it: where the energy is
    asked, a potential that differs from the work of the function by more than a thousandth is refused (GuardFailed), and what it
    differs by less is in the error. The function is to be smooth; where it jumps, write a `Force` with `events`.
    Steps are searched for kicks shorter than they are, unless it is said to be `smooth`: to change no faster than the scene lasts.
    What it gives must be finite at the start, and everywhere a tuple of as many real numbers as places have: a scene refuses one that is not
    (BadSetting), and GuardFailed is raised where it is not on the way.
    """

    function: Field
    energy: Potential | None = None
    smooth: bool = False

    def fits(self, scene: Scene) -> None:
        refuse_own(scene, self, start_of(scene))

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """At time zero; `act_at` knows the time."""
        return self.act_at(scene, 0.0, state, masses, since)

    def act_at(
        self, scene: Scene, time: float, state: State, masses: Sequence[float], since: State
    ) -> Pushes:
        x, v = place(scene, state, self.body), velocity(scene, state, self.body)
        try:
            newtons = self.function(time, x, v)
        except (*WRITTEN_WRONG, ValueError) as error:  # a stage thrown out of range is a step not taken
            kind = NoForce if isinstance(error, ValueError) else GuardFailed
            raise kind(failing(f"{scene.name}: the function of ForceFunction", time, error)) from error
        size_of(newtons, scene.axes, f"{scene.name}: ForceFunction", time)
        yield self.body, newtons

    def potential(self, scene: Scene, state: State) -> float:
        """The function's own, none without one."""
        return self.energy(place(scene, state, self.body)) if self.energy else 0.0

    @property
    def may_be_brief(self) -> bool:
        return True

    @property
    def is_smooth(self) -> bool:
        return self.smooth

    @property
    def conserves(self) -> Conserves:
        return Conserves.ENERGY if self.energy else Conserves.NOTHING
