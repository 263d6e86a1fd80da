"""A bobbing float: what the water pushes more drives it back, like a spring."""

from math import pi, sqrt

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(d, m, A, rho, g, answer):
    """Water that is pushed aside pushes back; a quarter of a period, from where the float is let go to where it rests."""
    depth, period = answer["a"], answer["c"]
    net = ForceFunction(0, lambda t, x, v: (m * g - rho * g * pi * d**2 / 4 * (depth + x[0]),))
    let_go = Scene((Body(m, (A,), (0.0,)),), (net,), until=period / 4)
    fastest = sqrt(
        answer["b"] * A / m
    )  # the force falls evenly to zero, so its work is half of force times way
    return [simulate(let_go, trajectory=(0.0,), velocities=(-fastest,))]
