"""A molecule's pull on an atom: a harmonic well cut off on both sides (project 12.15)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.body import bounced, inside, loose
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import Conserves, Event, Force, Pushes, Scene, State, place, velocity
from corollary.scenes.validation import refuse_below_zero

LATE = 1e-15
"""By such a part of its radius a core is met late."""


@dataclass(frozen=True, slots=True)
class Well(Force):
    """U = k (r - b)^2 / 2 for b - d < r < b + d, k d^2 / 2 farther out, a hard core at b - d; r is the distance from the origin.

    k, b and d are above zero, and d is below b. What has no end of mass does not feel it. Source: equations (12.138) and (12.140).
    """

    k: float
    b: float
    d: float

    @property
    def edge(self) -> float:
        return self.b + self.d

    @property
    def wall(self) -> float:
        return self.b - self.d

    def fits(self, scene: Scene) -> None:
        refuse_below_zero(scene.name, self, above=("k", "b", "d"))
        if self.d >= self.b:
            raise BadSetting(
                f"{scene.name}: the Well has d = {self.d:g} m and b = {self.b:g} m, and its core, at b - d, is to be beyond the origin: lower d."
            )
        for i in loose(scene.bodies):
            if math.hypot(*scene.bodies[i].place) < self.wall:
                raise BadSetting(
                    f"{scene.name}: body {i} starts inside the core of the Well; b - d = {self.wall:g} m from the origin, or farther, is right."
                )

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """On the bodies that a step begins with inside the edge.

        They feel it to the end of the step: the stages of a step that ends at the edge reach over it, and a force that jumps within
        a step would cost the method its order.
        """
        for i in loose(scene.bodies):
            if inside(place(scene, since, i), self.edge) > 0.0:
                x = place(scene, state, i)
                r = math.hypot(*x)
                yield i, [-self.k * (r - self.b) * c / r for c in x]

    def potential(self, scene: Scene, state: State) -> float:
        """Zero at the bottom of the well."""
        places = (place(scene, state, i) for i in loose(scene.bodies))
        return sum(0.5 * self.k * min(math.hypot(*x) - self.b, self.d) ** 2 for x in places)

    def events(self, scene: Scene) -> Iterator[Event]:
        """A body reaches the edge, or the hard core, which is a wall square to the radius.

        It is met a few roundings late: what starts at the core, on its way in, is in front of it.
        """
        core = self.wall * (1.0 - LATE)

        def turned(y: State, i: int) -> list[float]:
            x = place(scene, y, i)
            r = math.hypot(*x)
            return bounced([c / r for c in x], velocity(scene, y, i), 1.0)

        for i in loose(scene.bodies):
            yield Event(lambda y, i=i: inside(place(scene, y, i), self.edge))
            yield Event(lambda y, i=i: -inside(place(scene, y, i), core), i, lambda y, i=i: turned(y, i))

    @property
    def conserves(self) -> Conserves:
        return Conserves.ENERGY
