"""Bodies, constraints that hold them, and slips that dry friction brakes.

Rows are over the generalized velocity: all velocities body after body, then all spins where bodies have any.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

# So small a cosine of the angle between two vectors is what rounding leaves of none.
ACROSS = 4.5e-16


@dataclass(frozen=True, slots=True)
class Body:
    """SI; `place` and `velocity` are tuples of one or two components. A body of infinite mass is a wall: it keeps its velocity.

    In a plane a body with a radius can spin: `spin` in rad/s, counter-clockwise, `inertia` about its centre in kg m^2 (infinite: nothing
    turns it), that of a solid sphere unless another is given. The scene that it is in refuses what no body can be (BadSetting).
    """

    mass: float
    place: tuple[float, ...]
    velocity: tuple[float, ...]
    radius: float = 0.0
    name: str = ""
    spin: float = 0.0
    inertia: float | None = None

    @property
    def resists_spin(self) -> float:
        """The moment of inertia (kg m^2): infinite for a point and for a wall, which nothing turns."""
        if self.inertia is not None:
            return self.inertia
        return 0.4 * self.mass * self.radius**2 if self.radius > 0.0 else math.inf


def starts_across(body: Body) -> bool:
    """Whether a body starts at rest, or across the way to the origin, but for rounding: its distance turns there."""
    along = sum(x * v for x, v in zip(body.place, body.velocity, strict=True))
    return abs(along) <= ACROSS * math.hypot(*body.place) * math.hypot(*body.velocity)


def inside(apart: Sequence[float], reach: float) -> float:
    """How far (m) a place is within a reach, nearly: squares are as smooth as the way, distances bend beside the centre."""
    return (reach * reach - sum(x * x for x in apart)) / (2.0 * reach)


def nothing_moves(first: Body, second: Body) -> bool:
    """Whether both are walls: what acts between them moves nothing."""
    return math.isinf(min(first.mass, second.mass))


def loose(bodies: Sequence[Body]) -> list[int]:
    """Which of the bodies forces can move."""
    return [i for i, body in enumerate(bodies) if not math.isinf(body.mass)]


def bounced(normal: Sequence[float], velocity: Sequence[float], restitution: float) -> list[float]:
    """The velocity after a bounce on a plane with this unit normal: what goes into it comes back with the restitution's share."""
    into = min(sum(n * v for n, v in zip(normal, velocity, strict=True)), 0.0)
    return [v - (1.0 + restitution) * into * n for n, v in zip(normal, velocity, strict=True)]


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
