"""A bucket on a drum: one falls, the other turns."""

from corollary.author import simulate
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import ForceFunction, Weight
from corollary.scenes.scene import Body, Scene


def scene(M, m, R, h, g, answer):
    """A roll with the bucket's mass and the drum's moment of inertia, which unrolls down a rough wall: what grips is the rope.

    And the bucket alone, under its weight and the tension.
    """
    w, v = answer["c"], answer["c"] * R
    falls = v / answer["a"]
    roll = Body(m, (R, 0.0), (0.0, 0.0), radius=R, inertia=M * R**2 / 2)
    wall = HardWall((1.0, 0.0), restitution=0.0, mu=1.0)
    pressed = ForceFunction(0, lambda t, place, velocity: (-2 * m * g, 0.0))
    net = ForceFunction(0, lambda t, place, velocity: (answer["b"] - m * g,))
    return [
        simulate(
            Scene((roll,), (Weight(g), wall, pressed), until=falls),
            velocities=(0.0, -v),
            spins=(-w,),
            trajectory=(R, -h),
        ),
        simulate(Scene((Body(m, (0.0,), (0.0,)),), (net,), until=falls), velocities=(-v,), trajectory=(-h,)),
    ]
