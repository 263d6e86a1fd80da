"""A scene of discs written both ways: for the reference by enumerated modes, and for what is judged."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from random import Random
from typing import NamedTuple

from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.rod import Rod, String
from corollary.scenes.forces.wall import HardWall
from corollary.scenes.forces.weight import Weight
from corollary.scenes.run import Observable
from corollary.scenes.scene import Body, Force, Scene

from .case import Case
from .discs import Composed, Motion
from .enumerated import Course, Fineness, observed
from .modes import NoReference

FINE, COARSE = Fineness(), Fineness(relative=1e-11, bounce=1e-5)
KNOWN = 1e-4
"""Of a reference's size: where two runs differ by more than that, they say too little."""
ROUNDED = 3e-14
"""Of what is about one, or of the size of larger values: what rounding in either run may leave."""
Vector = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Setting:
    """`passes` are pairs of points that never touch."""

    given: Composed
    until: float
    passes: tuple[tuple[int, int], ...] = ()


class Frame(NamedTuple):
    """Along a slope, and away from it."""

    along: Vector
    normal: Vector

    def at(self, x: float, y: float) -> Vector:
        return x * self.along[0] + y * self.normal[0], x * self.along[1] + y * self.normal[1]


def sloping(angle: float) -> Frame:
    return Frame((math.cos(angle), math.sin(angle)), (-math.sin(angle), math.cos(angle)))


def turned(vector: Vector, angle: float) -> Vector:
    c, s = math.cos(angle), math.sin(angle)
    return vector[0] * c - vector[1] * s, vector[0] * s + vector[1] * c


def dot(one: Vector, other: Vector) -> float:
    return one[0] * other[0] + one[1] * other[1]


def maybe(draw: Random, low: float, high: float, zeros: int = 1) -> float:
    """Either none, so many times out of one more, or a number between."""
    return draw.choice([0.0] * zeros + [draw.uniform(low, high)])


def swinging(amplitude: float, rate: float, phase: float) -> Motion:
    """A swing that begins at zero."""
    start = amplitude * math.sin(phase)

    def moves(t: float) -> tuple[float, float, float]:
        s, c = math.sin(rate * t + phase), math.cos(rate * t + phase)
        return amplitude * s - start, amplitude * rate * c, -amplitude * rate * rate * s

    return moves


def scene(setting: Setting) -> Scene:
    given = setting.given
    bodies = [
        Body(each.mass, each.place, each.velocity, each.radius, spin=each.spin, inertia=each.inertia)
        for each in given.discs
    ]
    forces: list[Force] = [Weight(given.gravity)] if given.gravity else []
    for each in given.plates:
        forces.append(
            HardWall(
                each.normal,
                each.offset,
                each.restitution,
                each.friction,
                velocity=each.speed,
                moves=each.moves,
                only=each.only,
            )
        )
    forces += [Rod(ends) for ends in given.bars]
    forces += [String(each.ends, each.length, each.restitution) for each in given.cords]
    if touch := given.contact:
        forces.append(
            Contact(touch.stiffness, touch.power, touch.damping, touch.friction, chosen=touch.pairs)
        )
    return Scene(tuple(bodies), tuple(forces), until=setting.until, passes=setting.passes)


def known(draw: Random, family: str, make: Callable[[Random], Setting | None]) -> Case:
    """The first of what `make` draws of which two runs of the reference, with other steps and other bounces left out, know enough."""
    while True:
        try:
            if setting := make(draw):
                times = tuple(sorted(draw.uniform(0, setting.until) for _ in range(2)))
                if case := _compared(family, setting, times):
                    return case
        except NoReference:
            continue


def _compared(family: str, setting: Setting, times: tuple[float, ...]) -> Case | None:
    given = setting.given
    fine, coarse = (observed(Course(given, each), times, setting.until) for each in (FINE, COARSE))
    rough = any(each.friction for each in given.plates) or (given.contact and given.contact.friction)
    asked = [Observable.VELOCITIES, Observable.TRAJECTORY, Observable.ENERGY]
    if rough and any(each.radius for each in given.discs):
        asked.append(Observable.SPINS)
    if given.contact:
        asked.append(Observable.PEAK_FORCE)
    truth, doubt = {}, {}
    for each in asked:
        values, others = fine[each.value], coarse[each.value]
        size = max(1.0, *map(abs, values))
        differ = max(abs(a - b) for a, b in zip(values, others, strict=True))
        if differ > KNOWN * size:
            return None
        truth[each], doubt[each] = values, 3 * differ + ROUNDED * size
    return Case(family, scene(setting), truth, times, doubt)
