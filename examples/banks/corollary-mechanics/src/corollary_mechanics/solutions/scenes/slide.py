"""A block released on an incline slides down, smooth or rough, or stays."""

from __future__ import annotations

import math

from corollary.formula.ball import Ball
from corollary.scenes.definition import Setting, Settings, numbers
from corollary.scenes.film import Film, film
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.models.certain import Evaluated, by_formulas, sign
from corollary.scenes.plan import followed
from corollary.scenes.run import Run
from corollary.scenes.scene import Body, Scene

SETTINGS = (
    Setting("m", "mass of the block", "kg", 1.0, above=0.0),
    Setting("theta", "angle of the incline", "rad", 0.5, above=0.0, below=math.pi / 2),
    Setting("mu", "coefficient of friction", "1", 0.2, least=0.0),
    Setting("g", "acceleration of gravity", "m/s^2", 9.8, above=0.0),
    Setting("t", "time for which it is watched", "s", 1.0, above=0.0),
)


def evaluated(_: Ball, theta: Ball, mu: Ball, g: Ball, t: Ball) -> Evaluated:
    """Velocity (across, up) after the time t, and the place then, seen from where the block is released."""
    pull = theta.sin() - mu * theta.cos()
    moves = sign(pull) > 0
    speed = g * pull * t if moves else Ball(0)
    level, up = theta.cos(), -theta.sin()
    values = {
        "velocities": (speed * level, speed * up),
        "trajectory": (speed * t / 2 * level, speed * t / 2 * up),
    }
    why = "constant forces: the acceleration is g (sin(theta) - mu cos(theta)), or friction holds the block"
    return Evaluated("released" if moves else "sticks", values, "piecewise exact", why)


def scene_of(settings: Settings) -> Scene:
    m, theta, mu, g, t = numbers(settings, "m", "theta", "mu", "g", "t")
    incline = HardWall((math.sin(theta), math.cos(theta)), restitution=0.0, mu=mu)
    block = Body(m, (0.0, 0.0), (0.0, 0.0), name="A")
    return Scene((block,), (Weight(g), incline), until=t, name="slide")


def second_way(settings: Settings, tolerance: float) -> Run:
    """Newton's second law step by step, the normal force and friction as the incline gives them."""
    return followed(scene_of(settings), ("velocities", "trajectory"), tolerance)


def filmed(settings: Settings) -> Film:
    scene = scene_of(settings)
    theta, g, t = numbers(settings, "theta", "g", "t")
    way = g * t * t
    ground = ((-0.1 * way, 0.1 * way * math.tan(theta)), (way * math.cos(theta), -way * math.sin(theta)))
    return film(scene.bodies, [(scene.forces, t)], radii=(0.02 * way,), lines=(ground,))


SCENE = by_formulas("a block slides down an incline", SETTINGS, evaluated, second_way, filmed)
