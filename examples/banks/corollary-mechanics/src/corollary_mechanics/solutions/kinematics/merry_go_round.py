"""A merry-go-round: steady speed, and yet an acceleration."""

from corollary.author import simulate
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.scene import Body, Scene


def scene(n, r, answer):
    """A body on a rod, without gravity: after a quarter of a turn it is where it should be."""
    nail, child = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(30.0, (r, 0.0), (0.0, answer["b"]))
    quarter = Scene((nail, child), (Rod((0, 1)),), until=answer["a"] / 4)
    return [simulate(quarter, trajectory=(0.0, 0.0, 0.0, r))]
