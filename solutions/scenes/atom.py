"""An atom caught by a molecule, on a line or in a plane: a truncated harmonic well with a hard core (project 12.15)."""

from __future__ import annotations

import math
from dataclasses import replace

from second_way import followed, second_run
from truncated_well import Well, in_well

from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers, one
from corollary.scenes.models.certain import found
from corollary.scenes.run import (
    BadSetting,
    Observable,
    Observed,
    Run,
    components,
)
from corollary.scenes.scene import Body, Scene

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


def play(settings: Settings, tolerance: float) -> Run:
    """Bound: period of the distance, its turning points, the angle turned in one period. Else: the velocity far away.

    On a line `turning_points` are places and `velocities` has one component.
    """
    m, well = one(settings, "m"), Well(*numbers(settings, "k", "b", "d"))
    plane = one(settings, "dimension") == 2.0
    place, velocity = start(settings, well, plane)
    return found(lambda: in_well(well, m, place, velocity, plane))


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


def second_way(settings: Settings, tolerance: float) -> Run:
    plane, m = one(settings, "dimension") == 2.0, one(settings, "m")
    well, axes = Well(*numbers(settings, "k", "b", "d")), 2 if plane else 1
    place, velocity = start(settings, well, plane)
    if not any(velocity) and math.hypot(*place) >= well.edge:  # nothing acts on it
        return second_run({"velocities": velocity[:axes], "escapes": 1.0}, 0.0)
    body = Body(m, place[:axes], velocity[:axes])
    swing, speed = 2.0 * math.pi * math.sqrt(m / well.k), math.hypot(*velocity) or 1.0
    # A period is no longer than a swing on a line; it is seen when the distance has come back twice.
    long = Scene((body,), (well,), until=2.1 * swing)
    run = followed(long, {Observable.VELOCITIES}, tolerance)
    if run.outcome == "escaped":  # beyond the edge nothing changes its velocity any more
        return second_run(run.observed | {"escapes": 1.0}, run.relative_error("velocities"))
    try:
        run = followed(long, {Observable.PERIOD, Observable.TURNING_POINTS}, tolerance)
    except BadSetting:
        gone = Scene((body,), (well,), until=4.0 * swing + 4.0 * (math.hypot(*place) + well.edge) / speed)
        run = followed(gone, {Observable.VELOCITIES, Observable.TURNING_POINTS}, tolerance)
        escapes = {"escapes": float(run.outcome == "escaped")}
        if run.outcome != "escaped":  # round a circle, where the distance never turns
            return replace(run, measured=run.measured | second_run(escapes, 0.0).measured)
        return second_run(run.only(["velocities"]).observed | escapes, run.relative_error("velocities"))
    more: dict[str, Observed] = {"escapes": 0.0}
    if plane:
        # After a period the distance is the same, and the direction has turned.
        times = 0.0, components(run.observed["period"])[0]
        seen = followed(long, {Observable.TRAJECTORY}, tolerance, times).observed["trajectory"]
        x, y, later_x, later_y = components(seen)
        sense = math.copysign(1.0, x * velocity[1] - y * velocity[0])
        turned = sense * math.atan2(x * later_y - y * later_x, x * later_x + y * later_y)
        more["angle"] = sense * (turned % (2.0 * math.pi))
    return replace(run, measured=run.measured | second_run(more, run.error).measured)


SCENE = SceneDefinition(
    "an atom in a truncated harmonic well, on a line or in a plane", SETTINGS, play, second_way=second_way
)
