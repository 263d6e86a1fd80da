"""Read off a graph: the slope of v(t) is the acceleration, the area below it is the way."""

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(V, t1, t2, t3, answer):
    """A force that is switched: three scenes, each begun where the last one ended."""
    a, b = answer["a"], V / answer["b"]
    reached = V * t1 / 2
    start = Scene((Body(1.0, (0.0,), (0.0,)),), (ForceFunction(0, lambda t, x, u: (a,)),), until=t1)
    steady = Scene((Body(1.0, (reached,), (V,)),), (), until=t2 - t1)
    end = Scene(
        (Body(1.0, (reached + V * (t2 - t1),), (V,)),),
        (ForceFunction(0, lambda t, x, u: (-b,)),),
        until=t3 - t2,
    )
    return [
        simulate(start, trajectory=(reached,), velocities=(V,)),
        simulate(steady, trajectory=(reached + V * (t2 - t1),)),
        simulate(end, trajectory=(answer["c"],)),
    ]
