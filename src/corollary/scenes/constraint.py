"""Constraints that hold bodies, gaps that cannot be negative, and slips that dry friction brakes.

Rows are over the generalized velocity: all velocities body after body, then all spins where bodies have any.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

State = Sequence[float]


@dataclass(frozen=True, slots=True)
class Constraint:
    """A gap (m) that is never negative or, with `two_sided`, always zero; the bodies are held by a force along its row.

    d(gap)/dt = row . velocity, and d2(gap)/dt2 = row . acceleration + drift. What closes with a speed opens again with
    `restitution` times that, or with up to the part `less` less, another one each time: what comes of a run that differs by so much.
    """

    name: str
    bodies: tuple[int, ...]
    gap: Callable[[float, State], float]
    row: Callable[[float, State], list[float]]
    drift: Callable[[float, State], float]
    restitution: float = 0.0
    two_sided: bool = False
    less: float = 0.0

    def gives_back(self, time: float) -> float:
        """The share of a speed that it opens with after a hit at a time (s)."""
        return self.restitution * (1.0 - self.less * (1e3 * math.frexp(time)[0] % 1.0))


@dataclass(frozen=True, slots=True)
class Rub:
    """Dry friction of one body on one surface, on a slip row . velocity (m/s), by Coulomb's law.

    While it slips the force is `kinetic` times the normal force against it; at rest it is whatever keeps it at rest, up to `static`
    times that. The normal force is `normal` (N) at a time, or that of the constraint it is `pressed` by.
    """

    name: str
    body: int
    row: list[float]
    kinetic: float
    static: float
    normal: Callable[[float], float] | None = None
    pressed: Constraint | None = None
