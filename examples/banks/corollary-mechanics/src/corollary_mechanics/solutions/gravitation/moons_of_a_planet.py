"""Two moons: Kepler's third law, and what stands behind it."""

from math import pi

from corollary.author import simulate
from corollary.scenes.forces.fields import InverseSquare
from corollary.scenes.scene import Body, Scene


def scene(a, T, b, G, answer):
    """A quarter of a revolution of each moon about a planet that is held, under an inverse square."""
    runs = []
    inner = 2 * pi * a / T
    for r, period, v in ((a, T, inner), (b, answer["a"], inner / answer["c"])):
        planet, moon = Body(float("inf"), (0.0, 0.0), (0.0, 0.0)), Body(1.0, (r, 0.0), (0.0, v))
        quarter = Scene((planet, moon), (InverseSquare((0, 1), G * answer["b"]),), until=period / 4)
        runs.append(simulate(quarter, trajectory=(0.0, 0.0, 0.0, r), velocities=(0.0, 0.0, -v, 0.0)))
    return runs
