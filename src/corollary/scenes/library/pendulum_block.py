"""A pendulum let go from the horizontal hits a block at the bottom of its path, elastically (exercise 12.12)."""

from __future__ import annotations

from dataclasses import replace

from corollary.formula.ball import Ball
from corollary.scenes.definition import SceneDefinition, Setting, Settings, numbers
from corollary.scenes.models.certain import Balls, Evaluated, balls, found
from corollary.scenes.models.two_bodies import BETA, undamped
from corollary.scenes.run import Model, Run, by_relative_errors, components

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


SCENE = SceneDefinition("a pendulum hits a block at the bottom of its path", SETTINGS, play)
