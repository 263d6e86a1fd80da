"""Two gliders on three springs: coupled equations of motion, and the modes in which they swing."""

from math import cos, pi

from corollary.author import simulate
from corollary.scenes.forces.bonds import Spring
from corollary.scenes.scene import Body, Scene


def scene(m, k, c, A, t1, g_n, answer):
    """The same gliders between two walls that never move, followed for the time asked for; and both pulled alike, for half a swing."""
    wall = float("inf")
    bodies = (
        Body(wall, (0.0,), (0.0,)),
        Body(m, (1.0 + A,), (0.0,)),
        Body(m, (2.0,), (0.0,)),
        Body(wall, (3.0,), (0.0,)),
    )
    springs = tuple(Spring((n, n + 1), each, length=1.0) for n, each in enumerate((k, c, k)))
    slow, fast = sorted(answer["d"])
    left = A / 2 * (cos(slow * t1) + cos(fast * t1))
    ends = (0.0, 1.0 + left, 2.0 + answer["e"], 3.0)
    low, high = sorted(answer["f"])
    both = (bodies[0], Body(m, (1.0 + high,), (0.0,)), Body(m, (2.0 + high,), (0.0,)), bodies[3])
    turned = (0.0, 1.0 + low, 2.0 + low, 3.0)
    return [
        simulate(Scene(bodies, springs, until=t1), trajectory=ends),
        simulate(Scene(both, springs, until=pi / slow), trajectory=turned),
    ]
