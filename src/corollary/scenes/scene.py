"""A scene: bodies, the forces between them, and until when it is watched."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import assert_never

from corollary.scenes.body import Body
from corollary.scenes.forces.absorption import Absorption
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.friction import Friction
from corollary.scenes.forces.inverse_square import InverseSquare
from corollary.scenes.forces.spring import Spring
from corollary.scenes.forces.thrust import Thrust
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.forces.well import Well
from corollary.scenes.run import BadSetting

Force = Weight | Contact | HardWall | Friction | Spring | Well | InverseSquare | Thrust | Absorption


@dataclass(frozen=True, slots=True)
class Scene:
    """`until` is a time in s; without it the scene ends when nothing touches and nothing will.

    Raises BadSetting when bodies and forces do not fit together.
    """

    bodies: tuple[Body, ...]
    forces: tuple[Force, ...]
    until: float | None = None
    name: str = "scene"

    def __post_init__(self) -> None:
        axes = {len(vector) for body in self.bodies for vector in (body.place, body.velocity)}
        if axes not in ({1}, {2}):
            raise BadSetting(
                f"{self.name}: places and velocities of all bodies need one component each, or two each."
            )
        for body in self.bodies:
            if not body.mass > 0.0 or body.radius < 0.0:
                raise BadSetting(
                    f"{self.name}: a body needs a mass above zero and a radius of zero or more; {body} has not."
                )
        for force in self.forces:
            if any(not 0 <= i < len(self.bodies) for i in bodies_of(force)):
                raise BadSetting(
                    f"{self.name}: {force} names a body that is not there; they are counted from 0."
                )
        if self.until is not None and not self.until > 0.0:
            raise BadSetting(f"{self.name}: until = {self.until} s must be more than zero.")

    @property
    def axes(self) -> int:
        return len(self.bodies[0].place)

    @property
    def walls_at_rest(self) -> bool:
        """Whether no body of infinite mass moves; one that does would do work."""
        return not any(math.isinf(body.mass) and any(body.velocity) for body in self.bodies)

    def has_only(self, *kinds: type) -> bool:
        """Whether every force is of one of these kinds."""
        return all(isinstance(force, kinds) for force in self.forces)


def bodies_of(force: Force) -> tuple[int, ...]:
    """The bodies a force names by their places in the scene; most forces act on all of them."""
    match force:
        case Spring(ends=ends) | InverseSquare(ends=ends):
            return ends
        case Friction(body=i) | Thrust(body=i) | Absorption(body=i):
            return (i,)
        case Weight() | Contact() | HardWall() | Well():
            return ()
        case _:
            assert_never(force)
