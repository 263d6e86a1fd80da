"""A falling pole: the centre falls, the whole pole turns."""

from math import pi

from scipy.special import ellipkinc

from corollary.author import simulate
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(L, M, g, answer):
    """A pendulum that swings as the pole does: three quarters of its mass at two thirds of its length, on a rod without mass.

    It is pushed over with a thousandth of the last angular velocity, for upright it would stay. When it lies flat is an elliptic
    integral; that it does then, and how fast it is, is Newton's second law.
    """
    arm, last = 2 * L / 3, answer["b"]
    push = last / 1000
    falls = 2 / push * ellipkinc(pi / 4, -6 * g / L / push**2)
    nail, weight = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(3 * M / 4, (0.0, arm), (push * arm, 0.0))
    return [
        simulate(
            Scene((nail, weight), (Rod((0, 1)), Weight(g)), until=float(falls)),
            trajectory=(0.0, 0.0, arm, 0.0),
            velocities=(0.0, 0.0, 0.0, -2 * answer["c"] / 3),
            energy=answer["a"],
            neglected=2e-6,
        )
    ]
