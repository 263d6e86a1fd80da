"""Round a bend: what turns the velocity must come from the road."""

from math import hypot, pi

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(m, r, v, mu, g, answer):
    """The car from above, for a quarter of a turn: at its speed with the friction it needs, and at the highest one with all there is."""
    runs = []
    for force, speed in ((answer["a"], v), (mu * m * g, answer["b"])):
        inwards = ForceFunction(0, lambda t, x, v, F=force: (-F * x[0] / hypot(*x), -F * x[1] / hypot(*x)))
        quarter = Scene((Body(m, (r, 0.0), (0.0, speed)),), (inwards,), until=pi * r / (2 * speed))
        runs.append(simulate(quarter, trajectory=(0.0, r), velocities=(-speed, 0.0)))
    return runs
