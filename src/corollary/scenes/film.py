"""A motion to look at: bodies followed act by act, and their places and velocities at moments near enough to draw it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from corollary.scenes.forces.bonds import Rod
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import Body, Force, Scene, place, start_of, velocity

FRAMES = 60  # of an act, besides the moments at which something happens
WALL = 1e6  # a body so many times as heavy as the lightest is a wall to the eye, and would drown the others in every total
TOLERANCE = 1e-8
AT_ONCE = 1e-13  # of an act
AGAIN = 1.1  # how much longer the time after a hit is watched than the time before
NAIL = "nail"
BLOCK = "block"

Point = tuple[float, float]
Vector = tuple[Point, ...]
Line = tuple[Point, Point]
Act = tuple[Sequence[Force], float]
"""Forces, and how long (s) they act."""


@dataclass(frozen=True, slots=True)
class Film:
    """SI, across and up. `places` and `velocities` have a point for each body at each of the `times`, `stored` the potential energy (J), that of
    contacts left out: they let go at once.

    `radii` are what bodies are drawn with; `lines` are floors and walls, `ropes` join two bodies. A body of infinite mass is a nail or
    a wall: it counts in no total.
    """

    bodies: tuple[Body, ...]
    times: tuple[float, ...]
    places: tuple[Vector, ...]
    velocities: tuple[Vector, ...]
    stored: tuple[float, ...]
    radii: tuple[float, ...]
    lines: tuple[Line, ...] = ()
    ropes: tuple[tuple[int, int], ...] = ()

    @property
    def loose(self) -> tuple[int, ...]:
        """The bodies that count in totals."""
        lightest = min(body.mass for body in self.bodies)
        return tuple(i for i, body in enumerate(self.bodies) if body.mass < WALL * lightest)

    def momentum(self, frame: int) -> Point:
        """Of all bodies that move together (kg m/s)."""
        moving = [(self.bodies[i].mass, self.velocities[frame][i]) for i in self.loose]
        return math.fsum(m * v[0] for m, v in moving), math.fsum(m * v[1] for m, v in moving)

    def kinetic(self, frame: int) -> float:
        """Energy of their motion (J), that of spins left out."""
        return math.fsum(
            0.5 * self.bodies[i].mass * math.hypot(*self.velocities[frame][i]) ** 2 for i in self.loose
        )


def film(
    bodies: Sequence[Body],
    acts: Sequence[Act],
    *,
    radii: Sequence[float] = (),
    upright: bool = False,
    lines: Sequence[Line] = (),
    ropes: Sequence[tuple[int, int]] = (),
) -> Film:
    """The acts one after the other, each from where the last one ended; `upright` draws a line of one component upward.

    Raises BadSetting and GuardFailed as the integration does.
    """
    from corollary.scenes.motion.follow import follow  # here, since it brings scipy

    cast, begin, name = tuple(bodies), 0.0, "film"
    times: list[float] = []
    states: list[Sequence[float]] = []
    stored: list[float] = []
    for forces, lasts in acts:
        cast = _swinging(cast, forces)
        scene = Scene(cast, tuple(forces), until=lasts, name=name)
        path = follow(scene, TOLERANCE)
        happened = sorted(each.time for each in path.happenings if 0.0 < each.time < lasts)
        # What happens to several bodies at one moment, but for rounding, is one picture.
        apart = {t for s, t in pairwise((-math.inf, *happened)) if t - s > AT_ONCE * lasts}
        moments = sorted({lasts * i / FRAMES for i in range(FRAMES + 1)} | apart)
        for moment in moments:
            state = path.at(moment) if moment else start_of(scene)
            times.append(begin + moment)
            states.append(state)
            stored.append(math.fsum(f.potential(scene, state) for f in forces if f not in scene.contacts))
        cast = tuple(
            replace(
                body, place=tuple(place(scene, path.state, i)), velocity=tuple(velocity(scene, path.state, i))
            )
            for i, body in enumerate(cast)
        )
        begin += lasts
    if len(times) < 2:
        raise BadSetting(f"{name}: nothing is to be seen without an act")
    return Film(
        bodies=tuple(bodies),
        times=tuple(times),
        places=tuple(_points(cast, state, 0, upright) for state in states),
        velocities=tuple(_points(cast, state, 1, upright) for state in states),
        stored=tuple(stored),
        radii=tuple(radii) or tuple(body.radius for body in bodies),
        lines=tuple(lines),
        ropes=tuple(ropes),
    )


def _swinging(bodies: Sequence[Body], forces: Sequence[Force]) -> tuple[Body, ...]:
    """The bodies as an act begins: what hangs from a nail by a rod goes across it, whatever it did in the act before."""
    found = list(bodies)
    for rod in forces:
        if not isinstance(rod, Rod) or not math.isinf(bodies[rod.ends[0]].mass):
            continue
        nail, body = bodies[rod.ends[0]], found[rod.ends[1]]
        apart = [x - y for x, y in zip(body.place, nail.place, strict=True)]
        relative = [v - u for v, u in zip(body.velocity, nail.velocity, strict=True)]
        share = sum(x * v for x, v in zip(apart, relative, strict=True)) / sum(x * x for x in apart)
        across = tuple(v - share * x for x, v in zip(apart, body.velocity, strict=True))
        found[rod.ends[1]] = replace(body, velocity=across)
    return tuple(found)


def _points(bodies: Sequence[Body], state: Sequence[float], half: int, upright: bool) -> Vector:
    """Places (half 0) or velocities (half 1) of a state, across and up."""
    axes = len(bodies[0].place)
    start = half * axes * len(bodies)
    rows = [tuple(state[start + axes * i : start + axes * (i + 1)]) for i in range(len(bodies))]
    return tuple(
        (row[0], row[1]) if axes == 2 else (0.0, row[0]) if upright else (row[0], 0.0) for row in rows
    )
