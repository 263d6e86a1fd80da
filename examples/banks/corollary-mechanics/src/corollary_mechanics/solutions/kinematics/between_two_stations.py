"""Between two stations: three motions one after the other."""

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(d, v, a, b, answer):
    """A force that is switched: three scenes, each begun where the last one ended."""
    start = Scene((Body(1.0, (0.0,), (0.0,)),), (ForceFunction(0, lambda t, x, u: (a,)),), until=v / a)
    t = answer["c"] - v / a - v / b
    steady = Scene((Body(1.0, (answer["a"],), (v,)),), (), until=t)
    end = Scene(
        (Body(1.0, (d - answer["b"],), (v,)),), (ForceFunction(0, lambda t, x, u: (-b,)),), until=v / b
    )
    return [
        simulate(start, trajectory=(answer["a"],), velocities=(v,)),
        simulate(steady, trajectory=(d - answer["b"],)),
        simulate(end, trajectory=(d,)),
    ]
