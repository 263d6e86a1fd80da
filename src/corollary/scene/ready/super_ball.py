"""A small ball on top of a large one, dropped together: the floor turns the lower one round, it throws the upper (12.5.2)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scene.collision import collide
from corollary.scene.force.contact import Contact
from corollary.scene.line import Line
from corollary.scene.ready.scenery import Played, Ready
from corollary.scene.ready.setting import Setting, one
from corollary.scene.run import Observed

SETTINGS = (
    Setting("mA", "mass of the lower ball", "kg", 0.6, above=0.0),
    Setting("mB", "mass of the upper ball", "kg", 0.06, above=0.0),
    Setting("h0", "drop height", "m", 1.0, above=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("k", "contact constant of floor and balls", "N/m^q", 1e12, above=0.0),
    Setting("q", "exponent of the contact force", "1", 1.5, least=1.0, most=10.0),
    Setting("gap", "gap between the balls as they fall", "m", 0.001, least=0.0),
)


def play(settings: Mapping[str, Observed], tolerance: float) -> Played:
    """Velocities (lower, upper; up positive) after the last opening, and the height to which the upper ball then rises.

    With a gap the lower ball leaves the floor before they meet, as the example supposes; without one all three touch at once and
    the answer is another. Weight during the contacts is left out; `heights` is counted from the balls' places at the contact.
    """
    ma, mb, h0, g, k, q, gap = (one(settings, name) for name in ("mA", "mB", "h0", "g", "k", "q", "gap"))
    speed = math.sqrt(2.0 * g * h0)
    line = Line((math.inf, ma, mb), (0.0, -speed, -speed), (0.0, gap), (Contact(k, q), Contact(k, q)))
    found = collide(line, tolerance)
    _, lower, upper = found.passage.velocities
    observed: dict[str, Observed] = {
        "velocities": (lower, upper),
        "heights": (max(lower, 0.0) ** 2 / (2.0 * g), max(upper, 0.0) ** 2 / (2.0 * g)),
        "duration": found.passage.duration,
        "peak_force": max(found.passage.forces),
    }
    # Weight takes g times the time of contact from every speed: that is what leaving it out neglects.
    neglected = g * found.passage.duration / speed
    errors = dict.fromkeys(observed, found.errors["velocities"] + neglected)
    errors["duration"], errors["peak_force"] = found.errors["duration"] + neglected, found.errors["forces"] + 2.0 * neglected
    return Played(observed, errors, found.model, found.why, found.spent, found.passage.outcome)


SUPER_BALL = Ready("super_ball", "a small ball on a large one, dropped together", SETTINGS, play)
