"""Forces of surfaces: contact of two bodies, hard walls, and dry friction on a level table."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.body import Constraint, Rub, State
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import (
    Conserves,
    ContactForce,
    Force,
    ForceOnOne,
    Pushes,
    Scene,
    overlap,
    place,
    seen_from,
    unit_row,
)
from corollary.scenes.validation import refuse_below_zero, refuse_components, refuse_unsound


@dataclass(frozen=True, slots=True)
class Contact(ContactForce):
    """k in N/m^q and q above zero, eta in kg/s not negative; the push acts from zero overlap to zero overlap, as in the chapter's programs.

    The dashpot drags against all of the relative velocity of the centres, as in the chapter: in a plane it takes angular momentum.
    `chosen` names the pairs of bodies it acts between; without it, it acts between all that no other contact has chosen. Friction
    between bodies is refused: `mu` and `static` are there to be refused by name. Source: equations (12.23), (12.119) and (12.137).
    """

    k: float
    q: float = 1.5
    eta: float = 0.0
    mu: float = 0.0
    static: float | None = None
    chosen: tuple[tuple[int, int], ...] | None = None

    def fits(self, scene: Scene) -> None:
        refuse_below_zero(scene.name, self, least=("eta",), above=("k", "q"))
        if self.mu or self.static:
            raise BadSetting(
                f"{scene.name}: Contact with mu = {self.mu:g}: friction between bodies is not followed; leave it out, or let one of "
                "them be a HardWall."
            )
        for a, b in self.serves(scene):
            if scene.bodies[a].place == scene.bodies[b].place:
                raise BadSetting(
                    f"{scene.name}: bodies {a} and {b} start with their centres at one place, where a contact pushes to no side; move one."
                )

    def between(self, scene: Scene, state: State, a: int, b: int) -> list[float]:
        """The push along the line of centres, the drag along the relative velocity."""
        depth, _ = overlap(scene, state, a, b)
        apart, relative = seen_from(scene, state, a, b)
        distance, spring = math.hypot(*apart), push(self, max(depth, 0.0))
        return [spring * x / distance - self.eta * v for x, v in zip(apart, relative, strict=True)]

    def potential(self, scene: Scene, state: State) -> float:
        return sum(stored(self, overlap(scene, state, a, b)[0]) for a, b in self.serves(scene))

    @property
    def between_bodies(self) -> tuple[tuple[int, int], ...] | None:
        return self.chosen

    @property
    def bodies(self) -> tuple[int, ...]:
        return tuple(i for pair in self.chosen or () for i in pair)

    @property
    def conserves(self) -> Conserves:
        return Conserves.MOMENTUM | (Conserves.NOTHING if self.eta else Conserves.ENERGY)


def push(contact: Contact, overlap: float) -> float:
    """How hard the spring pushes bodies apart (N) that overlap (m, not negative)."""
    return contact.k * overlap**contact.q


def stored(contact: Contact, overlap: float) -> float:
    """The energy (J) in a contact squeezed by `overlap`; none when the bodies are apart."""
    return contact.k * overlap ** (contact.q + 1.0) / (contact.q + 1.0) if overlap > 0.0 else 0.0


def smoothing_power(contact: Contact) -> int:
    """The power s for which the force is smooth in w, where overlap = w^s: s q is a whole number, or at least large.

    A force smooth in w lets a method of high order keep its order where the bodies begin and cease to touch.
    """
    for s in range(1, 9):
        if abs(s * contact.q - round(s * contact.q)) < 1e-12:
            return s
    # No small power makes s q whole: w^(s (q + 1)) is then smooth as often as a method of order 8 can tell.
    return max(2, int(-(-10.0 // (contact.q + 1.0))))


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
        """Raises BadSetting for bodies that nothing moves, where they fly, or touch a rough wall and can be turned.

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
            if any(body.velocity):
                raise BadSetting(
                    f"{scene.name}: {called} flies, which nothing moves, and a wall would not stop it; {remedy}."
                )

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
