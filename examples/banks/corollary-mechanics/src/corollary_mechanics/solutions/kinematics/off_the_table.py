"""Off the table: sideways nothing changes, and downwards it is a free fall."""

from math import tan

from corollary.author import simulate
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(v, h, g, answer):
    flight = Scene((Body(1.0, (0.0, h), (v, 0.0)),), (Weight(g),), until=answer["a"])
    return [simulate(flight, trajectory=(answer["b"], 0.0), velocities=(v, -v * tan(answer["c"])))]
