"""Forces of fields: weight, an inverse square, a molecule's well, and functions of one's own."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from corollary.scenes.body import State
from corollary.scenes.run import BadSetting, GuardFailed, NoForce
from corollary.scenes.scene import (
    Conserves,
    Force,
    ForceBetween,
    ForceOnOne,
    Pushes,
    Scene,
    opposite,
    place,
    seen_from,
    start_of,
    velocity,
)
from corollary.scenes.validation import WRITTEN_WRONG, failing, refuse_own, size_of


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
