"""Over a pulley: one string, one acceleration, two equations."""

from corollary.author import simulate
from corollary.scenes.forces.bonds import Rod
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(m, M, h, g, answer):
    """The string laid out in a line: a rod between both blocks, each pulled outwards by its weight; and the heavier block alone."""
    v, t = answer["c"], answer["c"] / answer["a"]
    pulls = (ForceFunction(0, lambda t, x, v: (-m * g,)), ForceFunction(1, lambda t, x, v: (M * g,)))
    blocks = (Body(m, (0.0,), (0.0,)), Body(M, (1.0,), (0.0,)))
    net = ForceFunction(0, lambda t, x, v: (M * g - answer["b"],))
    return [
        simulate(Scene(blocks, (Rod((0, 1)), *pulls), until=t), velocities=(v, v), trajectory=(h, 1.0 + h)),
        simulate(Scene((Body(M, (0.0,), (0.0,)),), (net,), until=t), velocities=(v,)),
    ]
