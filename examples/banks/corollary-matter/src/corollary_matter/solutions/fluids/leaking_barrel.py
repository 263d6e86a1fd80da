"""A hole in a barrel: Torricelli, and a horizontal throw."""

from corollary.author import simulate
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(H, y, d, g, answer):
    """A drop of the jet."""
    drop = Body(1e-4, (0.0, y), (answer["a"], 0.0))
    flight = Scene((drop,), (Weight(g),), until=answer["b"] / answer["a"])
    return [simulate(flight, trajectory=(answer["b"], 0.0))]
