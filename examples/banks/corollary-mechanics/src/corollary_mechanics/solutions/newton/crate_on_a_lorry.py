"""A crate on a lorry: static friction is as large as it must be, up to a limit."""

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(m, v, a, mu, g, answer):
    """The crate with friction alone: for two seconds forward, and from v to rest in the way found."""
    start = Scene((Body(m, (0.0,), (0.0,)),), (ForceFunction(0, lambda t, x, u: (answer["a"],)),), until=2.0)
    braking = Scene(
        (Body(m, (0.0,), (v,)),), (ForceFunction(0, lambda t, x, u: (-mu * m * g,)),), until=v / (mu * g)
    )
    return [simulate(start, velocities=(2 * a,)), simulate(braking, trajectory=(answer["c"],))]
