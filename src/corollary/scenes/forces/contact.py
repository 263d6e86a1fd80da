"""The force between two bodies that touch: k overlap^q, and a dashpot eta while they overlap."""

from __future__ import annotations

import math
from dataclasses import dataclass

from corollary.scenes.constraint import State
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import Conserves, ContactForce, Scene, overlap, seen_from
from corollary.scenes.validation import refuse_below_zero


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
