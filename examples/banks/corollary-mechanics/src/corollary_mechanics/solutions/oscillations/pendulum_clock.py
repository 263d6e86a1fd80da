"""A pendulum on another planet: small swings measure gravity."""

from math import pi, sin

from corollary.author import simulate
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(L, n, t, tick, g, answer):
    """A pendulum on a rod, let go a thousandth of a radian aside: half a period later it is on the other side."""
    small = 1e-3
    nail = Body(float("inf"), (0.0, 0.0), (0.0, 0.0))
    bob = Body(0.1, (L * sin(small), -L * sin(pi / 2 - small)), (0.0, 0.0))
    half = Scene((nail, bob), (Rod((0, 1)), Weight(answer["a"])), until=t / n / 2)
    return [simulate(half, trajectory=(0.0, 0.0, -bob.place[0], bob.place[1]), neglected=small**2)]
