"""A hard wall, at rest or moving: bodies bounce off it at once (equation 12.60), or rest, slide and roll on it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from corollary.scenes.body import Body
from corollary.scenes.constraint import Constraint, Rub, State
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import Conserves, Force, Pushes, Scene, place, unit_row
from corollary.scenes.validation import refuse_components, refuse_unsound


@dataclass(frozen=True, slots=True)
class HardWall(Force):
    """The plane normal . place = offset; bodies stay on the side the unit vector `normal` points to.

    `mu` is its kinetic, `static` its static friction (mu if not given), in a plane: a body with a radius is made to spin by it.
    `velocity` (m/s) moves it along its normal. `only` names the bodies it is there for, all if none. Raises BadSetting when the normal is
    no unit vector, or a coefficient is out of range. A plate that a function swings is refused: `moves` is there to be refused by name.
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

    def from_origin(self, origin: Sequence[float]) -> HardWall:
        there = sum(Fraction(n) * Fraction(x) for n, x in zip(self.normal, origin, strict=True))
        return replace(self, offset=float(Fraction(self.offset) - there))

    def fits(self, scene: Scene) -> None:
        refuse_components(scene.name, scene.axes, self, "normal")
        if self.moves is not None:
            raise BadSetting(
                f"{scene.name}: HardWall with moves: a plate that a function swings is not followed; give it a velocity, or none."
            )
        self._refuse_closing(scene)
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
        return self.clearance(there, body.radius, scene.until) < -near

    def _refuse_closing(self, scene: Scene) -> None:
        """Raises BadSetting where this wall and one that faces it leave a body between them no room before the end."""
        for other in scene.forces:
            if scene.until is None or not isinstance(other, HardWall) or not _face(self, other):
                continue
            both = set(self._bodies(scene)) & set(other._bodies(scene))
            widest = max(both, key=lambda i: scene.bodies[i].radius, default=None)
            if widest is None:
                continue
            body = scene.bodies[widest]
            met = _meeting(self, other, 2.0 * body.radius, scene.until)
            if met is not None:
                raise BadSetting(
                    f"{scene.name}: two walls leave {body.name or f'body {widest}'} no room between them from {met:.6g} s on, which it would "
                    "hit without end; watch for a shorter time, or let them stop before."
                )

    @property
    def held_by(self) -> float:
        """The static coefficient."""
        return self.mu if self.static is None else self.static

    def offset_at(self, time: float) -> float:
        """The offset (m) at a time."""
        return self.offset + self.velocity * time

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """Nothing by itself: it holds bodies back."""
        return ()

    def constraints(self, scene: Scene) -> Iterator[Constraint]:
        for i in self._bodies(scene):
            body, row = scene.bodies[i], unit_row(scene, i, self.normal)
            yield Constraint(
                f"{body.name or f'body {i}'} at the wall",
                (i,),
                lambda t, y, i=i, radius=body.radius: self.clearance(place(scene, y, i), radius, t),
                lambda t, y, row=row: row,
                lambda t, y: 0.0,
                -self.velocity,
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

    def clearance(self, place: Sequence[float], radius: float, time: float = 0.0) -> float:
        """How far (m) the surface of a body is from the wall; negative behind it."""
        return sum(n * x for n, x in zip(self.normal, place, strict=True)) - self.offset_at(time) - radius

    @property
    def does_no_work_at_rest(self) -> bool:
        return self.velocity == 0.0

    @property
    def bodies(self) -> tuple[int, ...]:
        return self.only

    @property
    def rubs_surfaces(self) -> bool:
        return self.held_by > 0.0

    @property
    def conserves(self) -> Conserves:
        elastic = self.restitution == 1.0 and self.held_by == 0.0 and not self.velocity
        return Conserves.ENERGY if elastic else Conserves.NOTHING


def _face(a: HardWall, b: HardWall) -> bool:
    """Whether two walls face each other."""
    return len(a.normal) == len(b.normal) and all(
        abs(x + y) <= 1e-9 for x, y in zip(a.normal, b.normal, strict=True)
    )


def _meeting(a: HardWall, b: HardWall, wide: float, until: float) -> float | None:
    """When (s) two walls that face each other leave less than `wide` (m) between them, if they do before the end."""
    slack = 1e-9 * max(abs(a.offset), abs(b.offset), wide)
    room, closing = -(a.offset + b.offset) - wide, a.velocity + b.velocity
    return max(room / closing, 0.0) if closing > 0.0 and closing * until >= room - slack else None
