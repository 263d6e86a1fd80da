"""Scales in a lift: they show the force with which they push, not the weight."""

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def scene(m, a, b, g, answer):
    """Weight and the push found, for a second: the velocity gained is the lift's."""

    def ridden(push, start):
        return Scene(
            (Body(m, (0.0,), (start,)),), (Weight(g), ForceFunction(0, lambda t, x, v: (push,))), until=1.0
        )

    return [
        simulate(ridden(answer["a"], 0.0), velocities=(a,)),
        simulate(ridden(answer["b"], 3.0), velocities=(3.0,)),
        simulate(ridden(answer["c"], 3.0), velocities=(3.0 - b,)),
    ]
