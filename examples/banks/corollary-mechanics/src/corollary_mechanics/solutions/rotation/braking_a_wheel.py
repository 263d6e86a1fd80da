"""A grindstone: friction at the rim slows a disc down."""

from corollary.author import simulate
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(M, R, n, N, mu, answer):
    """A disc that turns in a corner, pressed on the rough side, and held by the smooth one: after half of the time it has half of
    its spin and a quarter of its energy; and all that friction does in that time is torque times time."""
    corner = (
        HardWall((0.0, 1.0), restitution=0.0, mu=mu),
        HardWall((1.0, 0.0), restitution=0.0),
        ForceFunction(0, lambda t, place, velocity: (0.0, -N)),
    )
    disc = Body(M, (R, R), (0.0, 0.0), radius=R, spin=n, inertia=M * R**2 / 2)
    half = Scene((disc,), corner, until=answer["b"] / 2)
    spin = n - answer["a"] / (M * R**2 / 2) * answer["b"] / 2
    return [
        simulate(half, spins=(n / 2,), energy=answer["c"] / 4),
        simulate(half, spins=(spin,)),
    ]
