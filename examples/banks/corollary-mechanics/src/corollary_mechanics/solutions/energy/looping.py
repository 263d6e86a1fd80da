"""A looping: energy gives the speed, the circle asks for a force."""

from corollary.author import simulate
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(m, R, h, g, answer):
    """On a rod instead of a rail, from the bottom with the energy of the start: the energy at any moment is that of the top."""
    nail = Body(float("inf"), (0.0, 0.0), (0.0, 0.0))
    car = Body(m, (0.0, R), (answer["a"], 0.0))
    swing = Scene((nail, car), (Rod((0, 1)), Weight(g)), until=R / answer["a"])
    return [simulate(swing, energy=m * g * (h - R))]
