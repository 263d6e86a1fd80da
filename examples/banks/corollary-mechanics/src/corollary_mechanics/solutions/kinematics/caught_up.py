"""Caught up: equal ways are one moment, equal speeds another."""

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(v, a, answer):
    """The cyclist glides; a steady force pulls the car."""
    cyclist, car = Body(1.0, (0.0,), (v,)), Body(1.0, (0.0,), (0.0,))
    pull = ForceFunction(1, lambda t, x, u: (a,))
    meeting = Scene((cyclist, car), (pull,), until=answer["a"])
    widest = Scene((cyclist, car), (pull,), until=answer["a"] / 2)
    return [
        simulate(meeting, trajectory=(answer["b"], answer["b"])),
        simulate(widest, trajectory=(answer["b"] / 2, answer["b"] / 2 - answer["c"]), velocities=(v, v)),
    ]
