"""A pendulum let go from the horizontal hits a block at the bottom of its path, elastically (exercise 12.12)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from falls_and_swings import EXACT, swung, until

from corollary.formula.ball import Ball
from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers
from corollary.scenes.film import NAIL, Film, film
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.contact import Contact, HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.line_collision import SAFE
from corollary.scenes.models.certain import Balls, Evaluated, balls, found
from corollary.scenes.models.two_bodies import BETA, undamped
from corollary.scenes.run import (
    STEPS,
    Model,
    Observed,
    Run,
    by_relative_errors,
    components,
    two_runs,
)
from corollary.scenes.scene import Body

LAST_STEPS = 10.0
"""So many times what a step may be off is what two runs have in common."""
LONG_STEPS = 1e-8
"""From here on steps are so long that two runs tell little of their error; they cost little less, too."""
QUARTER = 1.8540746773013719  # a swing from the horizontal to the bottom, in sqrt(L/g): the complete elliptic integral K(1/2)

SETTINGS = (
    Setting("m", "mass of the sphere", "kg", 1.0, above=0.0),
    Setting("M", "mass of the block", "kg", 2.0, above=0.0),
    Setting("L", "length of the rope", "m", 1.0, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("k", "contact constant", "N/m^1.5", 1e8, above=0.0),
)


def play(settings: Settings, tolerance: float) -> Run:
    """Speed before the hit, velocities (sphere, block) after it, and the height the pendulum then reaches.

    The work of weight along the arc gives the speed; the hit is a contact on a line, and what it neglects is the swing of the
    rope while it lasts: an angle v T / L.
    """
    run = found(lambda: _evaluated(*balls(settings, "m", "M", "L", "g", "k")))
    length, g = numbers(settings, "L", "g")
    if not {"speed_before", "duration", "velocities", "height"} <= run.measured.keys():
        raise OverflowError
    before, lasts = (components(run.measured[name].value)[0] for name in ("speed_before", "duration"))
    # The rope carries the weight on a circle, m (g + v^2/L), and leans by the angle swung: over the contact it takes at most
    # (g + v^2/L) swung T from the sphere's velocity and from the block's at most twice that. The height goes with the velocity squared:
    # of a sphere that all but stops nearly nothing is left to compare with.
    neglected = 2.0 * (g + before**2 / length) * lasts * lasts / length
    errors = {name: neglected + each.relative_error for name, each in run.measured.items()}
    hit = run.measured["velocities"]
    sphere, slower = abs(components(hit.value)[0]), neglected * before
    risen = (before * lasts) ** 2 / (2.0 * length)  # while they touch
    off = slower * (2.0 * sphere + slower) / (2.0 * g) + risen
    scales = {"velocities": before, "height": max(components(run.measured["height"].value)[0], off)}
    errors["height"] = run.measured["height"].relative_error + (off / scales["height"] if off else 0.0)
    swung = by_relative_errors(run.observed, errors, hit.model, hit.why, 0, run.outcome, scales)
    return replace(swung, measured=swung.measured | {"speed_before": run.measured["speed_before"]})


def _evaluated(m: Ball, block: Ball, length: Ball, g: Ball, k: Ball) -> Evaluated:
    speed = (2 * g * length).sqrt()
    mass = 1 / (1 / m + 1 / block)
    hit = undamped(mass, k, Ball(1.5), speed)
    sphere = speed * (m - block) / (m + block)
    values: dict[str, Balls] = {
        "speed_before": speed,
        "velocities": (sphere, 2 * m / (m + block) * speed),
        "height": sphere**2 / (2 * g),
    }
    if hit.duration is not None:
        values["duration"] = hit.duration
    by: dict[str, tuple[Model, str]] = {
        "speed_before": ("conservation", "from the horizontal to the bottom weight does the work m g L")
    }
    return Evaluated("released", values, "quadrature", BETA, by)


def second_way(settings: Settings, tolerance: float) -> Run:
    """Down along the arc, a hit during which the rope swings on, and up to where the sphere turns."""
    m, block, length, g, k = numbers(settings, "m", "M", "L", "g", "k")
    allowed = two_runs(tolerance, LONG_STEPS)
    stiff = k / m * length * math.sqrt(length) / g
    rough, right = (_hit(m / block, stiff, each) for each in allowed)
    off = SAFE * max(abs(a - b) for a, b in zip(rough, right, strict=True)) + LAST_STEPS * allowed[1] + EXACT
    before, sphere, pushed, top, span = right
    fast = math.sqrt(g * length)
    observed: dict[str, Observed] = {
        "speed_before": fast * before,
        "velocities": (fast * sphere, fast * pushed),
        "height": 2.0 * length * math.sin(0.5 * top) ** 2,
        "duration": span * _softness(m / block, stiff, before) / before * math.sqrt(length / g),
    }
    # The height goes with the square of the angle, and a duration that is short in the units of the swing is known as well.
    errors = dict.fromkeys(observed, off) | {"height": (abs(math.sin(top)) + off) * off}
    scales = {"speed_before": fast, "velocities": fast, "height": length}
    return by_relative_errors(observed, errors, "integration", STEPS, 0, "released", scales)


def _softness(share: float, stiff: float, speed: float) -> float:
    """About how far the contact gives, as a part of the rope: the unit in which the hit is followed."""
    return (speed * speed / (1.0 + share) / stiff) ** 0.4


def _hit(share: float, stiff: float, tolerance: float) -> tuple[float, float, float, float, float]:
    """Of a sphere let go level that meets a block 1/`share` as heavy: speed before, velocities after, angle of the turn, time of touch.

    In units of the rope, the sphere and its weight; the time in those of the contact. The push goes level, along the table.
    """
    _, before = swung(-0.5 * math.pi, 0.0, tolerance, turns=False)
    deep = _softness(share, stiff, before)
    slow, hard = deep / before**2, stiff * deep**2.5 / before**2

    def slope(_: float, state: Sequence[float]) -> list[float]:
        overlap, angle, along, pushed = state
        c, push = math.cos(deep * angle), hard * max(overlap, 0.0) ** 1.5
        return [along * c - pushed, along, -slow * math.sin(deep * angle) - push * c, share * push]

    span, (_, angle, along, pushed) = until(slope, (0.0, 0.0, 1.0, 0.0), lambda y: y[0], tolerance)
    top, _ = swung(deep * angle, before * along, tolerance)
    return before, before * along, before * pushed, top, span


def filmed(settings: Settings) -> Film:
    m, block, length, g, k = numbers(settings, "m", "M", "L", "g", "k")
    radius = 0.08 * length
    bodies = (
        Body(math.inf, (0.0, 0.0), (0.0, 0.0), name=NAIL),
        Body(m, (-length, 0.0), (0.0, 0.0), 0.9 * radius, "A"),
        Body(block, (1.9 * radius, -length), (0.0, 0.0), radius, "B"),
    )
    floor = HardWall((0.0, 1.0), -length - radius, restitution=0.0, only=(2,))
    forces = Rod((0, 1)), Weight(g), Contact(k, chosen=((1, 2),)), floor
    edge = 2.0 * length
    ground = ((-edge, -length - radius), (edge, -length - radius))
    swing = QUARTER * math.sqrt(length / g)
    return film(bodies, [(forces, 1.7 * swing)], lines=(ground,), ropes=((0, 1),))


SCENE = SceneDefinition(
    "a pendulum hits a block at the bottom of its path", SETTINGS, play, second_way=second_way, film=filmed
)
