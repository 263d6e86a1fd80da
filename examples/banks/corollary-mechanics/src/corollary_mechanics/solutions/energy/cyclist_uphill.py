"""Uphill by bike: against gravity and drag, at steady speed."""

from math import sqrt

from corollary.author import simulate
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def scene(m, v, s, D, h, g, answer):
    """The road is a plane that leans; driven with the power, and with the force, the bike keeps its speed over a thousandth of the way.

    A gain in height on a metre of road is a sine, which is how the statement means it.
    """
    across, up = (-s, sqrt(1 - s**2)), (sqrt(1 - s**2), s)
    bike = Body(m, (0.0, 0.0), (v * up[0], v * up[1]))
    road = HardWall(across, restitution=0.0)
    drag = ForceFunction(0, lambda t, place, velocity: (-D * up[0], -D * up[1]))

    def by_power(t, place, velocity):
        drive = answer["b"] / (velocity[0] * up[0] + velocity[1] * up[1])
        return drive * up[0], drive * up[1]

    def by_force(t, place, velocity):
        return answer["a"] * up[0], answer["a"] * up[1]

    return [
        simulate(
            Scene(
                (bike,),
                (Weight(g), road, drag, ForceFunction(0, drive)),
                until=answer["c"] / answer["b"] / 1000,
            ),
            velocities=bike.velocity,
            trajectory=(h * up[0] / s / 1000, h / 1000),
        )
        for drive in (by_power, by_force)
    ]
