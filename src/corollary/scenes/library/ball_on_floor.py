"""A ball meets a floor that pushes back with k overlap^q, weight included (example 12.3.1)."""

from __future__ import annotations

import math
from collections.abc import Mapping

from corollary.scenes.collision import ROUNDING, collide
from corollary.scenes.definition import SceneDefinition, Setting, one
from corollary.scenes.forces.contact import Contact
from corollary.scenes.models.bounce import bounce, deepest
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import BadSetting, Observed, Run

SETTINGS = (
    Setting("m", "mass of the ball", "kg", 0.1, above=0.0),
    Setting("k", "contact constant", "N/m^q", 1e6, above=0.0),
    Setting("q", "exponent of the contact force", "1", 1.5, least=1.0, most=10.0),
    Setting("R", "radius of the ball", "m", 0.02, above=0.0),
    Setting("y0", "height of the centre at the start", "m", 0.021),
    Setting("v0", "velocity at the start (up positive)", "m/s", -2.8),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, least=0.0),
    Setting("eta", "damping of the contact", "kg/s", 0.0, least=0.0),
)


# From this many times the critical damping on, spring and weight have no say until the ball is at rest: they change its way by the
# inverse square of that number, times its logarithm, times the share of the spring that is met at all.
OVERDAMPED = 1e5


def play(settings: Mapping[str, Observed], tolerance: float) -> Run:
    """Rebound speed and impulse of the floor when the ball leaves y = R; peak force of the floor; duration of the contact."""
    m, k, q, r, y0, v0, g, eta = (
        one(settings, name) for name in ("m", "k", "q", "R", "y0", "v0", "g", "eta")
    )
    if y0 < r:
        raise BadSetting(
            f"ball_on_floor: y0 = {y0:g} m is inside the floor; the centre must start at R = {r:g} m or higher."
        )
    square = v0 * v0 + 2.0 * g * (y0 - r)
    if (v0 >= 0.0 and g == 0.0) or square == 0.0:
        nothing: dict[str, Observed] = dict.fromkeys(
            ("duration", "peak_force", "impulse", "largest_overlap"), 0.0
        )
        nothing["velocities"] = (v0,)
        return Run(
            nothing,
            dict.fromkeys(nothing, 0.0),
            "conservation",
            "the ball never meets the floor",
            0,
            "missed",
        )
    speed = math.sqrt(square)
    if eta > 0.0:
        return _damped(m, Contact(k, q, eta), speed, g, tolerance)
    found = bounce(Contact(k, q), m, speed, g)
    observed: dict[str, Observed] = {
        "velocities": (speed,),
        "duration": found.duration,
        "peak_force": found.force,
        "impulse": 2.0 * m * speed + m * g * found.duration,
        "largest_overlap": found.overlap,
        "rebound_speed": speed,
        "energy_ratio": 1.0,
    }
    errors = dict.fromkeys(observed, ROUNDING) | {"duration": max(found.error_estimate, ROUNDING)}
    why = "one body, no damping: energy gives the rebound and the deepest point, an integral over the energy the duration"
    return Run(observed, errors, "quadrature", why, found.evaluations, "released")


def _damped(m: float, contact: Contact, speed: float, g: float, tolerance: float) -> Run:
    deep = deepest(contact, m, speed, g)
    thick = contact.eta / math.sqrt(contact.k * m * deep ** (contact.q - 1.0))
    if thick > OVERDAMPED and (contact.q > 1.0 or g > 0.0):
        change = 4.0 * math.log(thick) / thick**2 * (m * speed / contact.eta / deep) ** (contact.q - 1.0)
        return _overdamped(m, contact, speed, g, change)
    line = RowOfBodies((math.inf, m), (0.0, -speed), (0.0,), (contact,), weight=g)
    found = collide(line, tolerance)
    result, errors = found.result, found.errors
    rebound = result.velocities[1]
    observed: dict[str, Observed] = {
        "velocities": (rebound,),
        "duration": result.duration,
        "peak_force": result.forces[0],
        "impulse": m * (rebound + speed) + (m * g * result.duration if g else 0.0),
        "largest_overlap": result.overlaps[0],
        "rebound_speed": rebound,
        "energy_ratio": (rebound / speed) ** 2,
    }
    of = {"duration": "duration", "peak_force": "forces", "largest_overlap": "overlaps"}
    sizes = {
        name: errors[of.get(name, "velocities")] * (2.0 if name == "energy_ratio" else 1.0)
        for name in observed
    }
    return Run(observed, sizes, found.model, found.why, found.spent, result.outcome)


def _overdamped(m: float, contact: Contact, speed: float, g: float, change: float) -> Run:
    """So much damping that it alone stops the ball, in the way m v/eta; weight then lets it sink to where the floor carries it.

    Critical damping already keeps it down for ever. It pushes hardest when it begins, and sinks to its resting place without ever
    passing it. `change` is what spring and weight can change of the way to its stop, as a part of it.
    """
    rest = (m * g / contact.k) ** (1.0 / contact.q)
    stopped = m * speed / contact.eta
    observed: dict[str, Observed] = {
        "velocities": (0.0,),
        "duration": math.inf,
        "peak_force": max(contact.eta * speed, m * g),
        "impulse": math.inf if g else m * speed,
        "largest_overlap": max(rest, stopped),
        "rebound_speed": 0.0,
        "energy_ratio": 0.0,
    }
    errors = dict.fromkeys(observed, ROUNDING)
    if stopped > rest:
        errors["largest_overlap"] = max(ROUNDING, change)
    why = "the damping is so much above the critical one that it alone decides"
    return Run(observed, errors, "conservation", why, 0, "sticks")


SCENE = SceneDefinition("a ball meets the floor: contact force k overlap^q, weight included", SETTINGS, play)
