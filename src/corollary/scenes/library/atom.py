"""An atom caught by a molecule, on a line or in a plane: a truncated harmonic well with a hard core (project 12.15)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.forces.well import Well
from corollary.scenes.models.central import Radial, radial, swept
from corollary.scenes.run import BadSetting, Observed, Run

SETTINGS = (
    Setting("m", "mass of the atom", "kg", 2.0, above=0.0),
    Setting("k", "force constant", "N/m", 100.0, above=0.0),
    Setting("b", "distance of the bottom of the well", "m", 1.0, above=0.0),
    Setting("d", "half width of the well", "m", 0.4, above=0.0),
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


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Bound: period of the distance, its turning points, the angle turned in one period. Else: the velocity far away.

    On a line `turning_points` are places and `velocities` has one component.
    """
    m, well = one(settings, "m"), Well(*(one(settings, name) for name in ("k", "b", "d")))
    if well.d >= well.b:
        raise BadSetting(f"atom: d = {well.d:g} m must be less than b = {well.b:g} m: the core has a size.")
    plane = one(settings, "dimension") == 2.0
    (x, y), (u, v) = _start(settings, plane)
    r = math.hypot(x, y) if plane else x
    if r < well.wall:
        raise BadSetting(
            f"atom: r0 = {r:g} m is inside the core; start at b - d = {well.wall:g} m or beyond."
        )
    along, across = (x * u + y * v) / r, (x * v - y * u) / r
    if r > well.edge:
        return _from_outside(well, m, r, along, across, math.atan2(y, x), plane)
    motion = radial(well, m, r, along, across)
    if motion.square_of_speed(well.edge) > 0.0 and (motion.high > well.edge or r == well.edge):
        return _leaves(well, motion, r, along, math.atan2(y, x), plane, 0.0)
    return _bound(motion, plane)


def _start(settings: Mapping[str, Observed], plane: bool) -> tuple[tuple[float, float], tuple[float, float]]:
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
    return (place[0], place[1]), (velocity[0], velocity[1])


def _bound(motion: Radial, plane: bool) -> Run:
    if motion.spin == 0.0:
        period, angle, error_estimate, spent = 2.0 * math.pi / motion.frequency, 0.0, ROUNDING, 0
    else:
        half, half_angle, error_estimate, spent = swept(motion, 0.0, math.pi)
        period, angle = 2.0 * half, 2.0 * half_angle
    observed: dict[str, Observed] = {
        "period": period,
        "turning_points": (motion.low, motion.high),
        "escapes": 0.0,
    }
    if plane:
        observed["angle"] = angle
    errors = dict.fromkeys(observed, max(4.0 * error_estimate, ROUNDING))
    if motion.spin == 0.0:
        why = "bound, on a line through the centre: a harmonic swing, known exactly"
        return Run(observed, errors, "piecewise exact", why, spent, "bound")
    why = "bound in a plane: energy and angular momentum leave two integrals between the turning points"
    return Run(observed, errors, "quadrature", why, spent, "bound")


def _leaves(
    well: Well, motion: Radial, r: float, along: float, angle: float, plane: bool, before: float
) -> Run:
    """In to the core or the turning point if it moves inward, then out over the edge; nothing acts beyond."""
    nearest = max(motion.low, well.wall)
    begin, core, edge = motion.phase(r), motion.phase(nearest), motion.phase(well.edge)
    inward = along < 0.0
    legs = [swept(motion, core, begin), swept(motion, core, edge)] if inward else [swept(motion, begin, edge)]
    time, turned = (math.fsum(leg[i] for leg in legs) for i in (0, 1))
    error_estimate, spent = max(leg[2] for leg in legs), sum(leg[3] for leg in legs)
    outward, across = math.sqrt(motion.square_of_speed(well.edge)), motion.spin / well.edge
    c, s = math.cos(angle + turned), math.sin(angle + turned)
    velocities = (outward * c - across * s, outward * s + across * c) if plane else (outward,)
    observed: dict[str, Observed] = {
        "velocities": velocities,
        "turning_points": (nearest,) if inward else (),
        "duration": before + time,
        "escapes": 1.0,
    }
    why = "it has the energy to leave: integrals of the energy give when and where, a straight line the rest"
    return Run(
        observed,
        dict.fromkeys(observed, max(8.0 * error_estimate, ROUNDING)),
        "quadrature",
        why,
        spent,
        "escaped",
    )


def _from_outside(
    well: Well, m: float, r: float, along: float, across: float, angle: float, plane: bool
) -> Run:
    """A straight line until the edge of the well, if it is met at all."""
    speed = math.hypot(along, across)
    room = (well.edge * speed - r * abs(across)) * (well.edge * speed + r * abs(across))
    if along >= 0.0 or room <= 0.0:
        c, s = math.cos(angle), math.sin(angle)
        velocities = (along * c - across * s, along * s + across * c) if plane else (along,)
        observed: dict[str, Observed] = {"velocities": velocities, "turning_points": (), "escapes": 1.0}
        return Run(
            observed,
            dict.fromkeys(observed, ROUNDING),
            "conservation",
            "it passes outside the well",
            0,
            "missed",
        )
    inward, way = math.sqrt(room) / well.edge, (r - well.edge) * (r + well.edge)
    after = way / (-r * along + math.sqrt(room))
    entered = angle + math.atan2(across * after, r + along * after)
    motion = radial(well, m, well.edge, -inward, r * across / well.edge)
    return _leaves(well, motion, well.edge, -inward, entered, plane, after)


SCENE = SceneDefinition("an atom in a truncated harmonic well, on a line or in a plane", SETTINGS, play)
