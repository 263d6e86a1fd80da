"""Across a river: velocities add as vectors, component by component."""

from math import cos, sin

from corollary.author import simulate
from corollary.scenes.scene import Body, Scene


def scene(w, u, c, answer):
    """Free motion with the velocity over ground."""
    drifting = Scene((Body(1.0, (0.0, 0.0), (c, u)),), (), until=answer["a"])
    beta = answer["c"]
    straight = Scene((Body(1.0, (0.0, 0.0), (c - u * sin(beta), u * cos(beta))),), (), until=answer["d"])
    return [simulate(drifting, trajectory=(answer["b"], w)), simulate(straight, trajectory=(0.0, w))]
