"""A ball on a cone: the string carries and turns at once."""

from math import sin

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(m, L, theta, g, answer):
    """The ball from above, for a quarter of a turn: the tension pulls it towards the axis by the share that the string leans."""
    S, v = answer["a"], answer["b"]
    r = L * sin(theta)
    inwards = ForceFunction(0, lambda t, x, v: (-S * x[0] / L, -S * x[1] / L))
    quarter = Scene((Body(m, (r, 0.0), (0.0, v)),), (inwards,), until=answer["c"] / 4)
    return [simulate(quarter, trajectory=(0.0, r), velocities=(-v, 0.0))]
