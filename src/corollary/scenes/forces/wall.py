"""A hard wall, at rest or moving: bodies bounce off it at once (equation 12.60), or rest, slide and roll on it."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction

from corollary.scenes.body import Body
from corollary.scenes.constraint import Constraint, Rub, State
from corollary.scenes.refused import OWN_FAILS
from corollary.scenes.run import BadSetting, GuardFailed
from corollary.scenes.scene import Conserves, Force, Pushes, Scene, place, unit_row
from corollary.scenes.sound import refuse_components, refuse_unsound, short_text, size_of

Shift = Callable[[float], tuple[float, float, float]]
"""Offset (m), velocity and acceleration of a wall along its normal at a time."""
WHEN = (0.1234, 0.3456, 0.5432, 0.7654, 0.9321)
"""The parts of the time at which such a function is looked at."""
NEAR = (1e-6, 1e-4, 1e-8)
"""Differences are taken over such parts of the time; one that is right over any of them is right."""
GROSS = 0.1
LOOKS = 400
"""So often two walls that functions move are held against each other."""


@dataclass(frozen=True, slots=True)
class HardWall(Force):
    """The plane normal . place = offset; bodies stay on the side the unit vector `normal` points to.

    `mu` is its kinetic, `static` its static friction (mu if not given), in a plane: a body with a radius is made to spin by it.
    `velocity` (m/s) moves it along its normal; `moves` gives offset, velocity and acceleration at a time instead. `only` names the
    bodies it is there for, all if none. Raises BadSetting when the normal is no unit vector, or a coefficient is out of range; the scene
    refuses `moves` that do not give three numbers, or a velocity that is not what the offset changes by.
    """

    normal: tuple[float, ...]
    offset: float = 0.0
    restitution: float = 1.0
    mu: float = 0.0
    static: float | None = None
    velocity: float = 0.0
    moves: Shift | None = None
    only: tuple[int, ...] = ()

    def __post_init__(self) -> None:
        refuse_unsound("a scene", self)
        if abs(math.hypot(*self.normal) - 1.0) > 1e-9:
            raise BadSetting(f"HardWall: normal = {self.normal} must have the length one.")
        if not (0.0 <= self.restitution <= 1.0 and self.mu >= 0.0 and self.held_by >= self.mu):
            raise BadSetting(
                "HardWall: restitution lies between 0 and 1, mu is zero or more, static not less than mu."
            )
        if self.velocity and self.moves is not None:
            raise BadSetting(
                f"HardWall with velocity = {self.velocity:g} and moves: give one of the two, for moves tells the velocity, too."
            )

    def from_origin(self, origin: Sequence[float]) -> HardWall | None:
        """None for one that a function moves."""
        if self.moves is not None:
            return None
        there = sum(Fraction(n) * Fraction(x) for n, x in zip(self.normal, origin, strict=True))
        return replace(self, offset=float(Fraction(self.offset) - there))

    def fits(self, scene: Scene) -> None:
        refuse_components(scene.name, scene.axes, self, "normal")
        if self.moves is not None:
            _refuse_moves(scene.name, self.moves, scene.until or 0.0)
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
        looks = 1 if self.moves is None else LOOKS
        for k in range(1, looks + 1):
            time = scene.until * k / looks
            there = [x + v * time for x, v in zip(body.place, body.velocity, strict=True)]
            try:
                if self.clearance(there, body.radius, time) < -near:
                    return True
            except (GuardFailed, *OWN_FAILS):  # it is named on the way
                continue
        return False

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

    def at(self, time: float) -> tuple[float, float, float]:
        """Offset (m), velocity and acceleration along the normal at a time. Raises GuardFailed where `moves` does not give them."""
        if self.moves is None:
            return self.offset + self.velocity * time, self.velocity, 0.0
        moved = self.moves(time)
        size_of(moved, 3, "HardWall(moves=…)", time)
        return moved

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
                lambda t, y: -self.at(t)[2],
                lambda t: -self.at(t)[1],
                self.restitution,
            )

    def rubs(self, scene: Scene, held: Sequence[Constraint]) -> Iterator[Rub]:
        """Where the surface of a body slips along the wall."""
        if self.held_by == 0.0 or scene.axes != 2:
            return
        nx, ny = self.normal
        for i, constraint in zip(self._bodies(scene), held, strict=True):
            row = unit_row(scene, i, (ny, -nx), spin=scene.bodies[i].radius)
            yield Rub(
                constraint.name,
                (i,),
                lambda t, y, row=row: [row],
                lambda t, y: [0.0],
                self.mu,
                self.held_by,
                pressed=constraint,
            )

    def _bodies(self, scene: Scene) -> list[int]:
        chosen = self.only or range(len(scene.bodies))
        return [i for i in chosen if not math.isinf(scene.bodies[i].mass)]

    def clearance(self, place: Sequence[float], radius: float, time: float = 0.0) -> float:
        """How far (m) the surface of a body is from the wall; negative behind it."""
        return sum(n * x for n, x in zip(self.normal, place, strict=True)) - self.at(time)[0] - radius

    def accelerations(self, scene: Scene, time: float, state: State, since: State) -> Iterator[float]:
        """That of the wall itself."""
        yield self.at(time)[2]

    @property
    def may_be_brief(self) -> bool:
        return self.moves is not None

    @property
    def does_no_work_at_rest(self) -> bool:
        return self.moves is None and self.velocity == 0.0

    @property
    def bodies(self) -> tuple[int, ...]:
        return self.only

    @property
    def rubs_surfaces(self) -> bool:
        return self.held_by > 0.0

    @property
    def conserves(self) -> Conserves:
        moving = self.moves is not None or self.velocity != 0.0
        elastic = self.restitution == 1.0 and self.held_by == 0.0 and not moving
        return Conserves.ENERGY if elastic else Conserves.NOTHING


def _face(a: HardWall, b: HardWall) -> bool:
    """Whether two walls face each other."""
    return len(a.normal) == len(b.normal) and all(
        abs(x + y) <= 1e-9 for x, y in zip(a.normal, b.normal, strict=True)
    )


def _meeting(a: HardWall, b: HardWall, wide: float, until: float) -> float | None:
    """When (s) two walls that face each other leave less than `wide` (m) between them, if they do before the end.

    Walls that functions move are looked at a few hundred times.
    """
    slack = 1e-9 * max(abs(a.offset), abs(b.offset), wide)
    if a.moves is None and b.moves is None:
        room, closing = -(a.offset + b.offset) - wide, a.velocity + b.velocity
        return max(room / closing, 0.0) if closing > 0.0 and closing * until >= room - slack else None
    for k in range(1, LOOKS + 1):
        time = until * k / LOOKS
        try:
            if -(a.at(time)[0] + b.at(time)[0]) < wide - slack:
                return time
        except (GuardFailed, *OWN_FAILS):  # it is named on the way
            continue
    return None


def _refuse_moves(scene: str, moves: Shift, until: float) -> None:
    """Raises BadSetting for one that does not give three finite numbers, or a velocity or an acceleration that is grossly another than
    its offset or its velocity changes by; looked at a few times until then (s)."""
    _moved_at(scene, moves, 0.0)
    for part in WHEN if until else ():
        time = part * until
        now = _moved_at(scene, moves, time)
        wrong = {1: True, 2: True}
        for near in NEAR:
            h = near * until
            before, after = _moved_at(scene, moves, time - h), _moved_at(scene, moves, time + h)
            for i, still in wrong.items():
                change = (after[i - 1] - before[i - 1]) / (2.0 * h)
                noise = 8.0 * math.ulp(max(abs(before[i - 1]), abs(after[i - 1]))) / h
                wrong[i] = still and abs(change - now[i]) > GROSS * max(abs(change), abs(now[i])) + noise
            if not any(wrong.values()):
                break
        for i, what, of in ((1, "velocity", "offset"), (2, "acceleration", "velocity")):
            if wrong[i]:
                raise BadSetting(
                    f"{scene}: HardWall(moves=…) gives the {what} {now[i]:.6g} at {time:.6g} s, but its {of} changes otherwise; "
                    "it must give offset, velocity and acceleration along the normal."
                )


def _moved_at(scene: str, moves: Shift, time: float) -> tuple[float, float, float]:
    try:
        found = moves(time)
        if not math.isfinite(size_of(found, 3, f"{scene}: HardWall(moves=…)", time)):
            raise BadSetting(
                f"{scene}: HardWall(moves=…) gives {short_text(found)} at {time:.6g} s; it must be finite."
            )
    except BadSetting:
        raise
    except GuardFailed as error:
        raise BadSetting(str(error)) from None
    except OWN_FAILS as error:
        raise BadSetting(
            f"{scene}: HardWall(moves=…) fails at {time:.6g} s ({type(error).__name__}: {error}); mend it."
        ) from error
    return found
