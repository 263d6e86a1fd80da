"""An atom caught by a molecule, on a line or in a plane: a truncated harmonic well with a hard core (project 12.15)."""

from __future__ import annotations

import math

from corollary.formula.ball import Ball
from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers, one
from corollary.scenes.forces.well import Well
from corollary.scenes.models.central import Radial, radial
from corollary.scenes.models.certain import Balls, Evaluated, found, sign
from corollary.scenes.run import BadSetting, Run

SETTINGS = (
    Setting("m", "mass of the atom", "kg", 2.0, above=0.0),
    Setting("k", "force constant", "N/m", 100.0, above=0.0),
    Setting("b", "distance of the bottom of the well", "m", 1.0, above=0.0),
    Setting("d", "half width of the well", "m", 0.4, above=0.0, below_that="b"),
    Setting("r0", "position at the start: a distance, or (x, y)", "m", 1.0, many=True),
    Setting(
        "v0",
        "velocity at the start: along the line, across the radius in a plane, or (x, y)",
        "m/s",
        3.0,
        many=True,
    ),
    Setting("dimension", "1 for a line, 2 for a plane", "1", 2.0, least=1.0, most=2.0, whole=True),
)

GONE = "it starts at the edge on its way out: nothing acts beyond"


def play(settings: Settings, tolerance: float) -> Run:
    """Bound: period of the distance, its turning points, the angle turned in one period. Else: the velocity far away.

    On a line `turning_points` are places and `velocities` has one component.
    """
    m, well = one(settings, "m"), Well(*numbers(settings, "k", "b", "d"))
    plane = one(settings, "dimension") == 2.0
    place, velocity = start(settings, well, plane)
    return found(lambda: motion(well, m, place, velocity, plane))


def start(settings: Settings, well: Well, plane: bool) -> tuple[tuple[float, float], tuple[float, float]]:
    """Place (m) and velocity (m/s) at the start, (x, y). Raises BadSetting for what is inside the core or has no such components."""
    r, v = settings["r0"], settings["v0"]
    place = r if isinstance(r, tuple) else (r, 0.0)
    velocity = v if isinstance(v, tuple) else ((0.0, v) if plane else (v, 0.0))
    if len(place) != 2 or len(velocity) != 2:
        raise BadSetting("atom: r0 and v0 are one number each, or two components.")
    if not plane and (place[1] or velocity[1]):
        raise BadSetting(
            "atom: on a line the second components of r0 and v0 are zero; set dimension to 2 for a plane."
        )
    if place == (0.0, 0.0) or (not plane and place[0] < 0.0):
        raise BadSetting("atom: the molecule is at the origin; start at a positive distance from it.")
    if math.hypot(*place) < well.wall:
        raise BadSetting(
            f"atom: r0 = {math.hypot(*place):g} m is inside the core; start at b - d = {well.wall:g} m or beyond."
        )
    return (place[0], place[1]), (velocity[0], velocity[1])


def motion(
    well: Well, mass: float, place: tuple[float, float], velocity: tuple[float, float], plane: bool
) -> Evaluated:
    m, (x, y), (u, v) = Ball(mass), map(Ball, place), map(Ball, velocity)
    r = (x * x + y * y).sqrt() if place[1] else abs(x)
    along, spin = (x * u + y * v) / r, x * v - y * u
    at, edge = Ball.atan2(y, x), Ball(well.edge)
    if sign(x * x + y * y - edge * edge) > 0:
        return _from_outside(well, m, r, along, spin, at, plane)
    motion = radial(well, m, r, along, spin)
    # On the edge and not on its way in it is gone: nothing pulls beyond.
    if sign(x * x + y * y - edge * edge) == 0 and sign(along) >= 0:
        return Evaluated(
            "escaped", _straight(at, along, spin / r, plane) | {"duration": Ball(0)}, "conservation", GONE
        )
    leaves = sign(motion.square_of_speed(edge)) > 0 and sign(motion.high - edge) > 0
    return _leaves(well, motion, r, along, at, plane, Ball(0)) if leaves else _bound(motion, plane)


def _bound(motion: Radial, plane: bool) -> Evaluated:
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


def _leaves(
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


def _from_outside(
    well: Well, m: Ball, r: Ball, along: Ball, spin: Ball, angle: Ball, plane: bool
) -> Evaluated:
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
    return _leaves(well, radial(well, m, edge, -inward, spin), edge, -inward, entered, plane, after)


def _straight(angle: Ball, along: Ball, across: Ball, plane: bool) -> dict[str, Balls]:
    """What is seen of an atom on which nothing acts any more."""
    c, s = angle.cos(), angle.sin()
    velocities = (along * c - across * s, along * s + across * c) if plane else (along,)
    return {"velocities": velocities, "turning_points": (), "escapes": Ball(1)}


SCENE = SceneDefinition("an atom in a truncated harmonic well, on a line or in a plane", SETTINGS, play)
