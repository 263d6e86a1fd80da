"""Stopping a ball: a floor that gives way takes the ball's energy, elastic or not."""

from corollary.author import simulate


def scene(v0, answer, neglected):
    """The ball against a sphere a thousand million times as heavy, with the velocity found; and against one a thousand times as heavy."""
    hit = {"mA": 1.0, "k": 1e9, "eta": 0.0, "dx": -0.08, "dy": 0.0, "vA": (-v0, 0.0)}
    floor, bound = answer["b"], neglected["b"]
    return [
        simulate(
            "spheres",
            hit | {"mB": 1e9, "vB": (floor, 0.0)},
            animated=True,
            neglected=1e-8,
            velocities=(0.0, 0.0, floor, 0.0),
        ),
        simulate(
            "spheres",
            hit | {"mB": 1e3, "vB": (floor + bound, 0.0)},
            neglected=2 * bound / abs(floor),
            velocities=(0.0, 0.0, floor, 0.0),
        ),
    ]
