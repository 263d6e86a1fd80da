"""A box that is pushed off: work in, heat out."""

from math import sqrt

from corollary.author import simulate
from corollary.scenes.forces.contact import Friction
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(m, F, s, mu, g, answer):
    a, v = F / m - mu * g, sqrt(2 * answer["a"] / m)
    box, rough = Body(m, (0.0,), (0.0,)), Friction(0, mu, g)
    pushed = Scene((box,), (rough, ForceFunction(0, lambda t, x, u: (F,))), until=v / a)
    sliding = Scene((Body(m, (s,), (v,)),), (rough,), until=2 * v / (mu * g))
    return [
        simulate(pushed, trajectory=(s,), velocities=(v,)),
        simulate(sliding, trajectory=(s + answer["b"],)),
    ]
