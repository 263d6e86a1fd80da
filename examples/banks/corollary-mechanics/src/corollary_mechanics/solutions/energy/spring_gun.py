"""A spring gun: energy of the spring, of motion, of height."""

from math import sqrt

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def scene(m, k, x, g, answer):
    """The spring pushes while it is shorter than it is at rest; when it has its length again follows from the oscillation."""
    from math import acos, pi

    w = sqrt(k / m)
    lower = m * g / k
    t = acos(-lower / (x - lower)) / w if x > lower else pi
    push = ForceFunction(0, lambda at, y, u: (-k * (y[0] - x),))
    ball = Body(m, (0.0,), (0.0,))
    leaving = Scene((ball,), (Weight(g), push), until=t)
    top = Scene((Body(m, (x,), (answer["b"],)),), (Weight(g),), until=answer["b"] / g)
    return [
        simulate(leaving, velocities=(answer["b"],), trajectory=(x,)),
        simulate(top, trajectory=(answer["c"],)),
    ]
