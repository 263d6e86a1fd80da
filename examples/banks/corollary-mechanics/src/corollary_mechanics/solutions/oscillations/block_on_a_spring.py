"""Pulled and let go: period, and energy to and fro."""

from math import pi, sqrt

from corollary.author import simulate
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.scene import Body, Scene


def scene(m, k, A, answer):
    """A spring between a nail and a body: a quarter of a period, and a sixth, when the cosine is one half."""
    nail, glider = Body(float("inf"), (0.0,), (0.0,)), Body(m, (1.0 + A,), (0.0,))
    quarter = Scene((nail, glider), (Spring((0, 1), k, length=1.0),), until=answer["a"] / 4)
    sixth = Scene((nail, glider), (Spring((0, 1), k, length=1.0),), until=pi / 3 * sqrt(m / k))
    return [
        simulate(quarter, trajectory=(0.0, 1.0), velocities=(0.0, -answer["b"])),
        simulate(sixth, trajectory=(0.0, 1.0 + A / 2), velocities=(0.0, -answer["c"])),
    ]
