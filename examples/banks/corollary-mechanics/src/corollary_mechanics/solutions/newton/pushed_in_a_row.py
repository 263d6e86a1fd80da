"""Two crates, one push: what stands between must move the other crate only."""

from corollary.author import simulate
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(m, M, F, answer):
    """Each crate with the forces on it alone: both must stay together for a second."""

    def together(rear, front):
        pushes = (ForceFunction(0, lambda t, x, v: (rear,)), ForceFunction(1, lambda t, x, v: (front,)))
        return Scene((Body(m, (0.0,), (0.0,)), Body(M, (1.0,), (0.0,))), pushes, until=1.0)

    a = answer["a"]
    return [
        simulate(together(F - answer["b"], answer["b"]), velocities=(a, a)),
        simulate(together(-answer["c"], answer["c"] - F), velocities=(-a, -a)),
    ]
