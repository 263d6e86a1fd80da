"""Rolling down: a part of the energy turns the ball."""

from math import cos, sin

from corollary.author import simulate
from corollary.scenes.forces.contact import HardWall
from corollary.scenes.forces.fields import Weight
from corollary.scenes.scene import Body, Scene


def scene(m, theta, L, g, answer):
    """A ball with a radius on a rough wall that leans; it grips, and rolls by itself."""
    v, a, r = answer["a"], answer["b"], 0.05
    normal = (sin(theta), cos(theta))
    ball = Body(m, (r * normal[0], r * normal[1]), (0.0, 0.0), radius=r)
    rough = HardWall(normal, restitution=0.0, mu=0.9)
    return [
        simulate(
            Scene((ball,), (Weight(g), rough), until=v / a),
            velocities=(v * cos(theta), -v * sin(theta)),
            spins=(-v / r,),
        )
    ]
