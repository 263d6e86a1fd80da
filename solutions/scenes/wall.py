"""A ball reflected from a stiff smooth wall that it meets at an angle (exercise 12.7)."""

from __future__ import annotations

import math

from second_way import second_run

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.film import Film, film
from corollary.scenes.forces.contact import Contact
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.line_collision import collide
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.row import RowOfBodies
from corollary.scenes.run import Observed, Run
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("m", "mass of the ball", "kg", 0.2, above=0.0),
    Setting("v0", "speed of the ball", "m/s", 8.0, above=0.0),
    Setting(
        "theta",
        "angle between the velocity and the wall's surface",
        "rad",
        math.pi / 6.0,
        above=0.0,
        most=0.5 * math.pi,
    ),
    Setting("dt", "time of contact", "s", 0.01, above=0.0),
)


def _evaluated(m: Ball, v0: Ball, theta: Ball, dt: Ball) -> Evaluated:
    """Vectors are (along the wall, away from the wall). The wall has no friction and gives like a spring.

    A spring's contact lasts half its period whatever the speed, so k = m (pi/dt)^2, and its motion is half a swing.
    """
    along, into = v0 * theta.cos(), v0 * theta.sin()
    change = 2 * m * into
    values = {
        "velocities": (along, into),
        "momentum_change": (Ball(0), change),
        "impulse": (Ball(0), -change),
        "mean_force": (Ball(0), change / dt),
        "peak_force": m * into * Ball.pi() / dt,
        "largest_overlap": into * dt / Ball.pi(),
        "duration": dt,
        "energy_ratio": Ball(1),
    }
    why = "a smooth wall that gives like a spring: the motion into it is half a swing, known exactly"
    return Evaluated("released", values, "piecewise exact", why)


def second_way(settings: Settings, tolerance: float) -> Run:
    m, v0, theta, dt = numbers(settings, "m", "v0", "theta", "dt")
    along, into = v0 * math.cos(theta), v0 * math.sin(theta)
    line = RowOfBodies((math.inf, m), (0.0, -into), (0.0,), (Contact(m * (math.pi / dt) ** 2, 1.0),))
    found = collide(line, tolerance)
    change = m * (found.result.velocities[1] + into)
    observed: dict[str, Observed] = {
        "velocities": (along, found.result.velocities[1]),
        "momentum_change": (0.0, change),
        "impulse": (0.0, -change),
        "mean_force": (0.0, change / found.result.duration),
        "duration": found.result.duration,
    }
    return second_run(observed, max(found.errors.values()), found.why, found.model)


def filmed(settings: Settings) -> Film:
    m, v0, theta, dt = numbers(settings, "m", "v0", "theta", "dt")
    k, free, radius = m * (math.pi / dt) ** 2, 4.0 * dt, 0.3 * v0 * dt
    along, into = v0 * math.cos(theta), v0 * math.sin(theta)
    spring = ForceFunction(0, lambda t, x, v: (0.0, -k * x[1]))
    ball = Body(m, (-along * free, into * free), (along, -into), name="A")
    edge = 1.5 * (along * free + radius)
    floor = ((-edge, -radius), (edge, -radius))
    return film((ball,), [((), free), ((spring,), dt), ((), free)], radii=(radius,), lines=(floor,))


SCENE = by_formulas(
    "a ball reflected from a stiff smooth wall at an angle",
    SETTINGS,
    _evaluated,
    second_way=second_way,
    film=filmed,
)
