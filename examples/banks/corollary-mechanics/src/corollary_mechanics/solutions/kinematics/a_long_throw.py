"""A long throw: a free fall upwards and downwards, and a steady motion sideways."""

from math import cos, pi

from corollary.author import simulate
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(v, theta, g, answer):
    start = (v * cos(theta), v * cos(pi / 2 - theta))
    ball = Body(0.2, (0.0, 0.0), start)
    top = Scene((ball,), (Weight(g),), until=answer["b"] / 2)
    caught = Scene((ball,), (Weight(g),), until=answer["b"])
    return [
        simulate(top, trajectory=(answer["c"] / 2, answer["a"]), velocities=(answer["d"], 0.0)),
        simulate(caught, trajectory=(answer["c"], 0.0)),
    ]
