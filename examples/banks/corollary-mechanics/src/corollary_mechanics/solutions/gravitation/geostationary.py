"""Always above the same place: the period gives the orbit."""

from corollary.author import simulate
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def scene(T, M, R, G, answer):
    """A quarter of a revolution about a planet that is held, under an inverse square."""
    r, v = R + answer["a"], answer["b"]
    planet, satellite = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(1.0, (r, 0.0), (0.0, v))
    quarter = Scene((planet, satellite), (InverseSquare((0, 1), G * M),), until=T / 4)
    return [simulate(quarter, trajectory=(0.0, 0.0, 0.0, r), velocities=(0.0, 0.0, -v, 0.0))]
