"""Static and kinetic friction of one body on a level table or belt (Coulomb)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.constraint import Constraint, Rub, State
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import ForceOnOne, Pushes, Scene, unit_row
from corollary.scenes.validation import refuse_components, refuse_unsound


@dataclass(frozen=True, slots=True)
class Friction(ForceOnOne):
    """mu m g against the velocity of one body (by its place in the scene) relative to a `belt` (m/s); m is its mass at the time.

    At rest on it the body is held by up to `static` m g; `static` is mu where it is not given. Raises BadSetting for a static
    coefficient below the kinetic one, or either, or g, below zero.
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
        if self.belt:
            refuse_components(scene.name, scene.axes, self, "belt")
        pushes = [f for f in scene.forces if f is not self and (not f.bodies or self.body in f.bodies)]
        if scene.axes == 2 and pushes:
            raise BadSetting(
                f"{scene.name}: Friction on body {self.body} in a plane where {type(pushes[0]).__name__} acts on it, too: a puck whose slip "
                "turns is not followed. Let it slide along a line (places of one component), or on a rough HardWall."
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
        # On a table that is seen from above nothing turns its way: it slips along a line.
        belt = tuple(self.belt) or (0.0,) * scene.axes
        slip = [v - u for v, u in zip(body.velocity, belt, strict=True)]
        speed = math.hypot(*slip)
        way = [v / speed for v in slip] if speed else [1.0, 0.0][: scene.axes]
        if scene.axes == 1:
            way = [1.0]
        gained = sum(rate for force in scene.forces for i, rate in force.mass_rates if i == self.body)
        yield Rub(
            f"{body.name or f'body {self.body}'} on the table",
            self.body,
            unit_row(scene, self.body, way),
            self.mu,
            self.held_by,
            sum(u * x for u, x in zip(belt, way, strict=True)),
            lambda t: (body.mass + gained * t) * self.g,
        )

    @property
    def does_no_work_at_rest(self) -> bool:
        return not any(self.belt)
