"""Throwing and catching a snowball while standing on ice: short forces between the two, nothing from outside along the ice."""

from __future__ import annotations

import math

from second_way import second_run, state_after

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.film import Act, Film, film
from corollary.scenes.forces.bonds import FADING, catching
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.models.certain import Evaluated, by_formulas
from corollary.scenes.run import (
    Observed,
    Run,
)
from corollary.scenes.scene import Body

SETTINGS = (
    Setting("M", "your mass", "kg", 80.0, above=0.0),
    Setting("Ms", "your son's mass", "kg", 20.0, above=0.0),
    Setting("m", "mass of the snowball", "kg", 2.0, above=0.0),
    Setting("v", "speed of the snowball over the ice", "m/s", 20.0, above=0.0),
    Setting(
        "theta",
        "angle of the throw above the horizontal",
        "rad",
        math.pi / 6.0,
        least=0.0,
        below=0.5 * math.pi,
    ),
    Setting("dt", "time the throw takes, and the catch at most", "s", 0.1, above=0.0),
)


def _evaluated(you: Ball, son: Ball, ball: Ball, v: Ball, theta: Ball, dt: Ball) -> Evaluated:
    """Velocities along the ice, toward the son. `velocities_after_throw` and `velocities` are (yours, your son's).

    Thrown by a constant force between hand and ball (each feels it, oppositely), of size m v/dt: nothing weighs. Caught by a dashpot
    along the ice between ball and son, and then held fast. The ice carries what either does vertically.
    """
    level, up = v * theta.cos(), v * theta.sin()
    yours, both = -ball * level / you, ball + son
    values = {
        "momentum": (ball * level, ball * up),
        "velocities_after_throw": (yours, Ball(0)),
        "velocities": (yours, ball * level / both),
        "peak_force": (ball * v / dt).max(FADING * ball * son / both * level / dt),
    }
    why = "a constant force and a dashpot, one after the other: each moves the bodies in closed form"
    return Evaluated("sticks", values, "piecewise exact", why)


def second_way(settings: Settings, tolerance: float) -> Run:
    you, son, ball, v, theta, dt = numbers(settings, "M", "Ms", "m", "v", "theta", "dt")
    along, up = ball * v * math.cos(theta) / dt, ball * v * math.sin(theta) / dt
    # The ice carries what the throw does to you vertically.
    forces = (
        ForceFunction(0, lambda t, x, w: (along, up), smooth=True),
        ForceFunction(1, lambda t, x, w: (-along, 0.0), smooth=True),
    )
    thrower = Body(ball, (1.0, 0.0), (0.0, 0.0)), Body(you, (0.0, 0.0), (0.0, 0.0))
    (level, rising, yours, _), _, error = state_after(thrower, forces, dt, tolerance)
    a, b = Body(ball, (0.0,), (level,)), Body(son, (10.0 * v * dt + 1.0,), (0.0,))
    grip = catching(ball, son, dt)
    (_, sons), _, more = state_after((a, b), (grip,), dt, tolerance)
    observed: dict[str, Observed] = {
        "momentum": (ball * level, ball * rising),
        "velocities_after_throw": (yours, 0.0),
        "velocities": (yours, sons),
        "peak_force": max(math.hypot(ball * level, ball * rising) / dt, grip.damping * level),
    }
    fastest = max(abs(level), abs(rising), abs(yours))
    scales = {"velocities_after_throw": fastest, "velocities": fastest, "peak_force": grip.damping * fastest}
    return second_run(observed, max(error, more), scales=scales)


def filmed(settings: Settings) -> Film:
    you, son, ball, v, theta, dt = numbers(settings, "M", "Ms", "m", "v", "theta", "dt")
    level = v * math.cos(theta)
    push = ball * level / dt
    way = 10.0 * level * dt
    bodies = (
        Body(ball, (0.0,), (0.0,), name="C"),
        Body(son, (way,), (0.0,), name="B"),
        Body(you, (-0.06 * way,), (0.0,), name="A"),
    )
    thrown = ForceFunction(0, lambda t, x, w: (push,)), ForceFunction(2, lambda t, x, w: (-push,))
    flight = 0.92 * way / level
    catch = (catching(ball, son, dt),)
    acts: list[Act] = [((), dt), (thrown, dt), ((), flight), (catch, dt), ((), flight)]
    return film(bodies, acts, radii=(0.02 * way, 0.05 * way, 0.06 * way))


SCENE = by_formulas(
    "a snowball thrown and caught on ice", SETTINGS, _evaluated, second_way=second_way, film=filmed
)
