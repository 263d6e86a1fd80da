"""A swing that dies away: exponential decay of amplitude and of energy."""

from math import pi

from corollary.author import module, simulate
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.flows import Drag
from corollary.scenes.scene import Body, Scene

SWING = module("damped_swing/judge_swing.py")


def scene(A, B, T, m, answer):
    """A spring with the stiffness that gives the period, and the drag found: at the end of ten periods it turns B away."""
    k = m * ((2 * pi / T) ** 2 + answer["a"] ** 2)
    nail, block = Body(float("inf"), (0.0,), (0.0,)), Body(m, (1.0 + A,), (0.0,))
    swung = Scene((nail, block), (Spring((0, 1), k, length=1.0), Drag(1, linear=answer["b"])), until=10 * T)
    return [simulate(swung, trajectory=(0.0, 1.0 + B))]
