"""Pulled by a hanging block: friction on the one, weight on the other."""

from corollary.author import simulate
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.contact import Friction
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(M, m, mu, g, answer):
    """The string laid out in a line, for a second: a rod from the block that rubs to the one that its weight pulls; and that one alone."""
    a = answer["a"]
    blocks = (Body(M, (0.0,), (0.0,)), Body(m, (1.0,), (0.0,)))
    pulled = (Rod((0, 1)), Friction(0, mu, g), ForceFunction(1, lambda t, x, v: (m * g,)))
    net = ForceFunction(0, lambda t, x, v: (m * g - answer["b"],))
    return [
        simulate(Scene(blocks, pulled, until=1.0), velocities=(a, a), trajectory=(a / 2, 1.0 + a / 2)),
        simulate(Scene((Body(m, (0.0,), (0.0,)),), (net,), until=1.0), velocities=(a,)),
    ]
