"""A pulled sledge: a rope that also lifts."""

from math import cos, sin

from corollary.author import simulate
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def scene(m, F, theta, mu, g, answer):
    """A body on a rough floor, pulled for two seconds."""
    rope = ForceFunction(0, lambda t, x, v: (F * cos(theta), F * sin(theta)))
    ground = HardWall((0.0, 1.0), restitution=0.0, mu=mu)
    pulled = Scene((Body(m, (0.0, 0.0), (0.0, 0.0)),), (Weight(g), rope, ground), until=2.0)
    return [simulate(pulled, velocities=(2 * answer["c"], 0.0), trajectory=(2 * answer["c"], 0.0))]
