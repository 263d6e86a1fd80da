"""Off a small planet: potential energy that goes with 1/r."""

from math import acos, sqrt

from corollary.author import simulate
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def scene(R, rho, q, G, answer):
    """Thrown up against an inverse square, until the closed form of a radial fall says that it turns: there it is."""
    r, v = R + answer["c"], q * answer["b"]
    strength = answer["a"] * R**2
    x = R / r
    t = sqrt(r**3 / (2 * strength)) * (sqrt(x * (1 - x)) + acos(sqrt(x)))
    planet, probe = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(1.0, (R, 0.0), (v, 0.0))
    return [
        simulate(
            Scene((planet, probe), (InverseSquare((0, 1), strength),), until=t), trajectory=(0.0, 0.0, r, 0.0)
        )
    ]
