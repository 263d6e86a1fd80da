"""The force between two bodies that touch: k overlap^q, and a dashpot eta while they overlap."""

from __future__ import annotations

import math
from dataclasses import dataclass

from corollary.scenes.scene import Conserves, ContactForce, Scene, State, overlap, pairs, seen_from


@dataclass(frozen=True, slots=True)
class Contact(ContactForce):
    """k in N/m^q, eta in kg/s; the push acts from zero overlap to zero overlap, as in the chapter's programs.

    Source: equations (12.23), (12.119) and (12.137).
    """

    k: float
    q: float = 1.5
    eta: float = 0.0

    def between(self, scene: Scene, state: State, a: int, b: int) -> list[float]:
        """The push along the line of centres, the drag along the relative velocity."""
        depth, _ = overlap(scene, state, a, b)
        if depth <= 0.0:
            return [0.0] * scene.axes
        apart, relative = seen_from(scene, state, a, b)
        distance, spring = math.hypot(*apart), push(self, depth, 0.0)
        return [spring * x / distance - self.eta * v for x, v in zip(apart, relative, strict=True)]

    def potential(self, scene: Scene, state: State) -> float:
        return sum(stored(self, overlap(scene, state, a, b)[0]) for a, b in pairs(scene))

    @property
    def conserves(self) -> Conserves:
        return Conserves.MOMENTUM | (Conserves.NOTHING if self.eta else Conserves.ENERGY)


def push(contact: Contact, overlap: float, rate: float) -> float:
    """How hard the bodies push each other apart (N) when their overlap (m, not negative) grows at `rate` (m/s)."""
    return contact.k * overlap**contact.q + contact.eta * rate


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
