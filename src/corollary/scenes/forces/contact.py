"""The force between two bodies that touch: k overlap^q, and a dashpot eta while they overlap."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from corollary.scenes.body import nothing_moves
from corollary.scenes.constraint import Constraint, Rub, State
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import (
    Conserves,
    ContactForce,
    Event,
    Scene,
    overlap,
    seen_from,
    spin,
    start_of,
    unit_row,
)
from corollary.scenes.sound import refuse_below_zero


@dataclass(frozen=True, slots=True)
class Contact(ContactForce):
    """k in N/m^q and q above zero, eta in kg/s not negative; the push acts from zero overlap to zero overlap, as in the chapter's programs.

    The dashpot drags against all of the relative velocity of the centres, as in the chapter: in a plane it takes angular momentum. With
    `mu` (kinetic; `static` is the same where it is not given) surfaces rub at the contact, in a plane: the bodies are turned by it, and
    roll on each other where it holds; friction is what acts across then, mu times the push of the spring, and the dashpot acts along the
    line of centres only. `chosen` names the pairs of bodies it acts between; without it, it acts between all that no
    other contact has chosen. Source: equations (12.23), (12.119) and (12.137).
    """

    k: float
    q: float = 1.5
    eta: float = 0.0
    mu: float = 0.0
    static: float | None = None
    chosen: tuple[tuple[int, int], ...] | None = None

    def fits(self, scene: Scene) -> None:
        refuse_below_zero(scene.name, self, least=("eta", "mu"), above=("k", "q"))
        if self.held_by < self.mu:
            raise BadSetting(
                f"{scene.name}: Contact with mu = {self.mu:g} and static = {self.held_by:g}: the static one must not be the smaller."
            )
        for a, b in self.serves(scene):
            if scene.bodies[a].place == scene.bodies[b].place:
                raise BadSetting(
                    f"{scene.name}: bodies {a} and {b} start with their centres at one place, where a contact pushes to no side; move one."
                )
        for a, b in self._held(scene) if scene.until is None else ():
            if max(overlap(scene, start_of(scene), a, b)) > 0.0:
                raise BadSetting(
                    f"{scene.name}: nothing moves bodies {a} and {b}, so that their touch does not end by itself; say until when to watch, "
                    "until=…."
                )

    def between(self, scene: Scene, state: State, a: int, b: int) -> list[float]:
        """The push along the line of centres, the drag along the relative velocity, or along that line, too, where surfaces rub."""
        depth, growing = overlap(scene, state, a, b)
        apart, relative = seen_from(scene, state, a, b)
        distance, spring = math.hypot(*apart), push(self, max(depth, 0.0))
        if self.rubs_surfaces:
            return [(spring + self.eta * growing) * x / distance for x in apart]
        return [spring * x / distance - self.eta * v for x, v in zip(apart, relative, strict=True)]

    def potential(self, scene: Scene, state: State) -> float:
        return sum(stored(self, overlap(scene, state, a, b)[0]) for a, b in self.serves(scene))

    def rubs(self, scene: Scene, held: Sequence[Constraint]) -> Iterator[Rub]:
        if self.rubs_surfaces and scene.axes == 2:
            for a, b in self.serves(scene):
                if any(min(scene.bodies[i].mass, scene.bodies[i].resists_spin) < math.inf for i in (a, b)):
                    yield self._rub(scene, a, b)

    def events(self, scene: Scene) -> Iterator[Event]:
        """Two bodies that nothing moves come to touch, or part, in passing."""
        for a, b in self._held(scene):
            if scene.bodies[a].velocity != scene.bodies[b].velocity:
                yield Event(lambda y, a=a, b=b: overlap(scene, y, a, b)[0])

    def _held(self, scene: Scene) -> list[tuple[int, int]]:
        """The pairs that nothing moves: a touch turns them at most."""
        return [pair for pair in self.serves(scene) if nothing_moves(*(scene.bodies[i] for i in pair))]

    def _rub(self, scene: Scene, a: int, b: int) -> Rub:
        """Where the surfaces of two bodies slip on each other; their arms end where they touch, so nothing turns by itself."""
        reach = scene.bodies[a].radius + scene.bodies[b].radius
        shares = scene.bodies[a].radius / reach, scene.bodies[b].radius / reach

        def seen(y: State) -> tuple[tuple[float, float], float, Sequence[float]]:
            apart, relative = seen_from(scene, y, a, b)
            r = math.hypot(*apart) or 1e-300
            return (apart[0] / r, apart[1] / r), r, relative

        def rows(t: float, y: State) -> list[list[float]]:
            (nx, ny), r, _ = seen(y)
            on_a = unit_row(scene, a, (-ny, nx), spin=shares[0] * r)
            on_b = unit_row(scene, b, (ny, -nx), spin=shares[1] * r)
            return [[x + z for x, z in zip(on_a, on_b, strict=True)]]

        def drift(t: float, y: State) -> list[float]:
            (nx, ny), r, (u, v) = seen(y)
            turning, growing = (nx * v - ny * u) / r, nx * u + ny * v
            spins = shares[0] * spin(scene, y, a) + shares[1] * spin(scene, y, b)
            return [growing * (turning + spins)]

        def pressing(t: float, y: State) -> float:
            return push(self, max(overlap(scene, y, a, b)[0], 0.0))

        return Rub(f"bodies {a} and {b}", (a, b), rows, drift, self.mu, self.held_by, normal=pressing)

    @property
    def held_by(self) -> float:
        """The static coefficient of friction."""
        return self.mu if self.static is None else self.static

    @property
    def rubs_surfaces(self) -> bool:
        return self.held_by > 0.0

    @property
    def between_bodies(self) -> tuple[tuple[int, int], ...] | None:
        return self.chosen

    @property
    def bodies(self) -> tuple[int, ...]:
        return tuple(i for pair in self.chosen or () for i in pair)

    @property
    def conserves(self) -> Conserves:
        """Friction turns bodies, and while it holds it does no work; it is not watched for energy."""
        lossy = bool(self.eta) or self.rubs_surfaces
        return Conserves.MOMENTUM | (Conserves.NOTHING if lossy else Conserves.ENERGY)


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
