"""On board a space station: gravitation is there, and turns the velocity."""

from corollary.author import simulate
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def scene(h, m, M, R, G, answer):
    """Bodies that attract each other, in thousands of kilometres: a quarter of an orbit later it stands at right angles."""
    r, v, T = R + h, answer["b"], answer["c"]
    earth, ship = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(m, (r, 0.0), (0.0, v))
    quarter = Scene((earth, ship), (InverseSquare((0, 1), answer["a"] * r**2),), until=T / 4)
    return [simulate(quarter, trajectory=(0.0, 0.0, 0.0, r), velocities=(0.0, 0.0, -v, 0.0))]
