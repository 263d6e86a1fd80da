"""A spring between two bodies, pulling and pushing."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.scene import Conserves, Event, ForceBetween, Pushes, Scene, State, opposite, seen_from
from corollary.scenes.validation import refuse_below_zero

FADING = 40.0
"""In powers of e, over the time that something takes to get stuck: less than a double tells is left of its relative velocity."""


@dataclass(frozen=True, slots=True)
class Spring(ForceBetween):
    """k in N/m, `length` the one at rest (m); `ends` are two places in the list of bodies; `damping` in kg/s acts along it.

    Length and damping are not negative: such a dashpot would drive. A negative k is one that pushes away from its length, as a pendulum
    on its head does: unstable, and as good a law as any.
    """

    k: float
    length: float = 0.0
    damping: float = 0.0

    def fits(self, scene: Scene) -> None:
        refuse_below_zero(scene.name, self, least=("length", "damping"))

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        apart, relative = seen_from(scene, state, *self.ends)
        long = math.hypot(*apart)
        if scene.axes == 1 and self.length:
            # On a line it jumps where the bodies change sides: through a step it keeps the side it began on.
            side = seen_from(scene, since, *self.ends)[0][0]
            long = math.copysign(1.0, side) * apart[0] if side else long
        if long == 0.0:
            return ()
        growing = sum(x * v for x, v in zip(apart, relative, strict=True)) / long
        force = self.k * (long - self.length) + self.damping * growing
        return opposite(self.ends[1], self.ends[0], [force * x / long for x in apart])

    def potential(self, scene: Scene, state: State) -> float:
        """Zero at the length at rest."""
        apart, _ = seen_from(scene, state, *self.ends)
        return 0.5 * self.k * (math.hypot(*apart) - self.length) ** 2

    def events(self, scene: Scene) -> Iterator[Event]:
        """On a line: the bodies change sides."""
        if scene.axes == 1 and self.length:
            yield Event(lambda y: seen_from(scene, y, *self.ends)[0][0])

    @property
    def conserves(self) -> Conserves:
        return Conserves.MOMENTUM | (Conserves.NOTHING if self.damping else Conserves.ENERGY)


def catching(a: float, b: float, dt: float) -> Spring:
    """A dashpot between the first two bodies of a scene, of masses a and b, that fades their relative velocity by e^-40 in dt."""
    return Spring((0, 1), 0.0, damping=FADING * a / (a + b) * b / dt)
