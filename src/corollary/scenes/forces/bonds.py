"""Forces and constraints between two bodies wherever they are: springs, rods and strings."""

from __future__ import annotations

import math
from abc import ABC
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.body import Constraint, State
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import (
    Conserves,
    Event,
    ForceBetween,
    Pushes,
    Scene,
    opposite,
    seen_from,
    unit_row,
)
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


@dataclass(frozen=True, slots=True)
class Link(ForceBetween, ABC):
    """What holds two bodies to a distance: `length` (m), the one at the start if it is not given."""

    length: float | None = None

    def fits(self, scene: Scene) -> None:
        self.span(scene)

    def span(self, scene: Scene) -> float:
        """The length (m). Raises BadSetting when there is none."""
        length = self.length
        if length is None:
            length = math.dist(*(scene.bodies[i].place for i in self.ends))
        if not length > 0.0:
            raise BadSetting(f"{scene.name}: a rod or string between {self.ends} needs a length above zero.")
        return length

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """Nothing by itself: it holds."""
        return ()

    def held(self, scene: Scene, what: str, sign: float, two_sided: bool, restitution: float) -> Constraint:
        """The distance beyond the length (sign 1) or the slack (sign -1), as a gap. Raises BadSetting when there is no length."""
        (a, b), length = self.ends, self.span(scene)

        def direction(y: State) -> tuple[list[float], float, list[float]]:
            apart, relative = seen_from(scene, y, a, b)
            r = math.hypot(*apart) or 1e-300
            return [x / r for x in apart], r, relative

        def gap(t: float, y: State) -> float:
            return sign * direction(y)[1] - sign * length

        def row(t: float, y: State) -> list[float]:
            unit = direction(y)[0]
            on_b = unit_row(scene, b, [sign * u for u in unit])
            return [x + z for x, z in zip(on_b, unit_row(scene, a, [-sign * u for u in unit]), strict=True)]

        def drift(t: float, y: State) -> float:
            unit, r, relative = direction(y)
            along = sum(u * v for u, v in zip(unit, relative, strict=True))
            return sign * (sum(v * v for v in relative) - along * along) / r

        name = f"the {what} between {a} and {b}"
        return Constraint(name, self.ends, gap, row, drift, restitution=restitution, two_sided=two_sided)


@dataclass(frozen=True, slots=True)
class Rod(Link):
    """A rigid rod without mass between the centres of two bodies (places in the scene); a nail is a body of infinite mass.

    `length` (m) is the distance at the start if it is not given.
    """

    def constraints(self, scene: Scene) -> Iterator[Constraint]:
        """The distance beyond the length: zero. Raises BadSetting for bodies that start in the same place."""
        yield self.held(scene, "rod", 1.0, two_sided=True, restitution=0.0)

    @property
    def conserves(self) -> Conserves:
        return Conserves.MOMENTUM | Conserves.ENERGY


@dataclass(frozen=True, slots=True)
class String(Link):
    """A string that cannot be stretched: slack, or taut and pulling. It jerks taut with `restitution` (0: it stays taut).

    `restitution` lies between 0 and 1. `length` (m) is the distance at the start if it is not given.
    """

    restitution: float = 0.0

    def fits(self, scene: Scene) -> None:
        self.span(scene)
        refuse_below_zero(scene.name, self, least=("restitution",))
        if self.restitution > 1.0:
            raise BadSetting(
                f"{scene.name}: String with restitution = {self.restitution:g}: it must be at most 1."
            )

    def constraints(self, scene: Scene) -> Iterator[Constraint]:
        """The slack: not negative. Raises BadSetting for bodies that start in the same place without a length given."""
        yield self.held(scene, "string", -1.0, two_sided=False, restitution=self.restitution)

    @property
    def conserves(self) -> Conserves:
        """A jerk that leaves it taut costs energy; what is watched begins anew after it."""
        return Conserves.MOMENTUM | (Conserves.ENERGY if self.restitution == 1.0 else Conserves.NOTHING)

    @property
    def does_no_work_at_rest(self) -> bool:
        return True
