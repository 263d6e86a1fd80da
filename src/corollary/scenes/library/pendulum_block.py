"""A pendulum let go from the horizontal hits a block at the bottom of its path, elastically (exercise 12.12)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING, collide
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.forces.contact import Contact
from corollary.scenes.models.gauss import integral
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import Observed, Run

SETTINGS = (
    Setting("m", "mass of the sphere", "kg", 1.0, above=0.0),
    Setting("M", "mass of the block", "kg", 2.0, above=0.0),
    Setting("L", "length of the rope", "m", 1.0, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("k", "contact constant", "N/m^1.5", 1e8, above=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Speed before the hit, velocities (sphere, block) after it, and the height the pendulum then reaches.

    The work of weight along the arc gives the speed; the hit is a contact on a line, and what it neglects is the swing of the
    rope while it lasts: an angle v T / L.
    """
    m, block, length, g, k = (one(settings, name) for name in ("m", "M", "L", "g", "k"))
    work, error_estimate, spent = integral(lambda angle: m * g * length * math.cos(angle), 0.0, 0.5 * math.pi)
    speed = math.sqrt(2.0 * work / m)
    found = collide(RowOfBodies((m, block), (speed, 0.0), (0.0,), (Contact(k, 1.5),)), tolerance)
    sphere, pushed = found.result.velocities
    swung = speed * found.result.duration / length
    observed: dict[str, Observed] = {
        "speed_before": speed,
        "velocities": (sphere, pushed),
        "height": sphere * sphere / (2.0 * g),
        "duration": found.result.duration,
    }
    # The rope carries the weight on a circle, m (g + v^2/L), and leans by the angle swung: over the contact it takes at most
    # (g + v^2/L) swung T from the sphere's velocity, from the block's at most twice that, and from the height at most twice its share.
    neglected = 2.0 * (g + speed**2 / length) * swung * found.result.duration / speed
    errors = dict.fromkeys(observed, error_estimate + ROUNDING + neglected) | {
        "speed_before": error_estimate + ROUNDING
    }
    return Run(observed, errors, found.model, found.why, spent + found.spent, "released")


SCENE = SceneDefinition("a pendulum hits a block at the bottom of its path", SETTINGS, play)
