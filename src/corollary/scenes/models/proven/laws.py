"""What is followed in balls: a row of bodies without damping, and two spheres in a plane (or a ball on a floor) with it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from flint import arb


@dataclass(frozen=True, slots=True)
class RowLaw:
    """n bodies with `inverses` of their masses and n - 1 contacts k overlap^q; the speeds are theirs, the places the overlaps."""

    inverses: tuple[arb, ...]
    k: arb
    q: arb

    def pull(self, speeds: Sequence[Any], places: Sequence[Any], on: Sequence[bool]) -> list[Any]:
        forces = [self.k * d**self.q if resolved else arb(0) for d, resolved in zip(places, on, strict=True)]
        return [
            (left - right) * inverse
            for inverse, (left, right) in zip(self.inverses, pairwise([arb(0), *forces, arb(0)]), strict=True)
        ]

    def drift(self, speeds: Sequence[Any], places: Sequence[Any]) -> list[Any]:
        return [a - b for a, b in pairwise(speeds)]

    def unresolved(self, overlaps: Sequence[arb], on: Sequence[bool]) -> arb:
        return sum(
            (
                self.k * d**self.q * (a + b)
                for d, resolved, (a, b) in zip(overlaps, on, pairwise(self.inverses), strict=True)
                if not resolved and d > 0
            ),
            arb(0),
        ).upper()

    def steepness(self, speeds: Sequence[arb], places: Sequence[arb], on: Sequence[bool]) -> arb:
        stiff = arb(2)
        for d, resolved, (a, b) in zip(places, on, pairwise(self.inverses), strict=True):
            if resolved:
                stiff += self.k * self.q * d.upper() ** (self.q - 1) * (a + b)
        return stiff.upper()


@dataclass(frozen=True, slots=True)
class PairLaw:
    """Two spheres at a distance `reach` - overlap; speeds are the overlap's rate and the spin, places the overlap and the angle turned.

    `inverse` is one over the reduced mass. `weight` presses: the acceleration with which the overlap would grow by itself. Without a
    `reach` nothing turns. The drag acts from the first to the last moment of the contact.
    """

    inverse: arb
    k: arb
    q: arb
    eta: arb
    reach: arb | None
    weight: arb

    def pull(self, speeds: Sequence[Any], places: Sequence[Any], on: Sequence[bool]) -> list[Any]:
        (rate, spin), overlap = speeds, places[0]
        inward: Any = self.weight
        if on[0]:
            inward = inward - self.inverse * self.k * overlap**self.q
        fades = self.inverse * self.eta
        if self.reach is not None:
            r = self.reach - overlap
            inward = inward - spin * spin / (r * r * r)
        if self.eta.is_zero():
            return [inward, arb(0)]
        return [inward - fades * rate, -fades * spin]

    def drift(self, speeds: Sequence[Any], places: Sequence[Any]) -> list[Any]:
        if self.reach is None:
            return [speeds[0], arb(0)]
        r = self.reach - places[0]
        return [speeds[0], speeds[1] / (r * r)]

    def unresolved(self, overlaps: Sequence[arb], on: Sequence[bool]) -> arb:
        d = overlaps[0]
        return (self.inverse * self.k * d**self.q).upper() if not on[0] and d > 0 else arb(0)

    def steepness(self, speeds: Sequence[arb], places: Sequence[arb], on: Sequence[bool]) -> arb:
        steep = 1 + self.inverse * self.eta
        if on[0]:
            steep += self.inverse * self.k * self.q * places[0].upper() ** (self.q - 1)
        if self.reach is not None:
            r, spin = self.reach - places[0], abs(speeds[1])
            steep += 3 * spin * spin / r**4 + 2 * spin / r**3 + 1 / r**2
        return steep.upper()

    def force_square(
        self, speeds: Sequence[arb], places: Sequence[arb], on: Sequence[bool]
    ) -> tuple[arb, arb]:
        """The square of the contact's force, its drag across the line of centres included, and its rate of change."""
        (rate, spin), overlap = speeds, places[0]
        grows, fades = self.pull(speeds, places, on)
        elastic, stiff = arb(0), arb(0)
        if on[0]:
            elastic, stiff = self.k * overlap**self.q, self.k * self.q * overlap ** (self.q - 1)
        elif overlap.upper() > 0:
            top = overlap.upper()
            elastic, stiff = (
                (self.k * top**self.q).union(0),
                (self.k * self.q * top ** (self.q - 1)).union(0),
            )
            grows -= self.inverse * elastic
        along = elastic + self.eta * rate
        square, growth = along * along, 2 * along * (stiff * rate + self.eta * grows)
        if self.reach is not None:
            r = self.reach - overlap
            across = self.eta * spin / r
            square += across * across
            growth += 2 * across * self.eta * (fades / r + spin * rate / (r * r))
        return square, growth
