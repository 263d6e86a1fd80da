"""The truncated harmonic well of a molecule: its force, and the motion of an atom in it by rigorous quadrature."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from flint import acb, arb

from corollary.formula.ball import Ball
from corollary.formula.functions import ball_root
from corollary.scenes.body import State, bounced, inside, loose
from corollary.scenes.models.certain import Balls, Evaluated, integral, root, sign
from corollary.scenes.run import BadSetting
from corollary.scenes.scene import Conserves, Event, Force, Pushes, Scene, place, velocity
from corollary.scenes.validation import refuse_below_zero

LATE = 1e-15
"""By such a part of its radius a core is met late."""
GONE = "it starts at the edge on its way out: nothing acts beyond"


@dataclass(frozen=True, slots=True)
class Well(Force):
    """U = k (r - b)^2 / 2 for b - d < r < b + d, k d^2 / 2 farther out, a hard core at b - d; r is the distance from the origin.

    k, b and d are above zero, and d is below b. What has no end of mass does not feel it. Source: equations (12.138) and (12.140).
    """

    k: float
    b: float
    d: float

    @property
    def edge(self) -> float:
        return self.b + self.d

    @property
    def wall(self) -> float:
        return self.b - self.d

    def fits(self, scene: Scene) -> None:
        refuse_below_zero(scene.name, self, above=("k", "b", "d"))
        if self.d >= self.b:
            raise BadSetting(
                f"{scene.name}: the Well has d = {self.d:g} m and b = {self.b:g} m, and its core, at b - d, is to be beyond the origin: lower d."
            )
        for i in loose(scene.bodies):
            if math.hypot(*scene.bodies[i].place) < self.wall:
                raise BadSetting(
                    f"{scene.name}: body {i} starts inside the core of the Well; b - d = {self.wall:g} m from the origin, or farther, is right."
                )

    def act(self, scene: Scene, state: State, masses: Sequence[float], since: State) -> Pushes:
        """On the bodies that a step begins with inside the edge.

        They feel it to the end of the step: the stages of a step that ends at the edge reach over it, and a force that jumps within
        a step would cost the method its order.
        """
        for i in loose(scene.bodies):
            if inside(place(scene, since, i), self.edge) > 0.0:
                x = place(scene, state, i)
                r = math.hypot(*x)
                yield i, [-self.k * (r - self.b) * c / r for c in x]

    def potential(self, scene: Scene, state: State) -> float:
        """Zero at the bottom of the well."""
        places = (place(scene, state, i) for i in loose(scene.bodies))
        return sum(0.5 * self.k * min(math.hypot(*x) - self.b, self.d) ** 2 for x in places)

    def events(self, scene: Scene) -> Iterator[Event]:
        """A body reaches the edge, or the hard core, which is a wall square to the radius.

        It is met a few roundings late: what starts at the core, on its way in, is in front of it.
        """
        core = self.wall * (1.0 - LATE)

        def turned(y: State, i: int) -> list[float]:
            x = place(scene, y, i)
            r = math.hypot(*x)
            return bounced([c / r for c in x], velocity(scene, y, i), 1.0)

        for i in loose(scene.bodies):
            yield Event(lambda y, i=i: inside(place(scene, y, i), self.edge))
            yield Event(lambda y, i=i: -inside(place(scene, y, i), core), i, lambda y, i=i: turned(y, i))

    @property
    def may_be_brief(self) -> bool:
        """It acts as long as a body is within its edge."""
        return False

    @property
    def conserves(self) -> Conserves:
        return Conserves.ENERGY


@dataclass(frozen=True, slots=True)
class Radial:
    """Motion of the distance r at given energy and spin (angular momentum per mass) as if the well had no edge, in balls.

    `frequency` w is the angular one of a swing along a line. square_of_speed(r) = 2 E/m - w^2 (r-b)^2 - spin^2/r^2 is concave, so
    r stays between two roots `low` and `high`. Between them r^2 times that square is w^2 (r - low)(high - r)(r^2 + p r + s).
    """

    well: Well
    frequency: arb
    spin: arb
    double_energy: arb
    low: arb
    high: arb

    def square_of_speed(self, r: arb) -> arb:
        """The square of dr/dt; negative where the atom cannot be."""
        return self.double_energy - (self.frequency * (r - arb(self.well.b))) ** 2 - (self.spin / r) ** 2

    def phase(self, r: arb) -> arb:
        """From 0 (at `low`) to pi (at `high`)."""
        if r is self.low or r is self.high:
            return arb(0) if r is self.low else arb.pi()
        behind, ahead = (ball_root(each.max(arb(0)), 2) for each in (r - self.low, self.high - r))
        return 2 * arb.atan2(behind, ahead)

    def swept(self, start: arb, end: arb) -> tuple[arb, arb]:
        """Time and angle between two phases."""
        w = self.frequency
        if sign(self.spin) == 0:
            return (end - start) / w, arb(0)
        low, wide = acb(self.low), acb(self.high - self.low)
        p = acb(self.low + self.high - 2 * arb(self.well.b))
        s = acb(self.spin**2 / (w * w * self.low * self.high))

        def place(phase: acb) -> acb:
            return low + wide * (phase / 2).sin() ** 2

        def pace(phase: acb, analytic: bool) -> acb:
            r = place(phase)
            return r / (r * r + p * r + s).sqrt(analytic=analytic)

        def turn(phase: acb, analytic: bool) -> acb:
            r = place(phase)
            return 1 / (r * (r * r + p * r + s).sqrt(analytic=analytic))

        return integral(pace, start, end) / w, self.spin * integral(turn, start, end) / w


def radial(well: Well, m: arb, r: arb, along: arb, spin: arb) -> Radial:
    """The radial motion of an atom of mass m at distance r, with this velocity along the radius and angular momentum per mass."""
    w, b = (arb(well.k) / m).sqrt(), arb(well.b)
    double = along * along + (spin / r) ** 2 + (w * (r - b)) ** 2
    reach = double.sqrt() / w if sign(double) else arb(0)
    if sign(spin) == 0:
        return Radial(well, w, arb(0), double, b - reach, b + reach)
    near, far = (abs(spin) / double.sqrt()).lower() / 2, (b + 2 * reach).upper()
    if sign(along) == 0:
        return Radial(well, w, spin, double, *_turns(well, m, spin, r, near, far))
    # r lies between the roots: the square of its speed is that of `along`.
    square = Radial(well, w, spin, double, r, r).square_of_speed
    return Radial(well, w, spin, double, root(square, near, r), -root(lambda x: square(-x), -far, -r))


def _turns(well: Well, m: arb, spin: arb, r: arb, near: arb, far: arb) -> tuple[arb, arb]:
    """Both turning points of an atom that starts at one of them, r.

    Taken out of the square of the speed, what is left falls through zero once, at the other.
    """

    def left(x: arb) -> arb:
        return arb(well.k) * (x + r - 2 * arb(well.b)) - m * (spin / (x * r)) ** 2 * (x + r)

    # Without a quotient, so that a circle is told exactly.
    match sign(arb(well.k) * (r - arb(well.b)) * r**3 - m * spin * spin):
        case 0:
            return r, r
        case -1:
            return r, root(left, r, far)
        case _:
            return root(left, near, r), r


def in_well(
    well: Well, mass: float, place: tuple[float, float], velocity: tuple[float, float], plane: bool
) -> Evaluated:
    """A body in a truncated harmonic well, or on its way there: bound, or with its velocity once nothing acts any more."""
    m, (x, y), (u, v) = Ball(mass), map(Ball, place), map(Ball, velocity)
    r = (x * x + y * y).sqrt() if place[1] else abs(x)
    along, spin = (x * u + y * v) / r, x * v - y * u
    at, edge = Ball.atan2(y, x), Ball(well.edge)
    if sign(x * x + y * y - edge * edge) > 0:
        return _into_well(well, m, r, along, spin, at, plane)
    motion = radial(well, m, r, along, spin)
    # On the edge and not on its way in it is gone: nothing pulls beyond.
    if sign(x * x + y * y - edge * edge) == 0 and sign(along) >= 0:
        return Evaluated(
            "escaped", _straight(at, along, spin / r, plane) | {"duration": Ball(0)}, "conservation", GONE
        )
    leaves = sign(motion.square_of_speed(edge)) > 0 and sign(motion.high - edge) > 0
    return _out_of_well(well, motion, r, along, at, plane, Ball(0)) if leaves else _caught(motion, plane)


def _caught(motion: Radial, plane: bool) -> Evaluated:
    lasted, turned = (2 * each for each in motion.swept(Ball(0), Ball.pi()))
    values: dict[str, Balls] = {
        "period": lasted,
        "turning_points": (motion.low, motion.high),
        "escapes": Ball(0),
    }
    if plane:
        values["angle"] = turned
    if sign(motion.spin) == 0:
        why = "bound, on a line through the centre: a harmonic swing, known exactly"
        return Evaluated("bound", values, "piecewise exact", why)
    why = "bound in a plane: energy and angular momentum leave two integrals between the turning points"
    return Evaluated("bound", values, "quadrature", why)


def _out_of_well(
    well: Well, motion: Radial, r: Ball, along: Ball, angle: Ball, plane: bool, before: Ball
) -> Evaluated:
    """In to the core or the turning point if it moves inward, then out over the edge; nothing acts beyond."""
    wall, edge = Ball(well.wall), Ball(well.edge)
    nearest = wall if sign(motion.low - wall) < 0 else motion.low
    begin, core, rim = motion.phase(r), motion.phase(nearest), motion.phase(edge)
    inward = sign(along) < 0
    legs = [motion.swept(core if inward else begin, rim)]
    if inward and sign(r - nearest) > 0:  # else it turns at once
        legs.insert(0, motion.swept(core, begin))
    time, turned = before, angle
    for lasted, swept in legs:
        time, turned = time + lasted, turned + swept
    outward, across = motion.square_of_speed(edge).sqrt(), motion.spin / edge
    c, s = turned.cos(), turned.sin()
    values: dict[str, Balls] = {
        "velocities": (outward * c - across * s, outward * s + across * c) if plane else (outward,),
        "turning_points": (nearest,) if inward else (),
        "duration": time,
        "escapes": Ball(1),
    }
    why = "it has the energy to leave: integrals of the energy give when and where, a straight line the rest"
    return Evaluated("escaped", values, "quadrature", why)


def _into_well(well: Well, m: Ball, r: Ball, along: Ball, spin: Ball, angle: Ball, plane: bool) -> Evaluated:
    """A straight line until the edge of the well, if it is met at all."""
    edge = Ball(well.edge)
    square = along * along + (spin / r) ** 2
    room = edge * edge * square - spin * spin
    if sign(along) >= 0 or sign(room) <= 0:
        return Evaluated(
            "missed", _straight(angle, along, spin / r, plane), "conservation", "it passes outside the well"
        )
    inward, way = room.sqrt() / edge, (r - edge) * (r + edge)
    after = way / (room.sqrt() - r * along)
    entered = angle + Ball.atan2(spin / r * after, r + along * after)
    return _out_of_well(well, radial(well, m, edge, -inward, spin), edge, -inward, entered, plane, after)


def _straight(angle: Ball, along: Ball, across: Ball, plane: bool) -> dict[str, Balls]:
    """What is seen of an atom on which nothing acts any more."""
    c, s = angle.cos(), angle.sin()
    velocities = (along * c - across * s, along * s + across * c) if plane else (along,)
    return {"velocities": velocities, "turning_points": (), "escapes": Ball(1)}
