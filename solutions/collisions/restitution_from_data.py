"""Coefficient of restitution from data: from velocities, from heights, and from the force itself."""

from corollary.author import simulate


def scene(vA0, vB0, vA1, vB1, h0, h1, m, k, c, answer):
    """The ball on its bumper, from Newton's second law, at 1 m/s."""
    return [
        simulate(
            "ball_on_floor",
            {"m": m, "k": k, "q": 1, "g": 0.0, "R": 0.02, "y0": 0.02, "v0": -1.0, "eta": c},
            rebound_speed=answer["c"],
        )
    ]
