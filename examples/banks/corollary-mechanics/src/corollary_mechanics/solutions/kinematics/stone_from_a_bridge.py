"""A stone from a bridge: up and down are one motion with one acceleration."""

from corollary.author import simulate
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(v, h, g, answer):
    flight = Scene((Body(1.0, (h,), (v,)),), (Weight(g),), until=answer["b"])
    return [simulate(flight, trajectory=(0.0,), velocities=(-answer["c"],))]
