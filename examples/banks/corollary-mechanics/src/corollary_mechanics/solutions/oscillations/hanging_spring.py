"""A weight on a hanging spring: the weight moves the equilibrium, and nothing else."""

from corollary.author import simulate
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(m, d, b, g, answer):
    """A spring on a nail, and weight: half a period later the block is as far above the place of rest."""
    nail, block = Body(float("inf"), (0.0,), (0.0,)), Body(m, (-1.0 - d - b,), (0.0,))
    half = Scene((nail, block), (Spring((0, 1), answer["a"], length=1.0), Weight(g)), until=answer["b"] / 2)
    return [simulate(half, trajectory=(0.0, -1.0 - d + b))]
