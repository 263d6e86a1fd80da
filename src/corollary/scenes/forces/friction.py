"""Static and kinetic friction of one body that slides along a line on a level table (Coulomb)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.constraint import Constraint, Rub, State
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import ForceOnOne, Pushes, Scene, unit_row
from corollary.scenes.validation import refuse_unsound


@dataclass(frozen=True, slots=True)
class Friction(ForceOnOne):
    """mu m g against the velocity of one body (by its place in the scene); m is its mass at the time.

    At rest the body is held by up to `static` m g; `static` is mu where it is not given. Raises BadSetting for a static coefficient below
    the kinetic one, or either, or g, below zero. A belt and a puck in a plane are refused: `belt` is there to be refused by name.
    """

    mu: float
    g: float = 9.8
    static: float | None = None
    belt: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        refuse_unsound("a scene", self)
        if self.g < 0.0:
            raise BadSetting(
                f"Friction with g = {self.g:g}: nothing presses on a table then; g is zero or more."
            )
        if self.mu < 0.0 or self.held_by < self.mu:
            raise BadSetting(
                f"Friction with mu = {self.mu:g} and static = {self.held_by:g}: both are zero or more, the static one not the smaller."
            )

    def fits(self, scene: Scene) -> None:
        if any(self.belt):
            raise BadSetting(
                f"{scene.name}: Friction with belt = {self.belt}: a belt that moves is not followed; leave it out, and watch from the belt."
            )
        if scene.axes == 2:
            raise BadSetting(
                f"{scene.name}: Friction on body {self.body} in a plane: a puck on a table is not followed. Let it slide along a line (places "
                "of one component), or on a rough HardWall."
            )

    @property
    def held_by(self) -> float:
        """The static coefficient."""
        return self.mu if self.static is None else self.static

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """Nothing by itself: what it does follows from whether the body sticks."""
        return ()

    def rubs(self, scene: Scene, held: Sequence[Constraint]) -> Iterator[Rub]:
        body = scene.bodies[self.body]
        if math.isinf(body.mass):
            return
        gained = sum(rate for force in scene.forces for i, rate in force.mass_rates if i == self.body)
        yield Rub(
            f"{body.name or f'body {self.body}'} on the table",
            self.body,
            unit_row(scene, self.body, [1.0]),
            self.mu,
            self.held_by,
            lambda t: (body.mass + gained * t) * self.g,
        )

    @property
    def does_no_work_at_rest(self) -> bool:
        return True
