"""Newton's cradle during the collision: N balls in a row push each other with k overlap^q (project 12.14)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers, one, row
from corollary.scenes.film import AGAIN, Film, film
from corollary.scenes.forces.contact import Contact
from corollary.scenes.line_collision import collide
from corollary.scenes.models.certain import found
from corollary.scenes.models.two_bodies import collision
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import Observed, Run
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("N", "number of balls", "1", 3.0, least=2.0, most=200.0, whole=True),
    Setting("q", "exponent of the contact force", "1", 1.0, least=1.0, most=10.0),
    Setting("m", "mass of each ball", "kg", 0.1, above=0.0),
    Setting("k", "contact constant", "N/m^q", 1e4, above=0.0),
    Setting("v0", "velocity of the balls that come in", "m/s", 1.0, above=0.0),
    Setting("gaps", "gap between neighbours", "m", 0.0, least=0.0, many=True),
    Setting("masses", "mass of each ball (instead of m)", "kg", (), above=0.0, many=True),
    Setting(
        "balls_in", "number of balls that come in together", "1", 1.0, least=1.0, whole=True, below_that="N"
    ),
)


def balls_of(settings: Mapping[str, Observed]) -> tuple[tuple[float, ...], int]:
    """The masses, and how many balls come in. Raises BadSetting."""
    count, coming = round(one(settings, "N")), round(one(settings, "balls_in"))
    masses = row(settings, "masses", count, "balls") if settings["masses"] else (one(settings, "m"),) * count
    return masses, coming


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Velocities after the last opening, time from the first touch until then, the largest overlap and force of any pair.

    The cradle is scaled to mass, force constant and speed one, so cradles that differ only in these share one collision.
    """
    q, k, v0 = (one(settings, name) for name in ("q", "k", "v0"))
    masses, coming = balls_of(settings)
    count = len(masses)
    if count == 2:
        row(settings, "gaps", 1, "gaps")  # however far apart, the collision is the same
        pair = found(lambda: collision((masses[0], masses[1]), (v0, 0.0), Contact(k, q)))
        return pair.only(("velocities", "duration", "largest_overlap", "peak_force"))
    m = masses[0]
    length = (m * v0 / k * v0) ** (1.0 / (q + 1.0))
    line = RowOfBodies(
        masses=tuple(mass / m for mass in masses),
        velocities=(1.0,) * coming + (0.0,) * (count - coming),
        gaps=tuple(gap / length for gap in row(settings, "gaps", count - 1, "gaps")),
        contacts=(Contact(1.0, q),) * (count - 1),
    )
    collided = collide(line, tolerance)
    result = collided.result
    values: dict[str, Observed] = {
        "velocities": tuple(v0 * v for v in result.velocities),
        "duration": result.duration * length / v0,
        "largest_overlap": length * max(result.overlaps),
        "peak_force": m * v0 * v0 / length * max(result.forces),
    }
    return collided.observed(values, {"velocities": v0})


def second_way(settings: Settings, tolerance: float) -> Run | None:
    """None for more than two balls: they are followed in steps in any case."""
    k, q, v0 = numbers(settings, "k", "q", "v0")
    masses, _ = balls_of(settings)
    if len(masses) > 2:
        return None
    row(settings, "gaps", 1, "gaps")  # however far apart, the collision is the same
    found = collide(RowOfBodies(masses, (v0, 0.0), (0.0,), (Contact(k, q),)), tolerance)
    result = found.result
    values: dict[str, Observed] = {
        "velocities": result.velocities,
        "duration": result.duration,
        "largest_overlap": max(result.overlaps),
        "peak_force": max(result.forces),
    }
    return found.observed(values, {"velocities": v0})


def filmed(settings: Settings) -> Film:
    count, coming = round(one(settings, "N")), round(one(settings, "balls_in"))
    q, k, v0 = numbers(settings, "q", "k", "v0")
    masses = row(settings, "masses", count, "balls") if settings["masses"] else (one(settings, "m"),) * count
    gaps = row(settings, "gaps", count - 1, "gaps")
    soft = (max(masses) * v0 / k * v0) ** (1.0 / (q + 1.0))
    radius = max(0.02, 10.0 * soft)
    way, bodies = 6.0 * radius, list[Body]()
    place = 0.0
    for i, mass in enumerate(masses):
        place += (2.0 * radius + (max(gaps[i - 1], way) if i == coming else gaps[i - 1])) if i else 0.0
        bodies.append(Body(mass, (place,), (v0 if i < coming else 0.0,), radius, chr(ord("A") + i)))
    long = (way + math.fsum(gaps[coming:])) / v0
    return film(bodies, [((Contact(k, q),), (1.0 + AGAIN) * long)])


SCENE = SceneDefinition(
    "Newton's cradle: N balls in a row, contact force k overlap^q",
    SETTINGS,
    play,
    second_way=second_way,
    film=filmed,
)
