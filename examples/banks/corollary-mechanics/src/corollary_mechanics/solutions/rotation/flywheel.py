"""A flywheel: constant angular acceleration, moment of inertia, torque."""

from math import pi

from corollary.author import simulate
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction
from corollary.scenes.scene import Body, Scene


def scene(n, t, M, R, answer):
    """A disc that turns in a corner, its rim rubbing with the torque of the bearings, for half of the time; and the way of a
    point of the rim, laid out in a line, until it stands."""
    corner = (
        HardWall((0.0, 1.0), restitution=0.0, mu=1.0),
        HardWall((1.0, 0.0), restitution=0.0),
        ForceFunction(0, lambda t, place, velocity: (0.0, -answer["c"] / R)),
    )
    disc = Body(M, (R, R), (0.0, 0.0), radius=R, spin=n, inertia=M * R**2 / 2)
    rim = Body(M / 2, (0.0,), (n * R,))
    rubs = ForceFunction(0, lambda t, place, velocity: (-answer["c"] / R,))
    return [
        simulate(Scene((disc,), corner, until=t / 2), spins=(n / 2,), energy=answer["a"] / 4),
        simulate(Scene((rim,), (rubs,), until=t), velocities=(0.0,), trajectory=(2 * pi * R * answer["b"],)),
    ]
