"""A hard wall: bodies bounce off it at once (equation 12.60), or rest, slide and roll on it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.body import Body
from corollary.scenes.constraint import Constraint, Rub, State
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import Conserves, Force, Pushes, Scene, place, unit_row
from corollary.scenes.validation import refuse_components, refuse_unsound


@dataclass(frozen=True, slots=True)
class HardWall(Force):
    """The plane normal . place = offset; bodies stay on the side the unit vector `normal` points to.

    `mu` is its kinetic, `static` its static friction (mu if not given), in a plane: a body with a radius is made to spin by it.
    `only` names the bodies it is there for, all if none. Raises BadSetting when the normal is no unit vector, or a coefficient is out of
    range. A wall that moves, and a rough one that gives back speed, are refused: `velocity` and `moves` are there to be refused by name.
    """

    normal: tuple[float, ...]
    offset: float = 0.0
    restitution: float = 1.0
    mu: float = 0.0
    static: float | None = None
    velocity: float = 0.0
    moves: object = None
    only: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        refuse_unsound("a scene", self)
        if abs(math.hypot(*self.normal) - 1.0) > 1e-9:
            raise BadSetting(f"HardWall: normal = {self.normal} must have the length one.")
        if not (0.0 <= self.restitution <= 1.0 and self.mu >= 0.0 and self.held_by >= self.mu):
            raise BadSetting(
                "HardWall: restitution lies between 0 and 1, mu is zero or more, static not less than mu."
            )

    def fits(self, scene: Scene) -> None:
        refuse_components(scene.name, scene.axes, self, "normal")
        if self.moves is not None or self.velocity:
            raise BadSetting(
                f"{scene.name}: HardWall with {'velocity' if self.velocity else 'moves'}: a wall that moves is not followed; leave it out, and "
                "watch from the wall."
            )
        if self.rubs_surfaces and self.restitution:
            raise BadSetting(
                f"{scene.name}: HardWall with mu and restitution = {self.restitution:g}: bounces on a rough wall are not followed; give it "
                "restitution=0, or no friction."
            )
        self._refuse_held(scene)

    def _refuse_held(self, scene: Scene) -> None:
        """Raises BadSetting for bodies that nothing moves, where they fly into the wall, or touch a rough one and can be turned.

        Nails at rest in a wall or behind it are what things hang from.
        """
        for i in self.only or range(len(scene.bodies)):
            body = scene.bodies[i]
            if not math.isinf(body.mass):
                continue
            called, remedy = body.name or f"body {i}", "name the other bodies in only=… of the wall"
            deep = -self.clearance(body.place, body.radius)
            near = 1e-9 * max(map(abs, (*body.place, self.offset, body.radius)))
            turned = scene.axes == 2 and self.rubs_surfaces and not math.isinf(body.resists_spin)
            if turned and -near <= deep <= 2.0 * body.radius + near:
                raise BadSetting(
                    f"{scene.name}: how hard {called}, which nothing moves, is pressed on a rough wall is not determined; {remedy}."
                )
            if deep <= near and self._meets(scene, body, deep, near):
                raise BadSetting(
                    f"{scene.name}: {called}, which nothing moves, and a wall run into each other before until = {scene.until:g} s; "
                    f"watch for a shorter time, or {remedy}."
                )

    def _meets(self, scene: Scene, body: Body, deep: float, near: float) -> bool:
        """Whether a body that keeps its velocity and starts in front of the wall, or upon it and moves, gets behind it before the end."""
        if scene.until is None or (deep >= -near and not any(body.velocity)):
            return False
        there = [x + v * scene.until for x, v in zip(body.place, body.velocity, strict=True)]
        return self.clearance(there, body.radius) < -near

    @property
    def held_by(self) -> float:
        """The static coefficient."""
        return self.mu if self.static is None else self.static

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """Nothing by itself: it holds bodies back."""
        return ()

    def constraints(self, scene: Scene) -> Iterator[Constraint]:
        for i in self._bodies(scene):
            body, row = scene.bodies[i], unit_row(scene, i, self.normal)
            yield Constraint(
                f"{body.name or f'body {i}'} at the wall",
                (i,),
                lambda t, y, i=i, radius=body.radius: self.clearance(place(scene, y, i), radius),
                lambda t, y, row=row: row,
                lambda t, y: 0.0,
                self.restitution,
            )

    def rubs(self, scene: Scene, held: Sequence[Constraint]) -> Iterator[Rub]:
        """Where the surface of a body slips along the wall."""
        if self.held_by == 0.0 or scene.axes != 2:
            return
        nx, ny = self.normal
        for i, constraint in zip(self._bodies(scene), held, strict=True):
            row = unit_row(scene, i, (ny, -nx), spin=scene.bodies[i].radius)
            yield Rub(constraint.name, i, row, self.mu, self.held_by, pressed=constraint)

    def _bodies(self, scene: Scene) -> list[int]:
        chosen = self.only or range(len(scene.bodies))
        return [i for i in chosen if not math.isinf(scene.bodies[i].mass)]

    def clearance(self, place: Sequence[float], radius: float) -> float:
        """How far (m) the surface of a body is from the wall; negative behind it."""
        return sum(n * x for n, x in zip(self.normal, place, strict=True)) - self.offset - radius

    @property
    def does_no_work_at_rest(self) -> bool:
        return True

    @property
    def bodies(self) -> tuple[int, ...]:
        return self.only

    @property
    def rubs_surfaces(self) -> bool:
        return self.held_by > 0.0

    @property
    def conserves(self) -> Conserves:
        elastic = self.restitution == 1.0 and self.held_by == 0.0
        return Conserves.ENERGY if elastic else Conserves.NOTHING
