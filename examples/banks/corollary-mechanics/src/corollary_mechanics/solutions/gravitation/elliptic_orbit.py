"""Nearest and furthest: energy and angular momentum, then Kepler."""

from corollary.author import simulate
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def scene(p, v, M, G, answer):
    """Half a revolution under an inverse square."""
    r, u = answer["a"], answer["b"]
    strength = (v**2 - u**2) / 2 / (1 / p - 1 / r)
    star, comet = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(1.0, (p, 0.0), (0.0, v))
    half = Scene((star, comet), (InverseSquare((0, 1), strength),), until=answer["c"] / 2)
    return [simulate(half, trajectory=(0.0, 0.0, -r, 0.0), velocities=(0.0, 0.0, 0.0, -u))]
